#include <zlib.h>

#include "core/error.hpp"
#include "formats/format.hpp"
#include "formats/gzip.hpp"
#include "formats/raster.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A file of 2 × 1 numbers, unless the fields say otherwise.
std::string nrrd(const std::string& fields, const std::string& numbers,
                 const std::string& sizes = "dimension: 2\nsizes: 2 1\n") {
  return "NRRD0004\n# comment: 3\n" + sizes + fields + "\n" + numbers;
}

std::string raw(const std::string& type, const std::string& endian = "little") {
  return "type: " + type + "\nencoding: raw\nendian: " + endian + "\n";
}

const std::string bytes = "type: uint8\nencoding: raw\n";

std::array<double, 2> pair(const std::string& fields, const std::string& numbers) {
  const Map map = format::nrrd.decode(nrrd(fields, numbers), Order::xy);
  REQUIRE(shape_of(map.values) == Shape{2, 1});
  return {map.values(0, 0), map.values(1, 0)};
}

std::array<double, 2> spacing(const std::string& fields,
                              const std::string& sizes = "dimension: 2\nsizes: 2 3\n") {
  return format::nrrd.decode(nrrd(bytes + fields, "123456", sizes), Order::xy).spacing;
}

// As gzip makes it.
std::string gzip(const std::string& text) {
  std::string out(compressBound(text.size()) + 64, '\0');
  z_stream stream{};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string in = text;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

}  // namespace

TEST_CASE("an NRRD is read in every type of number, by its names, and order of its bytes",
          "[formats][exact]") {
  using Pair = std::array<double, 2>;
  for (const std::string type : {"signed char", "int8", "int8_t"})
    CHECK(pair(raw(type), "\xff\x7f") == Pair{-1, 127});
  for (const std::string type : {"uchar", "unsigned char", "UINT8"})
    CHECK(pair(raw(type), "\xff\x7f") == Pair{255, 127});
  CHECK(pair(raw("short"), std::string("\xfe\xff\0\1", 4)) == Pair{-2, 256});
  CHECK(pair(raw("int16_t", "big"), std::string("\xff\xfe\1\0", 4)) == Pair{-2, 256});
  CHECK(pair(raw("unsigned short int", "big"), std::string("\xff\xfe\1\0", 4)) == Pair{65534, 256});
  CHECK(pair(raw("int"), std::string("\xff\xff\xff\xff\0\0\1\0", 8)) == Pair{-1, 65536});
  CHECK(pair(raw("uint32"), std::string("\xff\xff\xff\xff\0\0\1\0", 8)) == Pair{4294967295.0, 65536});
  CHECK(pair(raw("long long", "big"), std::string("\xff\xff\xff\xff\xff\xff\xff\xff\0\0\0\1\0\0\0\0", 16)) ==
        Pair{-1, 4294967296.0});
  CHECK(pair(raw("ulonglong", "big"), std::string("\0\0\0\0\0\0\0\2\0\0\0\1\0\0\0\0", 16)) ==
        Pair{2, 4294967296.0});
  CHECK(pair(raw("float", "big"), std::string("\x3f\x80\0\0\xc0\x20\0\0", 8)) == Pair{1, -2.5});
  CHECK(pair(raw("double"), std::string("\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\x04\xc0", 16)) == Pair{1, -2.5});
  CHECK(pair("type: double\nencoding: ascii\n", "1\n-2.5\n") == Pair{1, -2.5});
}

TEST_CASE("an NRRD's first axis is x, and axes of one point are left out", "[formats][exact]") {
  Field z(2, 3);
  z << 49, 51, 53, 50, 52, 54;
  for (const std::string sizes :
       {"dimension: 2\nsizes: 2 3\n", "dimension: 3\nsizes: 2 3 1\n", "dimension: 4\nsizes: 1 2 1 3\n"})
    CHECK(same(format::nrrd.decode(nrrd(bytes, "123456", sizes), Order::xy).values, z));
  CHECK(spacing("spacings: 7 1 2\nunits: \"s\" \"nm\" \"mm\"\n", "dimension: 3\nsizes: 1 2 3\n")[1] == 2e-3);
}

