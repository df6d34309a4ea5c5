// What a dataset takes is known from its head.
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Index side = 100;
constexpr std::size_t field = sizeof(double) * side * side, axes = 2 * sizeof(double) * side;

Dataset surface() {
  Dataset out;
  set_grid(out, {{side, side}, 1e-6, 1e-6});
  set_field(out, "heights", random_field({side, side}, 3), {"m", "height"});
  return out;
}

std::string content(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

}  // namespace

// The values, and the largest variable as doubles.
TEST_CASE("a dataset that takes more memory than is allowed is refused, and says how much",
          "[netcdf][memory][contract]") {
  const std::string bytes = encode_netcdf(surface());
  CHECK_NOTHROW(decode_netcdf(bytes, {2 * field + axes}));
  CHECK_THROWS_WITH(decode_netcdf(bytes, {2 * field + axes - 1}),
                    ContainsSubstring("reading needs 1MB, the memory limit is 1MB: raise `memory`"));
  CHECK_THROWS_AS(decode_netcdf(bytes, {2 * field + axes + 7, 8}), DataError);
}

// 60 s and more for the 2 MB of 100 000 attributes: each was looked for among all before it.
TEST_CASE("a head that lists more than there can be of a kind is refused before its names are compared",
          "[netcdf][contract][slow]") {
  Dataset data = surface();
  Variable& heights = *data.find("heights");
  for (int k = static_cast<int>(heights.attributes.size()); k < 8192; ++k)
    heights.attributes.set("a" + std::to_string(k), k);
  std::string bytes = encode_netcdf(data);
  CHECK(decode_netcdf(bytes).at("heights").attributes.size() == 8192);
  const std::size_t list = bytes.find(std::string("\0\0\0\f\0\0 \0", 8));  // of attributes, and their number
  REQUIRE(list != bytes.npos);
  bytes[list + 7] = 1;
  CHECK_THROWS_WITH(decode_netcdf(bytes), ContainsSubstring("has 8193 attributes"));
  heights.attributes.set("one more", 1);
  CHECK_THROWS_AS(encode_netcdf(data), DataError);  // rather than what nobody reads
}

// 8 × 6 heights and their axes.
TEST_CASE("a NetCDF-4 file that takes more memory than is allowed is refused", "[netcdf][memory][contract]") {
  const std::string bytes = content(ASPERITY_TEST_DATA "/../corpus/netcdf4/whole");
  CHECK_NOTHROW(decode_netcdf(bytes, {100'000}));
  CHECK_THROWS_WITH(decode_netcdf(bytes, {100}), ContainsSubstring("raise `memory`"));
}
