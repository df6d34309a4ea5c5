#include "formats/format.hpp"

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("a format is known by its first bytes, then by its name, then as text", "[formats][contract]") {
  CHECK(format_of("# Width: 1 m\n# Height: 1 m\n1 2\n", "a.csv").name == "gwyddion-text");
  CHECK(format_of("1 2\n", "folder.d/A.CSV").name == "text");
  CHECK(format_of("1 2\n", "-").name == "text");
  CHECK_THROWS_AS(format_of(std::string("\x01\x02\0", 3), "a.unknown"), DataError);
  CHECK_THROWS_AS(format_of("", "a.txt"), DataError);
  CHECK_THROWS_AS(format_of(std::string("1 2\n\0\1", 6), "a.txt"),
                  DataError);  // many instruments write .dat, .txt
  CHECK(format_of("1 2\n\x1b", "a.txt").name == "text");
  CHECK_THROWS_AS(format_named("word", "from"), ParameterError);
}

// Of the heads of many instruments' files (.spm, .nid, .stp, .bcrf), 4096 bytes and more are text: they were
// read, and refused, as texts.
TEST_CASE("numbers behind a long head of words are no text, padding behind a text and UTF-16 are",
          "[formats][contract]") {
  std::string head, wide = "\xff\xfe";
  for (int i = 0; i < 900; ++i) head += "\\Info: words\r\n";
  for (const char c : head) wide += {c, '\0'};
  std::string numbers;
  for (int i = 0; i < 8192; ++i) numbers += {static_cast<char>(i * 37), static_cast<char>(i / 211)};
  for (const char* name : {"a.spm", "a.txt", "-"}) {
    CAPTURE(name);
    CHECK(known_format(head + numbers, name) == nullptr);
    CHECK(known_format(head + numbers + head, name) == nullptr);
    CHECK(known_format(wide + numbers, name) == nullptr);
    for (const std::string& text : {head + "1 2\r\n", head + "1 2\r\n\x1a" + std::string(5000, '\0'), wide})
      CHECK(known_format(text, name) == &format::text);
  }
}

// Nanoscope's own text was read as a matrix, and others were refused without a name.
TEST_CASE("a file of Nanoscope, WSxM or NanoFocus is called so, and a text of WSxM is a text",
          "[formats][contract]") {
  const std::string numbers("\0\1\2\0\5", 5);
  for (const auto& [bytes, name, words] :
       {std::tuple{"\\*File list\r\n" + numbers, "a.001", "a file of Nanoscope (Bruker, Veeco)"},
        {"?*File list\r\n1 2\r\n3 4\r\n", "a.txt", "a file of Nanoscope (Bruker, Veeco)"},
        {"WSxM file copyright UAM\r\n" + numbers, "-", "a file of WSxM"},
        {numbers, "folder/A.NMS", "a file of NanoFocus (.nms)"},
        {"WSxM file copyright UAM\r\nWSxM ASCII Matrix file\r\n1 2\r\n", "a.txt", ""},
        {"1 2\n3 4\n", "a.nms", ""},
        {numbers, "a.dat", ""}}) {
    CAPTURE(bytes, name);
    CHECK(foreign_format(bytes, name) == words);
    CHECK((known_format(bytes, name) == &format::text) == (words == std::string() && bytes != numbers));
    if (words != std::string()) CHECK_THROWS_WITH(format_of(bytes, name), ContainsSubstring(words));
  }
}

// Marks of missing points became heights.
TEST_CASE("a height that is none is refused with its value, in every unit of length", "[formats][contract]") {
  Map map{.values = Field::Constant(2, 2, 1.70141e38), .spacing = {1, 1}};
  CHECK_THROWS_WITH(dataset_of(map), ContainsSubstring("1.70141e+38 is too much for a height") &&
                                         ContainsSubstring("(`missing`)"));
  map.values(0, 0) = 0;
  set_units(map, "nm");
  CHECK_THROWS_WITH(dataset_of(map), ContainsSubstring("e+38 nm is too much"));
  map.values = Field::Constant(2, 2, 9e19);
  CHECK_NOTHROW(dataset_of(map));
  CHECK_NOTHROW(dataset_of({.values = Field::Constant(2, 2, 1e38), .spacing = {1, 1}, .units = "V"}));
}

