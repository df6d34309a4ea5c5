// Coordinates that run downwards, as of pictures.
#include "dataset/axis_order.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Grid grid{{5, 4}, 0.5, 0.25, true};

Dataset whole() {
  Dataset out;
  set_grid(out, grid);
  set_field(out, "heights", random_field(grid.shape, 1), {"m", "height"});
  set_depths(out, {0, 0.1, 0.4});
  std::vector<double> volume;
  for (int i = 0; i < 60; ++i) volume.push_back(i);
  set_volume(out, "von_mises", volume, {"Pa", "stress"});
  out.put({"profile", {"y"}, std::vector<float>{1, 2, 3, 4}, {}});
  out.put({"pairs",
           {"y", "y"},
           std::vector<std::int16_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15},
           {}});
  set_table(out, "acf", random_field({3, 5}, 2), {"lag_x", 0, 0.5, "m"}, {"lag_y", -2, 0.25, "m"},
            {"m2", "acf"});
  return out;
}

// As ds.isel(name=slice(None, None, -1)) of xarray makes it: by hand, index by index.
Dataset turned(const Dataset& data, const std::string& name) {
  Dataset out = data;
  for (Variable& v : out.variables) {
    std::vector<Index> lengths;
    Index size = 1;
    for (const std::string& d : v.dimensions) size *= lengths.emplace_back(data.length(d));
    std::visit(
        [&](auto& values) {
          const auto before = values;
          for (Index at = 0; at < size; ++at) {
            Index rest = at, from = 0, stride = 1;
            for (std::size_t d = lengths.size(); d-- > 0; stride *= lengths[d], rest /= lengths[d]) {
              const Index i =
                  v.dimensions[d] == name ? lengths[d] - 1 - rest % lengths[d] : rest % lengths[d];
              from += i * stride;
              if (d == 0) break;
            }
            values[static_cast<std::size_t>(at)] = before[static_cast<std::size_t>(from)];
          }
        },
        v.values);
  }
  return out;
}

}  // namespace

// Descending coordinates were taken for ascending ones: a mirrored lay, stress_max_x of the wrong sign.
TEST_CASE("whatever lies on a coordinate that descends is turned around with it, and history says so",
          "[axes][exact]") {
  const Dataset data = whole();
  REQUIRE(decode_netcdf(encode_netcdf(data)).notes.empty());
  for (const char* name : {"x", "y", "z", "lag_x", "lag_y"}) {
    CAPTURE(name);
    Dataset back = decode_netcdf(encode_netcdf(turned(data, name)));
    const std::string line =
        "descending coordinate " + std::string(name) + " reversed, with all values on it";
    CHECK(back.attributes.text("history") == line);
    CHECK(back.notes == std::vector{line});
    back.attributes.erase("history");
    CHECK(encode_netcdf(back) == encode_netcdf(data));
  }
  const Dataset both = decode_netcdf(encode_netcdf(to_viewer_axes(turned(turned(data, "y"), "x"))));
  CHECK((field_of(both, "heights") == field_of(data, "heights")).all());
  CHECK(grid_of(both).periodic.both());
  CHECK(both.notes ==
        std::vector<std::string>{"descending coordinates x, y reversed, with all values on them"});
}

TEST_CASE("a z that is not said to be a depth is not turned, and one above the surface is refused",
          "[axes][contract]") {
  Dataset data = turned(whole(), "z");
  data.find("z")->attributes.erase("positive");
  const Dataset back = decode_netcdf(encode_netcdf(data));
  CHECK(back.at("z").values == data.at("z").values);
  data.find("z")->values = std::vector<double>{-0.4, -0.1, 0};
  CHECK_THROWS_WITH(depths_of(data), ContainsSubstring("is above the surface"));
}
