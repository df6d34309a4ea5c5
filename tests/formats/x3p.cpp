#include <sstream>

#include "core/error.hpp"
#include "formats/format.hpp"
#include "maps.hpp"
#include "x3p_archives.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::string rotation(const std::string& elements) {
  std::istringstream words(elements);
  std::string out = "<p:Rotation>", word;
  for (int i = 0; words >> word; ++i) {
    const std::string name = "r" + std::to_string(1 + i / 3) + std::to_string(1 + i % 3);
    out += "<" + name + ">" + word + "</" + name + ">";
  }
  return out + "</p:Rotation>";
}

}  // namespace

TEST_CASE("an MD5 is that of RFC 1321's own examples", "[formats][exact]") {
  CHECK(x3p::md5_of("") == "d41d8cd98f00b204e9800998ecf8427e");
  CHECK(x3p::md5_of("a") == "0cc175b9c0f1b6a831c399e269772661");
  CHECK(x3p::md5_of("abc") == "900150983cd24fb0d6963f7d28e17f72");
  CHECK(x3p::md5_of("message digest") == "f96b697d7cb7938d525a2f31aaf161d0");
  CHECK(x3p::md5_of("abcdefghijklmnopqrstuvwxyz") == "c3fcd3d76192e4007dfb496cca67e13b");
  CHECK(x3p::md5_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789") ==
        "d174ab98d277d9f5a5611c2c9f419d9f");
  std::string digits;
  for (int i = 0; i < 8; ++i) digits += "1234567890";
  CHECK(x3p::md5_of(digits) == "57edf4a22be3c955ac49da2e2107b67a");
}

TEST_CASE("a map is the same after X3P, to the last bit, its missing points and unequal spacings too",
          "[formats][exact]") {
  const Map map = map_with_holes(), again = decode(format::x3p.encode(map, Order::xy));
  CHECK(same(again.values, map.values));
  CHECK(again.spacing == map.spacing);
  CHECK(again.units == "m");
}

TEST_CASE("a profile in X3P is one line, which may lack its spacing in y, and is written as one",
          "[formats][exact]") {
  const std::string data = numbers_of_type(NumberType::float64);
  Description d{.feature = "PRF", .size_x = "6", .size_y = "1"};
  const Map map = decode(foreign_x3p(d, data));
  CHECK(same(map.values, whole_heights().reshaped(6, 1)));
  CHECK(map.spacing == std::array{1.5e-6, 4e-6});
  d.third = link(data);
  std::string main = main_xml(d);
  const auto y = main.find("<CY>");
  main.erase(y, main.find("</CY>") + 5 - y);
  CHECK(decode(deflated({{"main.xml", main}, {"bindata/data.bin", data}})).spacing ==
        std::array{1.5e-6, 1.5e-6});
  const std::string written = format::x3p.encode(map, Order::xy);
  CHECK(written.find("<FeatureType>PRF<") != written.npos);
  CHECK(same(decode(written).values, map.values));
  CHECK(format::x3p.encode(decode(foreign_x3p({}, data)), Order::xy).find("<FeatureType>SUR<") !=
        written.npos);
}

TEST_CASE("the same map makes the same X3P bytes", "[formats][exact]") {
  CHECK(format::x3p.encode(map_with_holes(), Order::xy) == format::x3p.encode(map_with_holes(), Order::yx));
}

// Floats were multiplied too: csafe-logo.x3p of x3ptools, metres with Increment 1e-6, was a millionth as high.
TEST_CASE(
    "an X3P of every number type is read, x fastest, shifted by its offset, integers times their "
    "increment, floats as metres",
    "[formats][exact]") {
  const std::pair<const char*, NumberType> types[] = {{"I", NumberType::int16},
                                                      {"L", NumberType::int32},
                                                      {"F", NumberType::float32},
                                                      {"D", NumberType::float64}};
  for (const auto& [code, type] : types) {
    CAPTURE(code);
    const bool floats = type == NumberType::float32 || type == NumberType::float64;
    Description d{.type = code, .z = "<Increment>1</Increment>"};
    const Map plain = decode(foreign_x3p(d, numbers_of_type(type)));
    CHECK(same(plain.values, whole_heights()));
    CHECK(plain.spacing == std::array{1.5e-6, 4e-6});
    CHECK(plain.understood.empty());
    d.z = "<Increment>0.5</Increment><Offset>-3</Offset>";
    const Map scaled = decode(foreign_x3p(d, numbers_of_type(type)));
    CHECK(same(scaled.values, whole_heights() * (floats ? 1 : 0.5) - 3));
    CHECK((scaled.understood.find("the floats are metres: Increment 0.5") == 0) == floats);
  }
}