TEST_CASE(
    "a format that is written for an extension is one that is read again, the same to the last bit it holds",
    "[formats][exact]") {
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    CHECK(&format_named(format.name, "from") == &format);
    const std::string bytes = format.encode(small_map(), Order::xy);
    if (format.recognises) CHECK(format.recognises(bytes));
    const Field z = small_map().values, read = format.decode(bytes, Order::xy).values;
    const double step = std::ldexp(z.maxCoeff() - z.minCoeff(), -31);
    if (format.numbers == Numbers::doubles) CHECK(same(read, z));
    if (format.numbers == Numbers::singles) CHECK(same(read, z.cast<float>().cast<double>()));
    if (format.numbers == Numbers::steps) CHECK((read - z).abs().maxCoeff() <= 0.501 * step);
  }
}

// A prefix of what a format holds is a smaller map or no map. A text without a count of its numbers may end
// within one, which then has fewer digits.
TEST_CASE("a file that is cut short anywhere is refused, or is a smaller map", "[formats][contract]") {
  for (const Format& format : formats()) {
    const std::string bytes = format.encode(small_map(), Order::xy);
    const Field whole = format.decode(bytes, Order::xy).values;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      CAPTURE(format.name, size);
      try {
        const Map map = format.decode(bytes.substr(0, size), Order::xy);
        const auto [nx, ny] = shape_of(map.values);
        REQUIRE((nx <= whole.rows() && ny <= whole.cols()));
        const auto same = map.values == whole.topLeftCorner(nx, ny);
        const auto both_missing = map.values.isNaN() && whole.topLeftCorner(nx, ny).isNaN();
        CHECK((same || both_missing).count() >= map.values.size() - 1);
      } catch (const DataError&) {
        SUCCEED();
      }
    }
  }
}

TEST_CASE("a dataset of a map with missing points has a mask, and the map is had from it again",
          "[formats][exact]") {
  const Map map = map_with_holes();
  const Dataset data = dataset_of(map);
  CHECK(numbers(data.at("mask").values)[0] == 1);
  CHECK_THROWS_AS(field_of(data, "heights"), DataError);
  CHECK(data.at("heights").attributes.number("actual_range", 0) == -0.5);
  const Map again = map_of(data, "heights");
  CHECK(same(again.values, map.values));
  CHECK(relative_error(again.spacing[1], map.spacing[1]) <= 2 * epsilon);
}

TEST_CASE("a map without a size or without a point makes no dataset", "[formats][contract]") {
  Map map = small_map();
  map.spacing[1] = Map::unknown;
  CHECK_THROWS_WITH(dataset_of(map), Catch::Matchers::Contains("give its `size`"));
  map = small_map();
  map.values.setConstant(std::nan(""));
  CHECK_THROWS_WITH(dataset_of(map), "all points are missing");
}

TEST_CASE("heights in any unit of length become metres, other quantities keep theirs", "[formats][exact]") {
  Map map = small_map();
  set_units(map, "µm");
  CHECK(map.units == "m");
  CHECK(relative_error(map.values(4, 2), 8e-6) <= 2 * epsilon);
  map = small_map();
  set_units(map, "V");
  CHECK(dataset_of(map).at("values").attributes.text("units") == "V");
  CHECK(map.values(4, 2) == 8);
}

TEST_CASE("a unit that is no length, or too long to be one, is kept, and no values become infinite by it",
          "[formats][contract]") {
  for (const std::string unit : {"1e400 m", "0 m", "-1 m", "V", "\xb5"}) {
    Map map = small_map();
    set_units(map, unit);
    CHECK(same(map.values, small_map().values));
    CHECK_THROWS_AS(metres_per(unit), DataError);
  }
  Map map = small_map();
  set_units(map, "m" + std::string(100000, ' '));
  CHECK(map.units == "m" + std::string(41, ' ') + "…" + std::string(21, ' '));
}

