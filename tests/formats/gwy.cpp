#include "core/error.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

template <class T>
std::string little(T number) {
  const auto raw = bytes_of(number, std::endian::little);
  return {raw.data(), raw.size()};
}

std::string ended(const std::string& text) { return text + '\0'; }
std::string part(const std::string& name, char type, const std::string& value) {
  return ended(name) + type + value;
}
std::string object(const std::string& kind, const std::string& body) {
  return ended(kind) + little(static_cast<std::uint32_t>(body.size())) + body;
}

struct FieldOf {
  int nx = 2, ny = 3;
  std::string numbers = {}, unit_xy = "m", unit = "m";
};

// 4 m × 3 m; the numbers count from 1 along the lines.
std::string field(FieldOf f = {}) {
  if (f.numbers.empty())
    for (int i = 1; i <= f.nx * f.ny; ++i) f.numbers += little(static_cast<double>(i));
  const auto count = static_cast<std::uint32_t>(f.numbers.size() / 8);
  const auto unit = [](const std::string& name) {
    return object("GwySIUnit", part("unitstr", 's', ended(name)));
  };
  return object("GwyDataField",
                part("xres", 'i', little(f.nx)) + part("yres", 'i', little(f.ny)) +
                    part("xreal", 'd', little(4.0)) + part("yreal", 'd', little(3.0)) +
                    part("xoff", 'd', little(7.0)) + part("si_unit_xy", 'o', unit(f.unit_xy)) +
                    part("si_unit_z", 'o', unit(f.unit)) + part("data", 'D', little(count) + f.numbers));
}

std::string file(const std::string& parts) { return "GWYP" + object("GwyContainer", parts); }

// Beside the channels, what a reader passes by: every type of component.
std::string others() {
  const std::string one = little(std::uint32_t{1}), two = little(std::uint32_t{2});
  return part("/0/data/visible", 'b', "\1") + part("a", 'c', "x") + part("b", 'q', std::string(8, '\1')) +
         part("c", 'C', two + "xy") + part("d", 'I', one + "abcd") + part("e", 'Q', one + "abcdefgh") +
         part("f", 'S', two + ended("one") + ended("two")) + part("g", 'O', one + object("GwyGraph", "?")) +
         part("/0/select/point", 'o', object("GwySelectionPoint", "?")) + part("/brick/0", 'o', field());
}

std::string channel(int number, const std::string& title, const FieldOf& f = {}) {
  const std::string place = "/" + std::to_string(number) + "/data";
  return part(place, 'o', field(f)) + part(place + "/title", 's', ended(title));
}

Map read(const std::string& bytes, const std::string& of = "") {
  Reading reading;
  reading.channel = of;
  return format::gwy.decode(bytes, reading);
}

}  // namespace

// 2 × 3 points over 4 m × 3 m: each is 2 m × 1 m. The second line is the second y.
TEST_CASE("a GWY is read with its size, unit and title, line by line, whatever else it holds",
          "[formats][exact]") {
  const Map map = read(file(others() + channel(0, "Topography")));
  REQUIRE(shape_of(map.values) == Shape{2, 3});
  CHECK(map.values(0, 0) == 1);
  CHECK(map.values(1, 0) == 2);
  CHECK(map.values(0, 1) == 3);
  CHECK(map.values(1, 2) == 6);
  CHECK(map.spacing == std::array{2.0, 1.0});
  CHECK(map.units == "m");
  CHECK(map.title == "Topography");
}

TEST_CASE("the points that a GWY masks are missing, those of another channel are not", "[formats][exact]") {
  std::string marks;
  for (const double mark : {0.0, 1.0, 0.0, 0.0, 0.5, 0.0}) marks += little(mark);
  const std::string mask = part("/0/mask", 'o', field({.numbers = marks})),
                    both = channel(0, "z") + channel(1, "z2");
  Field z(2, 3);
  z << 1, 3, std::nan(""), std::nan(""), 4, 6;
  CHECK(same(read(file(both + mask), "0").values, z));
  CHECK(!read(file(both + mask), "1").values.hasNaN());
  CHECK_THROWS_WITH(read(file(channel(0, "z") + part("/0/mask", 'o', field({.nx = 3, .ny = 2})))),
                    ContainsSubstring("the mask has 3 x 2 points, the map 2 x 3"));
}

