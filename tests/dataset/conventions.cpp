// What a foreign file says of its values: packed numbers, marks, ranges, signs.
#include "dataset/conventions.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "core/error.hpp"
#include "dataset/axis_order.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr Grid grid{{3, 4}, 1e-6, 2e-6, false};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class T>
using Twelve = std::vector<T>;

// A surface as another program packs it.
Dataset surface(Values values, const Attributes& attributes = {}) {
  Dataset out;
  set_grid(out, grid);
  Variable heights{"heights", {"x", "y"}, std::move(values), attributes};
  heights.attributes.set("units", "m");
  out.put(std::move(heights));
  return out;
}

template <class T>
Attributes with(const char* name, std::vector<T> values, Attributes out = {}) {
  out.set_values(name, Values(std::move(values)));
  return out;
}

std::vector<double> read(const Dataset& data) {
  const Field z = field_of(decode_netcdf(encode_netcdf(data)), "heights", Missing::not_a_number);
  return {z.data(), z.data() + z.size()};
}

void check_equal(const std::vector<double>& found, const std::vector<double>& exact, double tolerance = 0) {
  REQUIRE(found.size() == exact.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i, found[i], exact[i]);
    if (std::isnan(exact[i]))
      CHECK(std::isnan(found[i]));
    else
      CHECK(std::abs(found[i] - exact[i]) <= tolerance * std::abs(exact[i]));
  }
}

const Twelve<std::int16_t> shorts{0, 1, -2, 300, -400, 5, 6, -7, 8, 9, -32767, 32767};

}  // namespace

// They were read as so many metres. One product and one sum: 2 ε of the larger of the two.
TEST_CASE("packed heights are scaled and shifted, and their marks are not", "[conventions][exact]") {
  const Attributes packing = with<double>("add_offset", {5e-7}, with<double>("scale_factor", {1e-9}));
  std::vector<double> exact;
  for (const std::int16_t v : shorts) exact.push_back(v == -32767 ? none : v * 1e-9 + 5e-7);
  check_equal(read(surface(shorts, packing)), exact, 4 * epsilon * 65);
  exact[3] = none;
  exact[10] = -32767e-9 + 5e-7;
  check_equal(read(surface(shorts, with<std::int16_t>("_FillValue", {300}, packing))), exact,
              4 * epsilon * 65);
}

