#include "dataset/layout.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

#include "core/error.hpp"
#include "dataset/netcdf.hpp"
#include "dataset/units.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const Grid grid{{6, 4}, 0.5e-6, 2e-6, false};

Dataset with_heights(const Field& heights) {
  Dataset out;
  set_grid(out, grid);
  set_field(out, "heights", heights, {"m", "surface height"});
  return out;
}

std::string file(const std::string& name) {
  std::ifstream in(ASPERITY_TEST_DATA "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a grid and a field come back through the bytes to the last bit", "[layout][exact]") {
  const Field heights = random_field(grid.shape, 1);
  const Dataset back = decode_netcdf(encode_netcdf(with_heights(heights)));
  CHECK((field_of(back, "heights") == heights).all());
  CHECK(grid_of(back).shape == grid.shape);
  CHECK(relative_error(grid_of(back).dx, grid.dx) <= epsilon);
  CHECK(relative_error(grid_of(back).dy, grid.dy) <= epsilon);
  CHECK_FALSE(grid_of(back).periodic.both());
}

// The file says: 5 nm × 10 nm, 5 × 10 points, heights in nm; the first row falls from 9.
TEST_CASE("a file of contact.engineering is read in metres", "[layout][exact]") {
  const Dataset data = decode_netcdf(file("contact-engineering-5x10.nc"));
  const Grid g = grid_of(data);
  CHECK(g.shape == Shape{5, 10});
  CHECK(relative_error(g.size_x(), 5e-9) <= 4 * epsilon);
  CHECK(relative_error(g.size_y(), 10e-9) <= 4 * epsilon);
  CHECK(relative_error(field_of(data, "heights")(0, 0), 9e-9) <= 4 * epsilon);
}

TEST_CASE("x and y carry what contact.engineering and CF ask for", "[layout][contract]") {
  const Dataset data = with_heights(random_field(grid.shape, 2));
  for (const char* axis : {"x", "y"}) {
    const Attributes& a = data.at(axis).attributes;
    CHECK(a.text("unit") == "m");
    CHECK(a.text("units") == "m");
    CHECK(a.number("periodic", -1) == 0);
  }
  CHECK(data.at("x").attributes.number("length", 0) == grid.size_x());
  CHECK(data.at("x").attributes.text("axis") == "X");
  CHECK(data.at("heights").attributes.text("unit") == "m");
}

TEST_CASE("actual_range is the least and the largest height", "[layout][exact]") {
  const Field heights = random_field(grid.shape, 3);
  const std::vector<double> range =
      numbers(*with_heights(heights).at("heights").attributes.find("actual_range"));
  CHECK(range == std::vector<double>{heights.minCoeff(), heights.maxCoeff()});
}

TEST_CASE("a new grid of another shape drops what stood on the old one, and nothing else",
          "[layout][contract]") {
  Dataset data = with_heights(random_field(grid.shape, 4));
  set_table(data, "kernel", Field::Ones(3, 3), {"k"}, {"l"}, {"1", "kernel"});
  set_grid(data, {{8, 4}, 1e-6, 1e-6, true});
  CHECK_FALSE(data.has("heights"));
  CHECK(data.has("kernel"));
  CHECK(grid_of(data).periodic.both());
}

TEST_CASE("a height that is not finite is refused by its place", "[layout][contract]") {
  for (double bad : {std::nan(""), HUGE_VAL}) {
    Dataset data = with_heights(random_field(grid.shape, 5));
    // As a file may hold it: set_field refuses it.
    std::get<std::vector<double>>(
        data.find("heights")->values)[static_cast<std::size_t>(2 * grid.shape.ny + 3)] = bad;
    CHECK_THROWS_WITH(field_of(data, "heights"), ContainsSubstring("(2, 3)"));
    CHECK_THROWS_WITH(field_of(data, "heights", "m", Extent{1, 2}), ContainsSubstring("(2, 3)"));
    CHECK_NOTHROW(field_of(data, "heights", "m", Extent{0, 2}));
  }
}

TEST_CASE("masked points are refused and an empty mask is not", "[layout][contract]") {
  Dataset data = with_heights(random_field(grid.shape, 6));
  std::vector<std::int8_t> mask(24, 0);
  set_flags(data, "mask", mask, "missing points", "present missing");
  CHECK_NOTHROW(field_of(data, "heights"));
  mask[5] = 1;
  set_flags(data, "mask", mask, "missing points", "present missing");
  mask[23] = 1;
  set_flags(data, "mask", mask, "missing points", "present missing");
  for (const Extent rows : {Extent{0, grid.shape.nx}, Extent{0, 2}, Extent{5, 1}})
    CHECK_THROWS_WITH(field_of(data, "heights", "m", rows), ContainsSubstring("2 points masked"));
  CHECK_NOTHROW(field_of(data, "heights", "m", Extent{2, 3}));
}

TEST_CASE("points with the value that _FillValue or missing_value names are refused, in a file's own units",
          "[layout][contract]") {
  for (const char* mark : {"_FillValue", "missing_value"}) {
    Dataset data = with_heights(random_field(grid.shape, 4));
    data.find("heights")->attributes.set("units", "nm");
    data.find("heights")->attributes.set(mark, -9999.0);
    CHECK_NOTHROW(field_of(data, "heights"));
    std::get<std::vector<double>>(data.find("heights")->values)[5] = -9999;
    CHECK_THROWS_AS(field_of(data, "heights"), DataError);
  }
}

TEST_CASE("heights of any name are read in metres, and must be a length", "[layout][exact]") {
  Dataset data = with_heights(random_field(grid.shape, 5));
  set_field(data, "heights_residual", 1e6 * field_of(data, "heights"), {"um", "heights left"});
  const Field read = field_of(data, "heights_residual", "m"), exact = field_of(data, "heights");
  CHECK((read - exact).abs().maxCoeff() <= 4 * epsilon * exact.abs().maxCoeff());
  data.find("heights_residual")->attributes.set("units", "Pa");
  CHECK_THROWS_AS(field_of(data, "heights_residual", "m"), DataError);
}

TEST_CASE("points that are not evenly spaced, or have no unit, are refused", "[layout][contract]") {
  Dataset data = with_heights(random_field(grid.shape, 7));
  std::get<std::vector<double>>(data.find("x")->values)[2] += 0.1e-6;
  CHECK_THROWS_AS(grid_of(data), DataError);
  data = with_heights(random_field(grid.shape, 7));
  data.find("y")->attributes.erase("unit");
  data.find("y")->attributes.erase("units");
  CHECK_THROWS_AS(grid_of(data), DataError);
}

TEST_CASE("a length or a period that is text is refused", "[layout][contract]") {
  for (const char* name : {"length", "periodic"}) {
    Dataset data = with_heights(random_field(grid.shape, 7));
    data.find("y")->attributes.set(name, "1");
    CHECK_THROWS_WITH(grid_of(data), ContainsSubstring("is text instead of a number"));
  }
}

TEST_CASE("history has the newest line first", "[layout][contract]") {
  Dataset data;
  add_history(data, "first");
  add_history(data, "second");
  CHECK(data.attributes.text("history") == "second\nfirst");
}

TEST_CASE("depths and volumes come back in their order", "[layout][exact]") {
  Dataset data = with_heights(random_field(grid.shape, 8));
  const std::vector<double> depths{0, 1e-6, 4e-6};
  set_depths(data, depths);
  std::vector<double> values(3 * 24);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
  set_volume(data, "von_mises", values, {"Pa", "von Mises stress"});
  const Dataset back = decode_netcdf(encode_netcdf(data));
  CHECK(depths_of(back) == depths);
  CHECK(numbers(back.at("von_mises").values) == values);
  CHECK(back.at("von_mises").dimensions == std::vector<std::string>{"z", "x", "y"});
  CHECK(back.at("z").attributes.text("positive") == "down");
}

TEST_CASE("units convert by their definition and refuse another dimension", "[units][exact]") {
  CHECK(relative_error(unit_factor("um", "m"), 1e-6) <= epsilon);
  CHECK(relative_error(unit_factor("µm", "m"), 1e-6) <= epsilon);
  CHECK(relative_error(unit_factor("GPa", "Pa"), 1e9) <= epsilon);
  CHECK(relative_error(unit_factor("inch", "m"), 0.0254) <= epsilon);
  CHECK_THROWS_AS(unit_factor("N", "m"), std::invalid_argument);
  CHECK_THROWS_AS(unit_factor("smoot-ish", "m"), std::invalid_argument);
}

TEST_CASE(
    "missing points are NaN where they may be left out, by mask, by attribute or as NaN, and infinity is "
    "refused",
    "[layout][contract]") {
  const Field heights = random_field(grid.shape, 7);
  Dataset data = with_heights(heights);
  std::vector<std::int8_t> mask(24, 0);
  mask[5] = 1;
  set_flags(data, "mask", mask, "missing points", "present missing");
  auto values = [&]() -> std::vector<double>& {
    return std::get<std::vector<double>>(data.find("heights")->values);
  };
  data.find("heights")->attributes.set("_FillValue", -9999.0);
  data.find("heights")->attributes.set("units", "nm");
  values()[7] = -9999;
  values()[9] = std::nan("");
  const Field read = field_of(data, "heights", Missing::not_a_number);
  for (Index k = 0; k < 24; ++k) {
    const double height = read.data()[k];
    CHECK(std::isnan(height) == (k == 5 || k == 7 || k == 9));
    if (!std::isnan(height)) CHECK(relative_error(height, 1e-9 * heights.data()[k]) <= 4 * epsilon);
  }
  values()[11] = HUGE_VAL;
  CHECK_THROWS_AS(field_of(data, "heights", Missing::not_a_number), DataError);
}

TEST_CASE(
    "a field read from its file by rows is the field read whole, its mask, fill value and unit included",
    "[layout][exact]") {
  Dataset data = with_heights(random_field(grid.shape, 8));
  std::vector<std::int8_t> mask(24, 0);
  mask[17] = 1;
  set_flags(data, "mask", mask, "missing points", "present missing");
  data.find("heights")->attributes.set("_FillValue", -9999.0);
  data.find("heights")->attributes.set("units", "nm");
  std::get<std::vector<double>>(data.find("heights")->values)[7] = -9999;
  const std::string path =
      std::filesystem::temp_directory_path() / ("asperity_rows_" + std::to_string(getpid()) + ".nc");
  const std::string bytes = encode_netcdf(data);
  std::ofstream(path, std::ios::binary) << bytes;
  {
    const Dataset file = open_netcdf(path);
    const Field whole = field_of(data, "heights", Missing::not_a_number);
    for (Index first = 0; first < grid.shape.nx; ++first) {
      const Index rows = std::min<Index>(2, grid.shape.nx - first);
      const Field part = field_of(file, "heights", "m", Extent{first, rows}, Missing::not_a_number),
                  same = whole.middleRows(first, rows);
      CHECK((part == same || (part.isNaN() && same.isNaN())).all());
    }
  }
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes.substr(0, bytes.size() - 64);
  CHECK_THROWS_AS(open_netcdf(path), DataError);
  std::filesystem::remove(path);
}

// ---- the length of an axis beside its points ----

// The header said so, and whatever had as many points stayed.
TEST_CASE("other points take away what stood on the former ones, the same ones leave it",
          "[layout][contract]") {
  auto has_after = [](double dx, const std::vector<double>& depths) {
    Dataset data;
    set_grid(data, grid);
    set_field(data, "field", random_field(grid.shape, 1), {"K", "of a user"});
    set_depths(data, {0, 1e-6});
    data.put({"deep", {"z"}, std::vector<double>{1, 2}, {}});
    set_grid(data, {grid.shape, dx, grid.dy, true});
    set_depths(data, depths);
    return std::pair(data.has("field"), data.has("deep"));
  };
  CHECK(has_after(grid.dx, {0, 1e-6}) == std::pair(true, true));
  CHECK(has_after(grid.dx * (1 + 1e-12), {0, 1e-6}) == std::pair(true, true));
  CHECK(has_after(1.1 * grid.dx, {0, 1e-6}) == std::pair(false, true));
  CHECK(has_after(grid.dx, {0, 2e-6}) == std::pair(true, false));
}