TEST_CASE("an NRRD's spacing is had from spacings, from mins and maxs, or from space directions",
          "[formats][exact]") {
  const auto nearly = [](std::array<double, 2> a, double x, double y) {
    CHECK(relative_error(a[0], x) <= 4 * epsilon);
    CHECK(relative_error(a[1], y) <= 4 * epsilon);
  };
  const std::string units = "units: \"µm\" \"mm\"\n", ends = "axis mins: 1 2\naxismaxs: 5 5\n";
  nearly(spacing("spacings: 1.5 2\n" + units), 1.5e-6, 2e-3);
  nearly(spacing(ends + units), 2e-6, 1e-3);
  nearly(spacing(ends + units + "centerings: node cell\n"), 4e-6, 1e-3);
  nearly(spacing("space dimension: 2\nspace units: \"mm\" \"mm\"\nspace directions: (0.3, 0.4) (-2,0)\n"),
         0.5e-3, 2e-3);
  for (const std::string fields :
       {"spacings: 1 2\n", "spacings: nan nan\nunits: \"m\" \"m\"\n", "units: \"m\" \"m\"\n",
        "space directions: (1,0) (0,1)\n", "space units: \"m\" \"m\"\nspace directions: none none\n"})
    CHECK(std::isnan(spacing(fields)[0]));
}

// The first of them was taken.
TEST_CASE("spacings of an NRRD that disagree are refused, those that agree are not", "[formats][contract]") {
  const std::string units = "units: \"um\" \"um\"\n", once = "spacings: 1 2\n" + units;
  const std::string space = "space units: \"um\" \"um\"\nspace directions: (1,0) (0,2)\n";
  for (const std::string more : {"spacings: 1 2\n", "axis mins: 0 0\naxis maxs: 2 6\n",
                                 "axis mins: 1 1\naxismaxs: 2 5\n", space.c_str(), "spacings:=7 7\n"}) {
    CAPTURE(more);
    CHECK(relative_error(spacing(once + more)[1], 2e-6) <= 4 * epsilon);
  }
  for (const std::string more : {"spacings: 1 1\n", "axis mins: 0 0\naxis maxs: 2 4.5\n",
                                 "axis mins: 0 0\naxis maxs: 2 4\ncenters: cell cell\n",
                                 "space units: \"um\" \"um\"\nspace directions: (1,0) (0,3)\n",
                                 "units: \"um\" \"nm\"\n", "sizes: 3 2\n"}) {
    CAPTURE(more);
    CHECK_THROWS_WITH(spacing(once + more), ContainsSubstring("remove one"));
  }
  CHECK_THROWS_WITH(spacing(units + "axis mins: 0 0\naxismins: 1 1\naxis maxs: 2 6\n"),
                    ContainsSubstring("given twice"));
}

TEST_CASE("an NRRD's values have its sample units, and its content is their title", "[formats][exact]") {
  const Map map =
      format::nrrd.decode(nrrd(bytes + "sample units: nm\ncontent: a: b\nkey:=value\n", "\1\2"), Order::xy);
  CHECK(map.values(1, 0) == 2e-9);
  CHECK(map.units == "m");
  CHECK(map.title == "a: b");
  CHECK(format::nrrd.decode(nrrd(bytes + "sample units: \"V\"\n", "\1\2"), Order::xy).units == "V");
  CHECK(format::nrrd.decode(nrrd(bytes, "\1\2"), Order::xy).units.empty());
}

TEST_CASE("what is written as NRRD is read again the same, missing points and an unknown size too",
          "[formats][exact]") {
  Map map = map_with_holes();
  const Map again = format::nrrd.decode(format::nrrd.encode(map, Order::xy), Order::xy);
  CHECK(same(again.values, map.values));
  CHECK(again.spacing == map.spacing);
  CHECK(again.units == "m");
  map.spacing[0] = Map::unknown;
  CHECK(std::isnan(format::nrrd.decode(format::nrrd.encode(map, Order::xy), Order::xy).spacing[0]));
}

