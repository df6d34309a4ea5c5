#include "core/error.hpp"
#include "formats/format.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string head = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\n";

}  // namespace

// The first line is the north, y = ny - 1.
TEST_CASE("an ESRI grid begins with the largest y, in words of any case and numbers in any lines",
          "[formats][exact]") {
  Field z(3, 2);
  z << 4, 1, 5, std::nan(""), 6, 3;
  const Map map = format::esri.decode(head + "NODATA_value -9999\n1 -9999 3\n4 5 6\n", Order::xy);
  CHECK(same(map.values, z));
  CHECK(map.spacing == std::array{0.5, 0.5});
  CHECK(map.units.empty());
  const Map other = format::esri.decode(
      "NCOLS\t3\r\nNROWS 2\r\nXLLCENTER 7\r\nDY 3\r\nDX 2e-6\r\nNODATA_VALUE NaN\r\n1\r\nnan 3 4\r\n 5 6",
      Order::xy);
  CHECK(same(other.values, z));
  CHECK(other.spacing == std::array{2e-6, 3.0});
}

// -3.4028235e+38 is how nine digits have the float of -3.4028234663852886e+38, -3.40282e+38 how six have it.
TEST_CASE("a point of an ESRI grid is missing when it is NODATA to single precision", "[formats][exact]") {
  for (const char* mark : {"NODATA_value -3.4028234663852886e+38\n-3.4028235e+38",
                           "nodata_value -3.40282e+38\n-3.4028234663852886e+38",
                           "NODATA_value 1.70141e38\n1.701410009187828e+38", "\n-9999",
                           "NODATA_VALUE -9999.0\n-9999", "NODATA_value -32768\n-32768.0"}) {
    CAPTURE(mark);
    const Map map = format::esri.decode(head + mark + " 2 3\n4 5 6\n", Order::xy);
    CHECK(std::isnan(map.values(0, 1)));
    CHECK(map.values.isNaN().count() == 1);
  }
  CHECK(format::esri.decode(head + "NODATA_value -32768\n1 -9999 3\n4 5 6\n", Order::xy).values(1, 1) ==
        -9999);
  CHECK(format::esri.decode(head + "NODATA_value -9999\n1 -9998 3\n4 5 6\n", Order::xy).values(1, 1) ==
        -9998);
}

TEST_CASE(
    "what is written as an ESRI grid is read again the same, whatever number says that a point is missing",
    "[formats][exact]") {
  for (const double low : {-0.5, -9999.0, -1e5, -1e200}) {
    Map map = map_with_holes();
    map.values(2, 2) = low;
    const std::string bytes = format::esri.encode(map, Order::xy);
    CAPTURE(low);
    REQUIRE(format::esri.recognises(bytes));
    const Map again = format::esri.decode(bytes, Order::xy);
    CHECK(same(again.values, map.values));
    CHECK(again.spacing == map.spacing);
  }
  Map square = small_map();
  square.spacing = {2.5, 2.5};
  CHECK_THAT(format::esri.encode(square, Order::xy), ContainsSubstring("cellsize 2.5\nNODATA_value -9999\n"));
}

TEST_CASE("an ESRI grid that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](const std::string& bytes, const std::string& with) {
    CHECK_THROWS_WITH(format::esri.decode(bytes, Order::xy), ContainsSubstring(with));
  };
  refused("ncols 3\n", "nrows is missing in the header");
  refused(head + "1 2 3 4 5\n", "has 5 numbers, its header gives 3 x 2");
  refused(head + "1 2 3 4 5 6 7\n", "has 7 numbers");
  refused(head + "1 2 3 4 5 six\n", "line 6: 'six' is not a number");
  refused("ncols 3\nnrows 2\n1 2 3 4 5 6\n", "cellsize is missing in the header");
  refused(head + "cellsize 1\n1 2 3 4 5 6\n", "cellsize is '0.5' and '1' in the header: remove one");
  refused(head + "dx 0.5\ndy 1\n1 2 3 4 5 6\n", "cellsize and dx, dy in the header differ");
  refused("ncols 3\nnrows 2\ndx 1\n1 2 3 4 5 6\n", "dy is missing in the header");
  refused("ncols 3\nnrows 2\ncellsize 0\n1 2 3 4 5 6\n", "not positive");
  refused("ncols 3000000000\nnrows 3000000000\ncellsize 1\n1 2 3\n", "cut short");
  refused(head + "NODATA_value x\n1 2 3 4 5 6\n", "NODATA_value 'x' in the header is not a number");
  Map map = small_map();
  map.spacing[0] = Map::unknown;
  CHECK_THROWS_WITH(format::esri.encode(map, Order::xy),
                    "the map has no size, which an ESRI grid needs: give its `size`");
  map = small_map();
  map.values(0, 0) = -1e308;
  CHECK_THROWS_WITH(format::esri.encode(map, Order::xy), ContainsSubstring("can mark missing points"));
}

TEST_CASE("a name that ends in asc is an ESRI grid to write, and one to read if it begins as such",
          "[formats][contract]") {
  CHECK(format_by_extension("a.asc")->name == "esri");
  CHECK(format_of(head + "1 2 3 4 5 6\n", "a.txt").name == "esri");
  CHECK(format_of("1 2 3\n", "a.asc").name == "text");
}
