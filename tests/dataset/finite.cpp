// What a dataset is given is finite, and its header does not depend on how large it is.
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 infinite = std::numeric_limits<double>::infinity();

template <class Deed>
std::string refused(Deed deed) {
  try {
    deed();
    return "";
  } catch (const DataError& error) {
    return error.name;
  }
}

}  // namespace

TEST_CASE("a result that is not finite does not get into a dataset, unless it stands for a missing one",
          "[dataset][contract]") {
  Dataset data;
  set_grid(data, {{3, 2}, 1e-6, 1e-6, false});
  for (const double bad : {no_number, infinite, -infinite}) {
    Field field = Field::Ones(3, 2);
    field(2, 1) = bad;
    CAPTURE(bad);
    CHECK(refused([&] { set_field(data, "gap", field, {"m", "gap"}); }) == "gap");
    CHECK(refused([&] { set_volume(data, "gap", {1, bad}, {"m", "gap"}); }) == "gap");
    CHECK(refused([&] { set_depths(data, {0, bad}); }) == "z");
    CHECK(refused([&] { set_scalar(data, "place", bad, {"m", "place"}); }) == "place");
    CHECK(refused([&] { defer_values(data, "gap", {"x", "y"}, {1, bad}, {"m", "gap"}); }) == "gap");
    CHECK(refused([&] { data.attributes.set("contact_load", bad); }) == "contact_load");
    CHECK(refused([&] { data.attributes.set("contact_stiffness", bad); }).empty());
    CHECK(refused([&] {
            set_table(data, "acf", field, {"p"}, {"q"}, {"1", "table"}, Missing::not_a_number);
          }) == (std::isnan(bad) ? "" : "acf"));
  }
  CHECK_FALSE(data.has("gap"));
}

// A last variable of 3e9 doubles: the head is there in no more memory and file than it takes itself.
TEST_CASE("the head of a dataset beyond memory is read back with its sizes", "[dataset][exact]") {
  Dataset data;
  data.dimensions = {{"n", 5}, {"z", 600'000'000}};
  data.put({"bytes", {"n"}, std::vector<std::int8_t>{1, 2, 3, 4, 5}, {}});
  data.put({"volume", {"z", "n"}, std::vector<double>{}, {}});
  const std::string head = encode_netcdf(data, 1);
  auto number = [&](std::size_t at, std::size_t width) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < width; ++i) out = out << 8 | static_cast<unsigned char>(head[at + i]);
    return out;
  };
  // magic, records; tag, count; "n" and its length, "z" and its length
  CHECK(head.starts_with("CDF\002"));
  CHECK(number(16 + 8, 4) == 5);
  CHECK(number(16 + 20, 4) == 600'000'000);
  // The volume begins behind the five bytes and their padding, and is larger than 32 bits tell.
  CHECK(number(head.size() - 8 - 8, 8) == head.size());
  CHECK(number(head.size() - 8 - 12, 4) == 0xffffffff);
  data.dimensions[1].length = 2;
  data.variables[1].values = std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const Dataset back = decode_netcdf(encode_netcdf(data));
  CHECK(back.at("volume").values == data.at("volume").values);
  CHECK(back.at("bytes").values == data.at("bytes").values);
}
