#include "core/error.hpp"
#include "formats/archive.hpp"
#include "formats/format.hpp"
#include "maps.hpp"
#include "x3p_archives.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// 3 × 2 whole heights, and as a file of numbers of a type, x fastest.
Field whole_heights() {
  Field z(3, 2);
  z << 1, -2, 30, 400, -5, 32000;
  return z;
}

std::string numbers_of_type(NumberType type) {
  return bytes_of(whole_heights(), {type, std::endian::little, Order::yx});
}

Map decode(const std::string& bytes) { return format::x3p.decode(bytes, Order::xy); }

// Bytes with a number of `width` of them, little-endian, at a place.
std::string with_number(std::string bytes, std::size_t at, std::size_t width, std::size_t value) {
  for (std::size_t i = 0; i < width; ++i) bytes[at + i] = static_cast<char>(value >> (8 * i) & 0xFF);
  return bytes;
}

// Where the central directory has its record of an entry; the inflated size stands 24 bytes into it.
std::size_t record_of(const std::string& archive, const std::string& name) {
  return archive.rfind(name) - 46;
}

}  // namespace

TEST_CASE("an MD5 is that of RFC 1321's own examples", "[formats][exact]") {
  CHECK(md5_of("") == "d41d8cd98f00b204e9800998ecf8427e");
  CHECK(md5_of("message digest") == "f96b697d7cb7938d525a2f31aaf161d0");
}

TEST_CASE("a map is the same after X3P, to the last bit, its missing points and unequal spacings too",
          "[formats][exact]") {
  const Map map = map_with_holes(), again = decode(format::x3p.encode(map, Order::xy));
  CHECK(same(again.values, map.values));
  CHECK(again.spacing == map.spacing);
  CHECK(again.units == "m");
}

TEST_CASE("the same map makes the same X3P bytes", "[formats][exact]") {
  CHECK(format::x3p.encode(map_with_holes(), Order::xy) == format::x3p.encode(map_with_holes(), Order::yx));
}

TEST_CASE("an X3P of every number type is read, x fastest, times its increment and shifted by its offset",
          "[formats][exact]") {
  const std::pair<const char*, NumberType> types[] = {{"I", NumberType::int16},
                                                      {"L", NumberType::int32},
                                                      {"F", NumberType::float32},
                                                      {"D", NumberType::float64}};
  for (const auto& [code, type] : types) {
    CAPTURE(code);
    Description d{.type = code};
    const Map plain = decode(foreign_x3p(d, numbers_of_type(type)));
    CHECK(same(plain.values, whole_heights()));
    CHECK(plain.spacing == std::array{1.5e-6, 4e-6});
    d.z = "<Increment>0.5</Increment><Offset>-3</Offset>";
    CHECK(same(decode(foreign_x3p(d, numbers_of_type(type))).values, whole_heights() * 0.5 - 3));
  }
}

// Bits from the least on, x fastest: 0b101110 leaves out the points (0, 0) and (1, 1).
TEST_CASE("points whose bit in the file of valid points is 0 are missing", "[formats][exact]") {
  Field expected = whole_heights();
  expected(0, 0) = expected(1, 1) = std::nan("");
  const std::string data = numbers_of_type(NumberType::int16);
  CHECK(same(decode(foreign_x3p({.type = "I"}, data, "\x2E")).values, expected));
  CHECK_THROWS_AS(decode(foreign_x3p({.type = "I"}, data, "\x2E\x2E")), DataError);
}

TEST_CASE("an X3P that lists its points in main.xml is read, an empty one as missing", "[formats][exact]") {
  Description d{.size_x = "2", .size_y = "2"};
  d.third = "<DataList><Datum>1e-6</Datum><Datum>0;0;2E-006</Datum><Datum/><Datum> 4e-6 </Datum></DataList>";
  Field expected(2, 2);
  expected << 1e-6, std::nan(""), 2e-6, 4e-6;
  CHECK(same(decode(deflated({{"main.xml", main_xml(d)}})).values, expected));
  d.size_x = "3";
  CHECK_THROWS_AS(decode(deflated({{"main.xml", main_xml(d)}})), DataError);
  d.size_x = "1";
  CHECK_THROWS_AS(decode(deflated({{"main.xml", main_xml(d)}})), DataError);
}

TEST_CASE("a wrong checksum of an X3P is named", "[formats][contract]") {
  Description d;
  const std::string data = numbers_of_type(NumberType::float64), digest = md5_of("something else");
  d.third = link(data);
  const std::string main = main_xml(d);
  CHECK_THROWS_WITH(
      decode(deflated(
          {{"main.xml", main}, {"bindata/data.bin", data}, {"md5checksum.hex", digest + " *main.xml"}})),
      "main.xml is damaged: its checksum is wrong");
  d.third = link("something else");
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", main_xml(d)}, {"bindata/data.bin", data}})),
                    "bindata/data.bin is damaged: its checksum is wrong");
  d.third = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
  CHECK_NOTHROW(decode(deflated({{"main.xml", main_xml(d)}, {"bindata/data.bin", data}})));
}

