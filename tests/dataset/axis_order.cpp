#include "dataset/axis_order.hpp"

#include <filesystem>
#include <fstream>

#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// More than a block along each side, and a rest.
constexpr Grid grid{{35, 70}, 0.5, 0.25, false};
const std::vector<double> depths{0, 0.1, 0.4};

Dataset surface() {
  Dataset out;
  set_grid(out, grid);
  set_field(out, "heights", random_field(grid.shape, 1), {"m", "height"});
  std::vector<std::int8_t> mask(static_cast<std::size_t>(grid.shape.cells()), 0);
  mask[71] = 1;  // (1, 1)
  mask[69] = 1;  // (0, 69)
  set_flags(out, "mask", mask, "missing points", "present missing");
  return out;
}

// Every value says where it stands.
double stress(Index k, Index i, Index j) { return static_cast<double>(10000 * k + 100 * i + j); }

Dataset body() {
  Dataset out = surface();
  set_depths(out, depths);
  std::vector<double> values;
  for (Index k = 0; k < 3; ++k)
    for (Index i = 0; i < grid.shape.nx; ++i)
      for (Index j = 0; j < grid.shape.ny; ++j) values.push_back(stress(k, i, j));
  set_volume(out, "von_mises", values, {"Pa", "stress"});
  values.resize(static_cast<std::size_t>(3 * grid.shape.nx));
  out.put({"section", {"z", "x"}, values, {}});
  set_table(out, "kernel", random_field({3, 4}, 2), {"k"}, {"l"}, {"1", "kernel"});
  return out;
}

double at(const Dataset& data, const char* name, Index place) {
  return std::get<std::vector<double>>(data.at(name).values)[static_cast<std::size_t>(place)];
}

}  // namespace

TEST_CASE("in the order of viewers a volume lies on (z, y, x), its lowest layer first, and z is a height",
          "[axes][exact]") {
  const Dataset data = to_viewer_axes(body());
  const auto [nx, ny] = grid.shape;
  CHECK(data.at("von_mises").dimensions == std::vector<std::string>{"z", "y", "x"});
  CHECK(data.at("heights").dimensions == std::vector<std::string>{"y", "x"});
  CHECK(data.at("mask").dimensions == std::vector<std::string>{"y", "x"});
  CHECK(data.at("section").dimensions == std::vector<std::string>{"z", "x"});
  CHECK(data.at("z").values == Values(std::vector<double>{-0.4, -0.1, 0}));
  CHECK(!std::signbit(at(data, "z", 2)));
  CHECK(data.at("z").attributes.text("positive") == "up");
  CHECK(data.at("x").attributes.find("axis") == nullptr);
  CHECK(*data.at("z").attributes.find("actual_range") == Values(std::vector<double>{-0.4, 0}));
  for (Index k = 0; k < 3; ++k)
    for (Index i = 0; i < nx; ++i) {
      for (Index j = 0; j < ny; ++j)
        if (at(data, "von_mises", i + nx * (j + ny * k)) != stress(2 - k, i, j)) FAIL(k << i << j);
      CHECK(at(data, "section", i + nx * k) == at(body(), "section", i + nx * (2 - k)));
    }
}

TEST_CASE("a dataset comes back from the order of viewers the same in every byte", "[axes][exact]") {
  for (const Dataset& data : {surface(), body()}) {
    const std::string bytes = encode_netcdf(data);
    CHECK(encode_netcdf(decode_netcdf(encode_netcdf(to_viewer_axes(data)))) == bytes);
    CHECK(encode_netcdf(to_native_axes(data)) == bytes);
  }
}

TEST_CASE("heights(y, x) of any program are read by rows as they are read whole", "[axes][exact]") {
  const std::string path =
      std::filesystem::temp_directory_path() / ("asperity_axes_" + std::to_string(getpid()) + ".nc");
  std::ofstream(path, std::ios::binary) << encode_netcdf(to_viewer_axes(surface()));
  const Dataset file = open_netcdf(path);
  const Field whole = field_of(surface(), "heights", Missing::not_a_number);
  const auto equal = [](const Field& a, const Field& b) {
    return (a == b || (a.isNaN() && b.isNaN())).all();
  };
  for (const Extent rows : {Extent{0, 35}, Extent{1, 2}})
    CHECK(equal(field_of(file, "heights", "m", rows, Missing::not_a_number),
                whole.middleRows(rows.first, rows.count)));
  std::filesystem::remove(path);
}

TEST_CASE("a height in whole numbers becomes a depth, and names of other axes stay as they are",
          "[axes][exact]") {
  Dataset data;
  data.dimensions = {{"z", 2}, {"row", 3}, {"column", 2}};
  data.variables.push_back({"z", {"z"}, std::vector<std::uint8_t>{0, 3}, {}});
  data.variables.back().attributes.set("positive", "up");
  data.variables.push_back({"v", {"z"}, std::vector<float>{1, 2}, {}});
  data.variables.push_back({"table", {"row", "column"}, std::vector<float>{1, 2, 3, 4, 5, 6}, {}});
  const Dataset own = to_native_axes(data);
  CHECK(own.at("z").values == Values(std::vector<double>{-3, 0}));
  CHECK(own.at("v").values == Values(std::vector<float>{2, 1}));
  CHECK(own.at("table").values == data.at("table").values);
}
