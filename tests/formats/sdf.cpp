#include <bit>

#include "core/error.hpp"
#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A binary file of 1 × points numbers of a type, with the spacing 0.5 m and the unit 0.25 m. A double of
// those has only its two greatest bytes.
std::string binary(const std::string& version, int points, int type, const std::string& numbers) {
  const std::string size{static_cast<char>(points), '\0'}, one{'\1', '\0'},
      wide = version == "ISO-2.0" ? std::string(2, '\0') : "";
  const std::string half("\0\0\0\0\0\0\xe0\x3f", 8), quarter("\0\0\0\0\0\0\xd0\x3f", 8);
  return "b" + version + "Somebody  010120000000010120000000" + size + wide + one + wide + half + half +
         quarter + half + '\0' + static_cast<char>(type) + '\0' + numbers;
}

std::vector<double> numbers_of(const std::string& version, int points, int type, const std::string& numbers) {
  const Map map = format::sdf.decode(binary(version, points, type, numbers), Order::xy);
  REQUIRE(shape_of(map.values) == Shape{points, 1});
  std::vector<double> out;
  for (Index i = 0; i < points; ++i)
    out.push_back(std::isnan(map.values(i, 0)) ? -1e9 : 4 * map.values(i, 0));
  return out;
}

constexpr double missing = -1e9;

std::string text(const std::string& head, const std::string& numbers) {
  return "aISO-1.0\nManufacID = X\n" + head + "*\n" + numbers;
}

const std::string head =
    "NumPoints = 2\nNumProfiles = 2\nXscale = 1e-6\nYscale = 2e-6\nZscale = 0.5\nCompression = 0\nDataType = "
    "5\nCheckType = 0\n";

}  // namespace

// The file states 1 µm for all three scales.
TEST_CASE("the 7 x 4 heights of a standard's own SDF are read in micrometres", "[formats][exact]") {
  const std::string bytes = data_file("iso-7x4.sdf");
  REQUIRE(format_of(bytes, "-").name == "sdf-ascii");
  const Map map = format::sdf.decode(bytes, Order::xy);
  REQUIRE(shape_of(map.values) == Shape{7, 4});
  CHECK(map.spacing == std::array{1e-6, 1e-6});
  CHECK(map.units == "m");
  CHECK(map.values(0, 0) == 1e-6);
  CHECK(map.values(6, 0) == 1e-6);
  CHECK(relative_error(map.values(5, 0), 0.96858e-6) <= epsilon);
  CHECK(relative_error(map.values(0, 1), 0.99874e-6) <= epsilon);
  CHECK(relative_error(map.values(5, 3), 0.94907e-6) <= epsilon);
}

TEST_CASE("a binary SDF is read in all eight types of number, missing ones by each type's own",
          "[formats][exact]") {
  using List = std::vector<double>;
  const std::string iso = "ISO-1.0", bcr = "BCR-1.0";
  CHECK(numbers_of(iso, 3, 0, std::string("\0\x01\xff", 3)) == List{0, 1, missing});
  CHECK(numbers_of(iso, 3, 1, std::string("\0\1\xff\xff\xfe\xff", 6)) == List{256, missing, 65534});
  CHECK(numbers_of(iso, 2, 2, std::string("\xfe\xff\xff\xff\xff\xff\xff\xff", 8)) ==
        List{4294967294, missing});
  CHECK(numbers_of(iso, 3, 4, "\xff\x80\x7f") == List{-1, missing, 127});
  CHECK(numbers_of(bcr, 3, 4, "\xff\x80\x7f") == List{-1, missing, missing});
  CHECK(numbers_of(iso, 3, 5, std::string("\xff\xff\0\x80\xff\x7f", 6)) == List{-1, missing, 32767});
  CHECK(numbers_of(bcr, 3, 5, std::string("\xff\xff\0\x80\xff\x7f", 6)) == List{-1, missing, missing});
  CHECK(numbers_of(iso, 2, 6, std::string("\0\0\0\x80\0\0\1\0", 8)) == List{missing, 65536});
  CHECK(numbers_of(bcr, 2, 6, std::string("\xff\xff\xff\x7f\0\0\1\0", 8)) == List{missing, 65536});
  CHECK(numbers_of(iso, 4, 3, std::string("\0\0\x20\xc0\xff\xff\x7f\xff\xff\xff\x7f\x7f\0\0\xc0\x7f", 16)) ==
        List{-2.5, missing, missing, missing});
  CHECK(numbers_of(iso, 2, 7, std::string("\0\0\0\0\0\0\x04\xc0\0\0\0\0\0\0\xf8\x7f", 16)) ==
        List{-2.5, missing});
  CHECK(numbers_of(iso, 1, 7, "\xff\xff\xff\xff\xff\xff\xef\xff") == List{missing});
}