TEST_CASE("a GWY in no unit has no size, one in another unit keeps it", "[formats][exact]") {
  const Map map = read(file(channel(0, "z", {.unit_xy = "", .unit = ""})));
  CHECK(std::isnan(map.spacing[0]));
  CHECK(map.units.empty());
  CHECK(read(file(channel(0, "z", {.unit = "V"}))).units == "V");
  CHECK_THROWS_WITH(read(file(channel(0, "z", {.unit_xy = "s"}))), ContainsSubstring("'s'"));
}

TEST_CASE("a channel is the only one, the only height, or the one that is named", "[formats][contract]") {
  const std::string mixed = file(channel(0, "Phase", {.unit = "deg"}) + channel(2, "Height") +
                                 channel(11, "Current", {.numbers = std::string(48, '\0'), .unit = "A"}));
  CHECK(read(mixed).title == "Height");
  CHECK(read(mixed, "Phase").units == "deg");
  CHECK(read(mixed, "11").title == "Current");
  CHECK_THROWS_WITH(read(mixed, "1"),
                    "the file has no channel '1', only 0 'Phase', 2 'Height', 11 'Current'");
  const std::string twice = file(channel(0, "Height") + channel(1, "Height") + channel(2, "0"));
  CHECK_THROWS_WITH(
      read(twice),
      "the file has 3 channels, 3 of them heights: choose one with `channel`: 0 'Height', 1 'Height', "
      "2 '0'");
  CHECK_THROWS_WITH(read(twice, "Height"), ContainsSubstring("2 channels 'Height': choose by number"));
  CHECK(read(twice, "1").title == "Height");
  CHECK(read(twice, "0").title == "0");  // a name goes before a number
  std::string many;
  for (int i = 0; i < 5000; ++i) many += part("/" + std::to_string(i) + "/data/title", 's', ended("x"));
  CHECK_THROWS_WITH(read(file(many)), ContainsSubstring("more than 4096 channels"));
}

// Sizes are products of spacings and are divided again. The mean fills missing points: Gwyddion has no NaN.
TEST_CASE("what is written as GWY is read again the same, missing points too", "[formats][exact]") {
  Map map = map_with_holes();
  map.title = "two\nlines";
  const std::string bytes = format::gwy.encode(map, Order::xy);
  const Map again = read(bytes);
  CHECK(same(again.values, map.values));
  CHECK(relative_error(again.spacing[0], map.spacing[0]) <= 2 * epsilon);
  CHECK(relative_error(again.spacing[1], map.spacing[1]) <= 2 * epsilon);
  CHECK(again.units == "m");
  CHECK(again.title == "two lines");
  std::string unmasked = bytes;
  unmasked.replace(unmasked.find("/0/mask"), 7, "/0/musk");
  const Field filled = read(unmasked).values;
  CHECK(filled(0, 0) == filled(3, 2));
  const double mean = map.values.isNaN().select(0.0, map.values).sum() / 13;
  CHECK(relative_error(filled(0, 0), mean) <= 16 * epsilon);
  map.spacing[0] = Map::unknown;
  map.units = "";
  CHECK(std::isnan(read(format::gwy.encode(map, Order::xy)).spacing[0]));
}

TEST_CASE("a GWY that lies about itself is refused with what is wrong", "[formats][contract]") {
  const auto refused = [](const std::string& bytes, const std::string& with) {
    CHECK_THROWS_WITH(read(bytes), ContainsSubstring(with));
  };
  const std::string good = file(channel(0, "z"));
  const auto with = [&](const std::string& name, const std::string& value) {
    std::string out = good;
    return out.replace(out.rfind(ended(name)) + name.size() + 2, value.size(), value);
  };
  refused("GWYOGwyContainer", "of Gwyddion 1");
  refused("GWYP" + object("GwyGraph", ""), "holds 'GwyGraph'");
  refused(file(others()), "the file holds no map");
  refused(good.substr(0, good.size() - 1), "cut short");
  refused(good + "more", "4 bytes follow its end");
  refused(with("xres", little(-2)), "the map has no points");
  refused(with("xres", little(3)), "cut short");
  refused(with("xres", little(1)), "bytes follow");
  refused(with("xreal", little(0.0)), "xreal 0 of the channel is not positive");
  refused(with("data", little(std::uint32_t{0xffffffff})), "cut short");
  refused(file(part("a", 'O', little(std::uint32_t{0xffffffff}))), "cut short");
  refused(file(part("a", 'Z', "")), "unknown type, 'Z'");
}
