// What stands behind a dataset in its file.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The last variable's bytes are none of four, for one.
std::string dataset(std::size_t flags) {
  Dataset out;
  set_grid(out, {{3, 5}, 1, 1, false});
  set_field(out, "heights", random_field({3, 5}, 1), {"m", "height"});
  out.set_dimension("flag", static_cast<Index>(flags));
  out.put({"flags", {"flag"}, std::vector<std::int8_t>(flags, 1), {}});
  return encode_netcdf(out);
}

}  // namespace

// Of `cat a.nc b.nc | tool` the second was lost without a word.
TEST_CASE("a second dataset behind the first is refused with its number of bytes, and padding is not",
          "[netcdf][contract]") {
  const std::string path =
      std::filesystem::temp_directory_path() / ("asperity_rest_" + std::to_string(getpid()) + ".nc");
  for (const std::size_t flags : {0u, 1u, 2u, 3u, 4u}) {
    const std::string one = dataset(flags);
    CAPTURE(flags);
    CHECK_NOTHROW(decode_netcdf(one));
    CHECK_NOTHROW(decode_netcdf(one + std::string(1000, '\0')));
    const std::string words = std::to_string(one.size()) + " bytes follow its end";
    CHECK_THROWS_WITH(decode_netcdf(one + one), ContainsSubstring(words));
    CHECK_THROWS_WITH(decode_netcdf(one + "rest"), ContainsSubstring("4 bytes follow its end"));
    std::ofstream(path, std::ios::binary | std::ios::trunc) << one << one;
    CHECK_THROWS_WITH(open_netcdf(path), ContainsSubstring(words));
  }
  std::filesystem::remove(path);
}

TEST_CASE("a second NetCDF-4 file behind the first is refused with its number of bytes",
          "[netcdf][contract]") {
  std::ifstream in(ASPERITY_TEST_DATA "/../corpus/netcdf4/whole", std::ios::binary);
  const std::string one(std::istreambuf_iterator<char>(in), {});
  REQUIRE(one.size() > 100);
  CHECK_NOTHROW(decode_netcdf(one));
  CHECK_NOTHROW(decode_netcdf(one + std::string(100, '\0')));
  CHECK_THROWS_WITH(decode_netcdf(one + one),
                    ContainsSubstring(std::to_string(one.size()) + " bytes follow"));
}