TEST_CASE("a binary SDF has four bytes for each size in ISO-2.0, and Olympus eight more after its head",
          "[formats][exact]") {
  CHECK(numbers_of("ISO-2.0", 2, 4, "\3\4") == std::vector{3.0, 4.0});
  CHECK(numbers_of("ISO-1.0", 2, 4, std::string("\5\0\0\0\1\0\0\0\3\4", 10)) == std::vector{3.0, 4.0});
  CHECK(numbers_of("ISO-1.0", 2, 4, "\3\4*trailer") == std::vector{3.0, 4.0});
}

TEST_CASE("an SDF of a single line has the spacing along y that it gives, or none", "[formats][exact]") {
  std::string bytes = binary("ISO-1.0", 2, 4, "\3\4");
  CHECK(format::sdf.decode(bytes, Order::xy).spacing[0] == 0.5);
  CHECK(format::sdf.decode(bytes, Order::xy).spacing[1] > 0);
  constexpr std::size_t y_scale = 8 + 10 + 12 + 12 + 2 + 2 + 8;
  bytes.replace(y_scale, 8, 8, '\0');
  CHECK(std::isnan(format::sdf.decode(bytes, Order::xy).spacing[1]));
}

TEST_CASE("an SDF in text is read with its scale, BAD points, comments, and names in any order and case",
          "[formats][exact]") {
  Field z(2, 2);
  z << 0.5, 1.5, std::nan(""), -2;
  for (const std::string& bytes :
       {text(head, "1 BAD\n3 -4\n*\nmore * 7"), text("; words\nnumdataset=1\n" + head, "1 BAD 3\r\n-4\n")})
    CHECK(same(format::sdf.decode(bytes, Order::xy).values, z));
  CHECK(format::sdf.decode(text(head, "1 2 3 4"), Order::xy).spacing == std::array{1e-6, 2e-6});
}

TEST_CASE("what is written as SDF is read again the same, missing points too", "[formats][exact]") {
  const Map map = map_with_holes();
  for (const std::string& bytes :
       {format::sdf.encode(map, Order::xy), format::sdf_ascii.encode(map, Order::xy)}) {
    const Map again = format::sdf.decode(bytes, Order::xy);
    CHECK(same(again.values, map.values));
    CHECK(again.spacing == map.spacing);
    CHECK(again.units == "m");
  }
  CHECK(format::sdf.encode(map, Order::xy).size() == 81 + 15 * 8);
  CHECK_THAT(format::sdf_ascii.encode(map, Order::xy), ContainsSubstring("*\nBAD 0.1 "));
}

TEST_CASE("a map that SDF cannot hold is not written as one", "[formats][contract]") {
  Map map = small_map();
  map.units = "V";
  CHECK_THROWS_WITH(format::sdf.encode(map, Order::xy),
                    "SDF holds only lengths, not values in 'V': choose another format");
  map = small_map();
  map.spacing[1] = Map::unknown;
  CHECK_THROWS_WITH(format::sdf_ascii.encode(map, Order::xy),
                    "the map has no size, which SDF needs: give its `size`");
  map = small_map();
  map.values = Field::Zero(65536, 1);
  CHECK_THROWS_WITH(format::sdf.encode(map, Order::xy), ContainsSubstring("65535 points"));
}

TEST_CASE("an SDF that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](std::string bytes, const std::string& with) {
    CHECK_THROWS_WITH(format::sdf.decode(bytes, Order::xy), ContainsSubstring(with));
  };
  const auto with = [](std::string bytes, std::size_t at, const std::string& part) {
    return bytes.replace(at, part.size(), part);
  };
  const std::string good = binary("ISO-1.0", 2, 4, "\3\4");
  refused("cISO-1.0", "is not SDF");
  refused(good.substr(0, 80), "header has no end");
  refused(binary("ISO-2.0", 2, 4, "").substr(0, 83), "header has no end");
  refused(good.substr(0, 82), "cut short");
  refused(with(good, 42, "\xff\xff\xff\xff"), "the file is cut short: it holds");
  refused(with(good, 42, std::string(2, '\0')), "the map has no points");
  refused(with(good, 46, std::string(8, '\0')), "Xscale 0 in the header is not positive");
  refused(with(good, 62, std::string("\0\0\0\0\0\0\xf8\x7f", 8)), "Zscale nan in the header is not positive");
  refused(with(good, 78, "\1"), "Compression 1");
  refused(with(good, 79, "\x8"), "number type 8");
  refused(with(good, 80, "\2"), "CheckType 2");
  refused("aISO-1.0\nNumPoints = 2\n", "no end");
  refused(text("NumPoints = 2\n", "1 2\n"), "NumProfiles is missing in the header");
  refused(text(head, "1 2 3\n*\n4"), "has 3 numbers, its header gives 2 x 2");
  refused(text(head, "1 2 3 x\n*\n"), "line 12: 'x' is not a number");
  refused(text("NumPoints = 3000000000\n" + head.substr(head.find("NumProfiles")), "1 2 3 4\n"), "cut short");
  refused(text("NumPoints = 3\n" + head, "1 2 3 4\n"), "NumPoints is '3' and '2' in the header: remove one");
}
