#include "core/error.hpp"
#include "formats/format.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A head of `lines` with its NULs, and the floats 1 and -2.5, least significant byte first.
std::string file(const std::string& lines) {
  std::string out = "Gwyddion Simple Field 1.0\n" + lines;
  out.append(4 - out.size() % 4, '\0');
  return out + std::string("\0\0\x80\x3f\0\0\x20\xc0", 8);
}

}  // namespace

// 2 × 1 points over 4 µm × 3 µm: each is 2 µm × 3 µm. Heads of four lengths have one to four NULs.
TEST_CASE("a GSF is read with its size, unit and title, whatever the length of its head",
          "[formats][exact]") {
  for (const std::string title : {"a", "ab", "abc", "abcd"}) {
    const Map map = format::gsf.decode(
        file("XRes=2\nYRes = 1\nXReal=4\nYReal=3\nXYUnits=µm\nZUnits=nm\nXOffset=7\nTitle = " + title + "\n"),
        Order::xy);
    CAPTURE(title);
    REQUIRE(shape_of(map.values) == Shape{2, 1});
    CHECK(relative_error(map.values(1, 0), -2.5e-9) <= 2 * epsilon);
    CHECK(relative_error(map.spacing[0], 2e-6) <= 2 * epsilon);
    CHECK(relative_error(map.spacing[1], 3e-6) <= 2 * epsilon);
    CHECK(map.title == title);
  }
}

TEST_CASE("a GSF without units has no size, one without a size is one unit long", "[formats][exact]") {
  CHECK(std::isnan(format::gsf.decode(file("XRes=2\nYRes=1\nXReal=4\n"), Order::xy).spacing[0]));
  CHECK(format::gsf.decode(file("XRes=2\nYRes=1\n"), Order::xy).units.empty());
  CHECK(format::gsf.decode(file("XRes=2\nYRes=1\nXYUnits=m\n"), Order::xy).spacing[0] == 0.5);
}

// Values are powers of two or NaN: 24 bits hold them. Sizes are written as products and divided again.
TEST_CASE("what is written as GSF is read again the same, missing points too", "[formats][exact]") {
  Map map = map_with_holes();
  map.values = map.values.isNaN().select(map.values, 0.25);
  map.title = "two\nlines";
  const Map again = format::gsf.decode(format::gsf.encode(map, Order::xy), Order::xy);
  CHECK(same(again.values, map.values));
  CHECK(relative_error(again.spacing[1], map.spacing[1]) <= 2 * epsilon);
  CHECK(again.title == "two lines");
  map.values(1, 1) = 1e39;
  CHECK_THROWS_WITH(format::gsf.encode(map, Order::xy), ContainsSubstring("single precision"));
}

TEST_CASE("a GSF that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](const std::string& bytes, const std::string& with) {
    CHECK_THROWS_WITH(format::gsf.decode(bytes, Order::xy), ContainsSubstring(with));
  };
  refused("Gwyddion", "is not a Gwyddion Simple Field");
  refused("Gwyddion Simple Field 1.0\nXRes=1\n", "no end");
  refused(file("XRes=2\n"), "YRes is missing in the header");
  refused(file("XRes=2\nYRes=1.5\n"), "YRes '1.5' in the header is not a whole number");
  refused(file("XRes=2\nYRes=1\nxres=1\n"), "XRes is '2' and '1' in the header: remove one");
  refused(file("XRes=-2\nYRes=-1\n"), "is not a whole number from 0");
  refused(file("XRes=0\nYRes=1\n"), "the map has no points");
  refused(file("XRes=2\nYRes=2\n"), "cut short");
  refused(file("XRes=4611686018427387904\nYRes=4611686018427387904\n"), "cut short");
  refused(file("XRes=99999999999999999999\nYRes=1\n"), "is not a whole number from 0");
  refused(file("XRes=2\nYRes=1\nXReal=-1\nXYUnits=m\n"), "XReal '-1' in the header is not positive");
  refused(file("XRes=2\nYRes=1\nXReal=1\nXYUnits=V\n"), "V");
}