TEST_CASE("what an X3P says of itself must be a surface of one layer, of the size of its numbers",
          "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  const auto refused = [&](const Description& d, const char* words) {
    CHECK_THROWS_WITH(decode(foreign_x3p(d, data)), ContainsSubstring(words));
  };
  CHECK_NOTHROW(decode(foreign_x3p({}, data)));
  refused({.feature = "PRF"}, "'PRF' is not supported");
  refused({.type = "X"}, "number type 'X' is not supported, only I, L, F, D");
  refused({.type = "F"}, "has 48 bytes, the map needs 24");
  refused({.size_x = "4"}, "cut short");
  refused({.size_x = "2"}, "has 48 bytes, the map needs 32");
  refused({.size_x = "-3"}, "the map has no points");
  refused({.size_x = "4611686018427387904", .size_y = "4611686018427387904"}, "cut short");
  refused({.size_x = "3.5"}, "is not a whole number");
  refused({.size_z = "2"}, "more than one layer");
  refused({.dx = "0"}, "Increment 0 of CX in main.xml is not positive");
  refused({.dy = "-1e-6"}, "of CY in main.xml is not positive");
  refused({.dy = "inf"}, "is not a number");
  refused({.z = "<Increment>0</Increment>"}, "Increment 0 of CZ");
}

TEST_CASE("an archive that is no X3P, links outside itself or has its numbers elsewhere is refused",
          "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  CHECK_THROWS_WITH(decode("PK\x03\x04 and nothing"), ContainsSubstring("not a zip archive"));
  CHECK_THROWS_WITH(decode(deflated({{"word/document.xml", "<a/>"}})),
                    ContainsSubstring("'main.xml' in the archive is missing"));
  for (const char* path : {"../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd"}) {
    Description d;
    d.third = "<DataLink><PointDataLink>" + std::string(path) + "</PointDataLink></DataLink>";
    CHECK_THROWS_WITH(decode(deflated({{"main.xml", main_xml(d)}})),
                      ContainsSubstring("'" + std::string(path) + "' in the archive is missing"));
  }
  CHECK_THROWS_AS(decode(deflated({{"main.xml", "no <xml"}})), DataError);
  CHECK_THROWS_AS(decode(deflated({{"main.xml", main_xml({})}, {"bindata/data.bin", data}})), DataError);
}

// An entity of the file system would be 'root:…'; of itself, 10⁹ letters.
TEST_CASE("entities of main.xml are not expanded, and elements may lie as deep as they like",
          "[formats][contract]") {
  Description d{.dx = "&file;"};
  std::string main = main_xml(d);
  main.insert(main.find("<p:ISO"), "<!DOCTYPE a [<!ENTITY file SYSTEM \"file:///etc/passwd\">]>");
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", main}})),
                    ContainsSubstring("'&file;' in main.xml is not a number"));
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  CHECK_THROWS_AS(decode(deflated({{"main.xml", deep}})), DataError);
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  CHECK_THROWS_AS(decode(deflated({{"main.xml", deep}})), DataError);
}

TEST_CASE("an archive that lies about the size of an entry is refused", "[formats][contract]") {
  const std::string bytes = foreign_x3p({}, numbers_of_type(NumberType::float64)), name = "bindata/data.bin";
  const std::size_t at = record_of(bytes, name);
  REQUIRE(bytes.substr(at, 4) == "PK\x01\x02");
  for (const std::size_t size : {0u, 8u, 47u, 49u, 4096u, 0x7FFFFFFFu}) {
    CAPTURE(size);
    CHECK_THROWS_AS(decode(with_number(bytes, at + 24, 4, size)), DataError);
  }
}

// 64 MiB of zeros deflate to 64 KiB: numbers of the map they may be, elements of main.xml not.
TEST_CASE(
    "an archive that inflates a thousandfold is inflated for as many numbers as the map has and no more",
    "[formats][contract][slow]") {
  const std::string zeros(std::size_t{1} << 26, '\0');
  CHECK_THROWS_WITH(decode(foreign_x3p({}, zeros)), ContainsSubstring("has 67108864 bytes, the map"));
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", zeros}})), ContainsSubstring("more than is allowed"));
  CHECK(decode(foreign_x3p({.size_x = "4096", .size_y = "2048"}, zeros)).values.rows() == 4096);
}

TEST_CASE("a map without a size or of volts is not written as X3P", "[formats][contract]") {
  Map map = small_map();
  map.spacing[0] = Map::unknown;
  CHECK_THROWS_AS(format::x3p.encode(map, Order::xy), DataError);
  map = small_map();
  map.units = "V";
  CHECK_THROWS_AS(format::x3p.encode(map, Order::xy), DataError);
}