// The default fill 9.97e36 of what was never written was a height.
TEST_CASE("what was never written is missing, of every type but bytes", "[conventions][exact]") {
  const double fill = default_fill;
  check_equal(read(surface(Twelve<double>{fill, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})),
              {none, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  check_equal(read(surface(Twelve<float>{static_cast<float>(fill), 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})),
              {none, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  check_equal(read(surface(Twelve<std::int32_t>{-2147483647, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})),
              {none, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  check_equal(read(surface(Twelve<std::uint16_t>{65535, 65534, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})),
              {none, 65534, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  check_equal(read(surface(Twelve<std::int8_t>{-127, -128, 127, 3, 4, 5, 6, 7, 8, 9, 10, 11})),
              {-127, -128, 127, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  // one that is told is the only one
  check_equal(
      read(surface(Twelve<double>{fill, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, with<double>("_FillValue", {3}))),
      {fill, 1, 2, none, 4, 5, 6, 7, 8, 9, 10, 11});
  Dataset never = decode_netcdf(encode_netcdf(surface(Twelve<double>(12, fill))));
  CHECK_THROWS_WITH(field_of(never, "heights"), ContainsSubstring("12 points missing (never written)"));
}

TEST_CASE("a list of missing values marks all of them, and one mark is left in the dataset",
          "[conventions][exact]") {
  const Dataset data =
      decode_netcdf(encode_netcdf(surface(shorts, with<std::int16_t>("missing_value", {300, -400, 5}))));
  const Variable& heights = data.at("heights");
  CHECK(heights.values == Values(Twelve<std::int16_t>{0, 1, -2, 300, 300, 300, 6, -7, 8, 9, 300, 32767}));
  CHECK(*heights.attributes.find("missing_value") == Values(std::vector<std::int16_t>{300}));
  CHECK(!heights.attributes.find("_FillValue"));
  CHECK(present_numbers(heights)[1] == 1);
  CHECK(std::isnan(present_numbers(heights)[4]));
  // a mark of another type than the values, as SciPy writes it
  check_equal(read(surface(Twelve<float>{0.1F, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 1e20F},
                           with<double>("missing_value", {0.1, 1e20}))),
              {none, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, none});
}

// Of single precision: 0.1 as a double is not the 0.1 that stands there.
TEST_CASE("what lies outside the valid range is missing, the bounds are not", "[conventions][exact]") {
  const Twelve<float> values{0.1F, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  const std::vector<double> exact{static_cast<double>(0.1F), 1, 2, 3, 4, 5, 6, none, none, none, none, none};
  check_equal(read(surface(values, with<double>("valid_range", {0.1, 6}))), exact);
  check_equal(read(surface(values, with<double>("valid_min", {0.1}, with<float>("valid_max", {6})))), exact);
  check_equal(read(surface(values, with<double>("valid_max", {6}))), exact);
  // of packed numbers
  const Attributes packed = with<double>("scale_factor", {0.5}, with<std::int16_t>("valid_range", {-7, 8}));
  check_equal(read(surface(shorts, packed)), {0, 0.5, -1, none, none, 2.5, 3, -3.5, 4, none, none, none});
  // bytes have no number to spare
  check_equal(read(surface(Twelve<std::int8_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
                           with<std::int8_t>("valid_max", {10}))),
              {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, none});
}

TEST_CASE("numbers that are meant without a sign are read so, and their marks with them",
          "[conventions][exact]") {
  Attributes attributes = with<std::int16_t>("_FillValue", {-2}, with<double>("scale_factor", {2.0}));
  attributes.set("_Unsigned", "true");
  check_equal(read(surface(Twelve<std::int16_t>{0, -1, -2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, attributes)),
              {0, 131070, none, 6, 8, 10, 12, 14, 16, 18, 20, 22});
  attributes = with<std::int8_t>("valid_range", {0, -6});
  attributes.set("_Unsigned", "true");
  check_equal(read(surface(Twelve<std::int8_t>{0, -1, -6, 3, 4, 5, 6, 7, 8, 9, 10, 11}, attributes)),
              {0, none, 250, 3, 4, 5, 6, 7, 8, 9, 10, 11});
}

TEST_CASE("coordinates and masks are unpacked as fields are", "[conventions][exact]") {
  Dataset data = surface(Twelve<double>(12, 1e-6));
  Variable& x = *data.find("x");
  x.values = std::vector<std::int16_t>{10, 20, 30};
  x.attributes = with<double>("scale_factor", {1e-7});
  x.attributes.set("units", "m");
  data.put({"mask",
            {"x", "y"},
            Twelve<std::int8_t>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
            with<std::int8_t>("add_offset", {-1})});
  const Dataset back = decode_netcdf(encode_netcdf(data));
  CHECK(relative_error(grid_of(back).dx, 1e-6) <= 4 * epsilon);
  const Field z = field_of(back, "heights", Missing::not_a_number);
  CHECK(z(0, 0) == 1e-6);
  CHECK(z.isNaN().count() == 11);
  x.attributes.set_values("_FillValue", std::vector<std::int16_t>{20});
  CHECK_THROWS_WITH(grid_of(decode_netcdf(encode_netcdf(data))),
                    ContainsSubstring("a coordinate is missing"));
}

TEST_CASE("after reading nothing is packed any more, and the range is that of the values",
          "[conventions][exact]") {
  Attributes attributes = with<double>("scale_factor", {0.5}, with<std::int16_t>("valid_range", {-7, 8}));
  attributes.set_values("actual_range", std::vector<double>{-1e9, 1e9});
  attributes.set("comment", "kept");
  const std::string once = encode_netcdf(decode_netcdf(encode_netcdf(surface(shorts, attributes))));
  const Dataset data = decode_netcdf(once);
  for (const char* gone : {"scale_factor", "valid_range"}) CHECK(!data.at("heights").attributes.find(gone));
  CHECK(*data.at("heights").attributes.find("actual_range") == Values(std::vector<double>{-3.5, 4}));
  CHECK(data.at("heights").attributes.text("comment") == "kept");
  CHECK(encode_netcdf(data) == once);
}

TEST_CASE("a dataset that says nothing of that kind passes to the last byte", "[conventions][exact]") {
  Dataset data = surface(Twelve<float>{9.96921e36F, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11});
  data.find("heights")->attributes.set_values("_FillValue", std::vector<float>{-1});
  data.put({"of_a_user", {"y"}, std::vector<std::int32_t>{-2147483647, 1, 2, 3}, {}});
  data.put({"label", {"y"}, std::string("abcd"), with<double>("scale_factor", {2})});  // text is not packed
  const std::string bytes = encode_netcdf(data);
  CHECK(encode_netcdf(decode_netcdf(bytes)) == bytes);
}

TEST_CASE("what cannot be understood is refused by the variable and the attribute",
          "[conventions][contract]") {
  Attributes text;
  text.set("scale_factor", "0.1");
  Attributes mark;
  mark.set("missing_value", "nothing");
  Attributes sign;
  sign.set("_Unsigned", 1.0);
  const std::pair<Attributes, const char*> cases[] = {
      {text, "attribute scale_factor is text"},
      {mark, "attribute missing_value is text"},
      {sign, "attribute _Unsigned is not true or false"},
      {with<double>("scale_factor", {0}), "attribute scale_factor is 0"},
      {with<double>("scale_factor", {none}), "attribute scale_factor is nan"},
      {with<double>("scale_factor", {1, 2}), "attribute scale_factor is a list of 2 numbers"},
      {with<double>("add_offset", {HUGE_VAL}), "attribute add_offset is inf"},
      {with<double>("valid_min", {2}, with<double>("valid_max", {1})), "2 to 1, which is empty"},
      {with<double>("valid_range", {none, 1}), "which is empty"},
      {with<double>("valid_range", {1}), "a list of 1 numbers instead of 2"},
      {with<double>("valid_range", {0, 1}, with<double>("scale_factor", {2})), "CF needs it in the packed"},
  };
  for (const auto& [attributes, words] : cases) {
    CAPTURE(words);
    try {
      decode_netcdf(encode_netcdf(surface(shorts, attributes)));
      FAIL("read");
    } catch (const DataError& e) {
      CHECK(e.name == "heights");
      CHECK_THAT(e.what(), ContainsSubstring(words));
    }
  }
}

// The values that stay in the file were read as they stand there.
TEST_CASE("packed heights are read by rows as they are read whole, in either order, up or down",
          "[conventions][exact]") {
  const std::string path =
      std::filesystem::temp_directory_path() / ("asperity_packed_" + std::to_string(getpid()) + ".nc");
  const auto same = [](const Field& a, const Field& b) {
    return a.rows() == b.rows() && a.cols() == b.cols() && (a == b || (a.isNaN() && b.isNaN())).all();
  };
  for (const bool transposed : {false, true})
    for (const std::string turned : {"", "x", "y", "xy"}) {
      CAPTURE(transposed, turned);
      Attributes attributes = with<double>("scale_factor", {1e-9}, with<std::int16_t>("valid_max", {300}));
      attributes.set_values("missing_value", std::vector<std::int16_t>{6, 8});
      Dataset data = surface(shorts, attributes);
      data.put({"mask", {"x", "y"}, Twelve<std::int8_t>{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {}});
      if (transposed) data = to_viewer_axes(std::move(data));
      for (const char axis : turned) {
        auto& points = std::get<std::vector<double>>(data.find(std::string(1, axis))->values);
        std::ranges::reverse(points);
      }
      const std::string bytes = encode_netcdf(data);
      std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
      const Dataset file = open_netcdf(path);
      const Field whole = field_of(decode_netcdf(bytes), "heights", Missing::not_a_number);
      CHECK(whole.isNaN().count() == 5);
      for (Index first = 0; first < 3; ++first)
        for (Index rows = 1; first + rows <= 3; ++rows)
          CHECK(same(field_of(file, "heights", "m", Extent{first, rows}, Missing::not_a_number),
                     whole.middleRows(first, rows)));
    }
  std::filesystem::remove(path);
}
