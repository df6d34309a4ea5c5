#include "formats/gwyddion_text.hpp"
#include "formats/text_matrix.hpp"
#include "formats/text_numbers.hpp"
#include "grid/error.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE(
    "numbers are read with a plus, exponents of three digits, decimal commas and words for missing ones",
    "[formats][exact]") {
  CHECK(number_of("1.8823e-008") == 1.8823e-8);
  CHECK(number_of("+2.5") == 2.5);
  CHECK(number_of("-1,5E+003", true) == -1500.0);
  CHECK(number_of("1e-400") == 0.0);
  for (const char* word : {"NaN", "bad", "--"}) CHECK(std::isnan(number_of(word).value()));
  for (const char* word : {"", "1.2.3", "1,5", "0x10", "e5", "1e", "+-1", "n"}) CHECK(!number_of(word));
}

TEST_CASE("a comma is decimal where another separator stands beside it", "[formats][exact]") {
  Field expected(2, 2);
  expected << 1.5, 2, -3.25, 4e-9;
  CHECK(same(matrix_of("1,5\t2\r\n-3,25\t4e-009\r\n", "map"), expected));
  CHECK(same(matrix_of("1,5;2\n-3,25;4e-9", "map"), expected));
  CHECK(same(matrix_of("1.5,2\n-3.25,4e-9\n", "map"), expected));
  CHECK(same(matrix_of("1.5, 2\n\n-3.25, 4e-9\n", "map"), expected));
}

TEST_CASE("a matrix is refused with the line that does not fit", "[formats][contract]") {
  CHECK_THROWS_WITH(matrix_of("1 2\n3\n", "map"), "line 2 has 1 numbers, the first one 2");
  CHECK_THROWS_WITH(matrix_of("1 2\n3 x\n", "map", 5), "line 6, 'x', is no number");
  CHECK_THROWS_WITH(matrix_of("1 inf", "map"), "line 1, 'inf', is infinite");
  CHECK_THROWS_WITH(matrix_of(" \n\n", "map"), "there are no numbers in it");
}

TEST_CASE("a text matrix has a line for each x, or as asked for each y, and may state its unit",
          "[formats][exact]") {
  const Map xy = decode_text_matrix("# a comment 1 2\n# units: nm\n1 2 3\n4 5 6\n", Order::xy);
  CHECK(shape_of(xy.values) == Shape{2, 3});
  CHECK(xy.values(1, 0) == 4e-9);
  CHECK(xy.units == "m");
  const Map yx = decode_text_matrix("1 2 3\n4 5 6\n", Order::yx);
  CHECK(shape_of(yx.values) == Shape{3, 2});
  CHECK(yx.values(2, 1) == 6);
  CHECK(yx.units.empty());
  for (const Order order : {Order::xy, Order::yx})
    CHECK(same(decode_text_matrix(encode_text_matrix(map_with_holes(), order), order).values,
               map_with_holes().values));
}

// 3 × 4 points over 12.34 µm × 5678.9 nm; a line is a y.
TEST_CASE("Gwyddion's text export is read with the units of its width, height and values",
          "[formats][exact]") {
  const std::string bytes = data_file("gwyddion-head.txt");
  REQUIRE(recognises_gwyddion_text(bytes));
  const Map map = decode_gwyddion_text(bytes, Order::xy);
  Field lines(4, 3);
  lines << 1, 1.5, 3, -2, -3, -6, 0, 0, 0, 9, 9, 9;
  CHECK(same(map.values.transpose(), lines));
  CHECK(relative_error(map.spacing[0], 12.34e-6 / 3) <= 4 * epsilon);
  CHECK(relative_error(map.spacing[1], 5678.9e-9 / 4) <= 4 * epsilon);
  CHECK(map.units == "m");
  CHECK(map.title == "My Channel Name");
}

TEST_CASE("Gwyddion's text export is read in German, with decimal commas", "[formats][exact]") {
  const Map map = decode_gwyddion_text(
      "# Kanal: Höhe\r\n# Breite: 1,50 nm\r\n# Höhe: 3,0 µm\r\n# Werteinheiten: nm\r\n1,5\t-2,5e-001\t4\r\n",
      Order::xy);
  CHECK(relative_error(map.spacing[0], 0.5e-9) <= 4 * epsilon);
  CHECK(relative_error(map.spacing[1], 3e-6) <= 4 * epsilon);
  CHECK(relative_error(map.values(1, 0), -0.25e-9) <= 2 * epsilon);
  CHECK(map.title == "Höhe");
}

// Sizes are written as products and divided again: an epsilon each.
TEST_CASE("what is written as Gwyddion's text is read again the same, missing points too",
          "[formats][exact]") {
  const Map map = map_with_holes();
  const Map again = decode_gwyddion_text(encode_gwyddion_text(map, Order::xy), Order::xy);
  CHECK(same(again.values, map.values));
  CHECK(relative_error(again.spacing[0], map.spacing[0]) <= 2 * epsilon);
  CHECK(relative_error(again.spacing[1], map.spacing[1]) <= 2 * epsilon);
}