TEST_CASE("numbers of an NRRD in gzip are read, and refused when they are damaged, fewer or more",
          "[formats][exact]") {
  const std::string fields = "type: uint8\nencoding: gzip\n", sizes = "dimension: 2\nsizes: 500 400\n";
  std::string text(200000, '\7');
  for (std::size_t i = 0; i < text.size(); i += 3) text[i] = static_cast<char>(i % 101);
  const std::string packed = gzip(text);
  const Map map = format::nrrd.decode(nrrd(fields, packed, sizes), Order::xy);
  CHECK(map.values(499, 399) == text[199999]);
  CHECK(map.values(1, 3) == text[1501]);
  const auto refused = [&](const std::string& numbers, const std::string& with) {
    CHECK_THROWS_WITH(format::nrrd.decode(nrrd(fields, numbers, sizes), Order::xy), ContainsSubstring(with));
  };
  refused(packed.substr(0, packed.size() - 1), "damaged");
  refused(packed.substr(0, packed.size() / 2), "damaged or cut short");
  refused(gzip(text + '\1'), "hold more");
  refused(gzip(text.substr(1)), "cut short");
  refused("no gzip at all" + std::string(1000, '\0'), "damaged");
  refused("\x1f\x8b", "points of 500 x 400");
  std::string wrong = packed;
  wrong[wrong.size() - 6] = static_cast<char>(wrong[wrong.size() - 6] ^ 1);
  refused(wrong, "damaged");
}

TEST_CASE("inflating asks for no memory that the bytes cannot fill", "[formats][contract]") {
  CHECK_THROWS_WITH(inflated("abc", std::size_t{1} << 60), ContainsSubstring("3 bytes of gzip cannot hold"));
  CHECK(inflated(gzip("abc"), 3) == "abc");
}

TEST_CASE("an NRRD that lies about itself, or names other files, is refused with what is wrong",
          "[formats][contract]") {
  const auto refused = [](const std::string& file, const std::string& with) {
    CHECK_THROWS_WITH(format::nrrd.decode(file, Order::xy), ContainsSubstring(with));
  };
  const std::string one = "\1\2";
  refused("NRRD0006\n\n", "is not NRRD");
  refused("NRRD0004\ntype: int\n", "no end");
  refused(nrrd(bytes + "data file: /etc/passwd\n", one), "another file");
  refused(nrrd(bytes + "datafile: LIST\n", one), "another file");
  refused(nrrd(bytes + "byte skip: -1\n", one), "byte skip");
  refused(nrrd(bytes + "lineskip: 2\n", one), "line skip");
  refused(nrrd("encoding: raw\n", one), "number type ''");
  refused(nrrd(raw("block"), one), "number type 'block'");
  refused(nrrd(raw("int8||uint8"), one), "is not supported");
  refused(nrrd("type: short\nencoding: raw\n", "1234"), "endian '' in the header is not little or big");
  refused(nrrd("type: uint8\nencoding: bzip2\n", one), "encoding 'bzip2' is not supported");
  refused(nrrd(bytes, "\1"), "cut short");
  refused(nrrd(bytes, one, "dimension: 3\nsizes: 2 1\n"), "2 sizes for dimension 3");
  refused(nrrd(bytes, one, "dimension: 1\nsizes: 2\n"), "1 dimension");
  refused(nrrd(bytes, one, "dimension: 3\nsizes: 2 2 2\n"), "3 dimensions");
  refused(nrrd(bytes, one, "dimension: 2\nsizes: 2 -1\n"), "the map has no points");
  refused(nrrd(bytes, one, "dimension: 2\nsizes: 4611686018427387904 4611686018427387904\n"), "cut short");
  refused(nrrd(bytes, one, "dimension: 17\nsizes: 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"),
          "more than 16 dimensions");
  refused(nrrd(bytes + "spacings: 1 x\nunits: \"m\" \"m\"\n", one), "spacings 'x' in the header");
  refused(nrrd(bytes + "spacings: -1 1\nunits: \"m\" \"m\"\n", one), "not positive");
  refused(nrrd(bytes + "space units: \"m\" \"m\"\nspace directions: (1,a) (0,1)\n", one),
          "space directions 'a' in the header");
  refused(nrrd("type: double\nencoding: text\n", "1 2 3"), "has 3 numbers");
}