// Q = R P + T: points are taken where R takes them, one by one. It was ignored: of a surface turned over, Ssk
// had the other sign.
TEST_CASE("an X3P is turned, mirrored and turned over by its rotation, before it is shifted",
          "[formats][exact]") {
  const std::string data = numbers_of_type(NumberType::float64);
  const Field z = whole_heights();
  for (const char* words :
       {"1 0 0 0 1 0 0 0 1", "-1 0 0 0 -1 0 0 0 1", "1 0 0 0 -1 0 0 0 -1", "0 -1 0 1 0 0 0 0 1",
        "6e-17 1 0 -1 -4.4e-8 0 0 0 1.0", "0 1 0 1 0 0 0 0 -1", "-1 0 0 0 1 0 0 0 1"}) {
    CAPTURE(words);
    double r[9];
    std::istringstream in(words);
    for (double& element : r) {
      in >> element;
      element = std::round(element);
    }
    const Map map = decode(foreign_x3p({.z = "<Offset>7</Offset>", .rotation = rotation(words)}, data));
    const bool quarter = r[0] == 0;
    REQUIRE(shape_of(map.values) == (quarter ? Shape{2, 3} : Shape{3, 2}));
    CHECK(map.spacing == (quarter ? std::array{4e-6, 1.5e-6} : std::array{1.5e-6, 4e-6}));
    CHECK(map.understood.empty() == (std::string(words) == "1 0 0 0 1 0 0 0 1"));
    for (Index i = 0; i < 3; ++i)
      for (Index j = 0; j < 2; ++j) {  // twice the places from the middle
        const double x = 2.0 * static_cast<double>(i) - 2, y = 2.0 * static_cast<double>(j) - 1;
        const auto place = [&](double from_middle, Index points) {
          return (static_cast<Index>(from_middle) + points - 1) / 2;
        };
        CHECK(map.values(place(r[0] * x + r[1] * y, map.values.rows()),
                         place(r[3] * x + r[4] * y, map.values.cols())) == r[8] * z(i, j) + 7);
      }
  }
}

TEST_CASE("a rotation of an X3P that takes its points off the grid, or is half missing, is refused",
          "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  const auto read = [&](const std::string& words) {
    return decode(foreign_x3p({.rotation = rotation(words)}, data));
  };
  CHECK(same(read("").values, whole_heights()));
  CHECK_THROWS_WITH(read("0.6 -0.8 0 0.8 0.6 0 0 0 1"), ContainsSubstring("off their grid, r11 is 0.6"));
  CHECK_THROWS_WITH(read("1 0 0 0 1 1e-6 0 -1e-6 1"), ContainsSubstring("r23 is 1e-06"));
  CHECK_THROWS_WITH(read("1 0 0 0 1"), ContainsSubstring("r23 is nan"));
  CHECK_THROWS_WITH(read("0 0 1 0 1 0 -1 0 0"), ContainsSubstring("z not to z"));
  CHECK_THROWS_WITH(read("1 0 0 1 0 0 0 0 1"), ContainsSubstring("x and y not to x and y"));
  CHECK_THROWS_WITH(read("1e300 0 0 0 1 0 0 0 1"), ContainsSubstring("r11 is 1e+300"));
}

// Alicona's programs mark missing points so; the files were refused.
TEST_CASE("an infinite number of an X3P is a missing point, and told, and one by its increment is refused",
          "[formats][exact]") {
  Field z = whole_heights(), expected = z;
  z(1, 0) = HUGE_VAL;
  z(2, 1) = -HUGE_VAL;
  expected(1, 0) = expected(2, 1) = Map::unknown;
  const Map read = decode(foreign_x3p({}, bytes_of(z)));
  CHECK(same(read.values, expected));
  CHECK(read.understood == "2 infinite values read as missing");
  CHECK(dataset_of(read).notes == std::vector{read.understood});
  CHECK_THROWS_WITH(decode(foreign_x3p({.type = "I", .z = "<Increment>1e305</Increment>"},
                                       numbers_of_type(NumberType::int16))),
                    ContainsSubstring("infinite in metres"));
}

// Bits from the least on, x fastest: 0b101110 leaves out the points (0, 0) and (1, 1).
TEST_CASE("points whose bit in the file of valid points is 0 are missing", "[formats][exact]") {
  Field expected = whole_heights();
  expected(0, 0) = expected(1, 1) = std::nan("");
  const std::string data = numbers_of_type(NumberType::int16);
  const Description d{.type = "I", .z = "<Increment>1</Increment>"};
  CHECK(same(decode(foreign_x3p(d, data, "\x2E")).values, expected));
  CHECK_THROWS_AS(decode(foreign_x3p(d, data, "\x2E\x2E")), DataError);
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

TEST_CASE("a map without a size or of volts is not written as X3P", "[formats][contract]") {
  Map map = small_map();
  map.spacing[0] = Map::unknown;
  CHECK_THROWS_AS(format::x3p.encode(map, Order::xy), DataError);
  map = small_map();
  map.units = "V";
  CHECK_THROWS_AS(format::x3p.encode(map, Order::xy), DataError);
}