// Once no unit at all.
TEST_CASE("a micrometre in Latin-1 is one", "[formats][contract]") {
  Map map = small_map();
  set_units(map, "\xb5m");
  CHECK(map.units == "m");
  CHECK(relative_error(map.values(4, 2), 8e-6) <= 2 * epsilon);
}

// Bytes that are no UTF-8 are Latin-1's; they once were question marks.
TEST_CASE("a title from a file is one line of UTF-8 in the dataset", "[formats][contract]") {
  Map map = small_map();
  map.title = "H\xc3\xb6he \xf6\x1b[31m\n\xe2\x82\xac \xe2\x82 \xed\xa0\x80";
  CHECK(dataset_of(map).at("heights").attributes.text("long_name") == "Höhe ö [31m € \u00e2  \u00ed\u00a0 ");
}

// Refused without a way out in every one of them.
TEST_CASE("an infinite number in a binary file is a missing point, and told", "[formats][exact]") {
  Map map = map_with_holes();
  map.values(1, 1) = HUGE_VAL;
  map.values(2, 2) = -HUGE_VAL;
  Map expected = map;
  expected.values(1, 1) = expected.values(2, 2) = Map::unknown;
  for (const char* name : {"gwy", "npy", "nrrd", "sdf", "x3p"}) {
    CAPTURE(name);
    const Format& format = format_named(name, "from");
    const Map read = format.decode(format.encode(map, Order::xy), Order::xy);
    CHECK(same(read.values, expected.values));
    CHECK(read.understood == "2 infinite values read as missing");
  }
  std::string gsf = format::gsf.encode({.values = Field::Zero(2, 2), .units = "µm"}, Order::xy);
  gsf.replace(gsf.size() - 4, 4, bytes_of(-HUGE_VALF, std::endian::little).data(), 4);
  const Map read = format::gsf.decode(gsf, Order::xy);
  CHECK(std::isnan(read.values(1, 1)));
  CHECK(read.understood == "1 infinite value read as missing");
}

TEST_CASE("numbers of every type, byte order and order of indices come back", "[formats][exact]") {
  Field z(70, 45);
  for (Index i = 0; i < z.size(); ++i) z(i) = static_cast<double>((37 * i) % 120);
  for (int type = 0; type <= static_cast<int>(NumberType::float64); ++type)
    for (const std::endian endian : {std::endian::little, std::endian::big})
      for (const Order order : {Order::xy, Order::yx}) {
        const Raster raster{static_cast<NumberType>(type), endian, order};
        const std::string bytes = bytes_of(z, raster);
        CAPTURE(type, endian == std::endian::big, order == Order::xy);
        CHECK(bytes.size() == 70 * 45 * size_of(raster.type));
        CHECK(same(field_from(bytes, {70, 45}, raster), z));
        CHECK_THROWS_AS(field_from(bytes, {70, 46}, raster), DataError);
      }
}

TEST_CASE("a number that does not fit its integer is refused, one half is rounded to even",
          "[formats][contract]") {
  const Raster byte{NumberType::int8, std::endian::little, Order::xy};
  CHECK_THROWS_AS(bytes_of(Field::Constant(1, 1, 128), byte), DataError);
  CHECK_THROWS_AS(bytes_of(Field::Constant(1, 1, std::nan("")), byte), DataError);
  CHECK(bytes_of(Field::Constant(1, 1, -128), byte) == "\x80");
  CHECK(bytes_of(Field::Constant(1, 1, 2.5), byte) == "\x02");
}

TEST_CASE("a shape that its bytes cannot hold is refused before memory is taken", "[formats][contract]") {
  CHECK_THROWS_AS(check_shape({Index{1} << 40, Index{1} << 40}, 1000), DataError);
  CHECK_THROWS_AS(check_shape({-3, 4}, 1000), DataError);
  CHECK_THROWS_AS(check_shape({0, 4}, 1000), DataError);
  CHECK_NOTHROW(check_shape({10, 100}, 1000));
}
