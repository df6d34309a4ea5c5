// The archive of an X3P: where its entries are, and as nobody should write them.
#include "core/error.hpp"
#include "maps.hpp"
#include "x3p_archives.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

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

// Two of the four files of x3ptools are zipped so, one of them with another root.
TEST_CASE(
    "an X3P in a folder of the archive is read from there, its checksums too, whatever its strokes and root",
    "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  Description d;
  d.third = link(data);
  std::string main = main_xml(d);
  for (std::size_t at = 0; (at = main.find("p:ISO5436_2", at)) != main.npos;) main.replace(at, 11, "ISO5436");
  const std::string right = x3p::md5_of(main) + " *main.xml", wrong = x3p::md5_of("") + " *main.xml";
  const Entries beside{{"__MACOSX/map/._main.xml", "?"}, {"map/.DS_Store", "?"}, {"bindata/data.bin", "?"}};
  for (const char* stroke : {"/", "\\"}) {
    const std::string folder = std::string("a map") + stroke;
    const auto read = [&](const std::string& sum) {
      Entries entries = beside;
      entries.insert(entries.end(), {{folder + "bindata" + stroke + "data.bin", data},
                                     {folder + "main.xml", main},
                                     {folder + "md5checksum.hex", sum}});
      return decode(deflated(entries)).values;
    };
    CHECK(same(read(right), whole_heights()));
    CHECK_THROWS_WITH(read(wrong), ContainsSubstring("main.xml is damaged"));
  }
  CHECK_THROWS_WITH(decode(deflated({{"a/main.xml", main}, {"b/main.xml", main}})),
                    ContainsSubstring("'a/main.xml' and 'b/main.xml'"));
}

// Some programs take the first of them, others the last: two maps in one file, exit status 0.
TEST_CASE("an X3P with two entries of one name is refused if it needs them", "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  Description d;
  d.third = link(data, "\x3F");
  const std::string main = main_xml(d);
  const auto read = [&](const std::string& other, const std::string& name) {
    std::string bytes = deflated({{"main.xml", main},
                                  {"bindata/data.bin", data},
                                  {"bindata/valid.bin", "\x3F"},
                                  {"md5checksum.hex", x3p::md5_of(main)},
                                  {other, "?"}});
    for (std::size_t at = 0; (at = bytes.find(other, at)) != bytes.npos; ++at)
      bytes.replace(at, name.size(), name);
    return decode(bytes).values;
  };
  CHECK(same(read("mainXxml", "mainXxml"), whole_heights()));
  CHECK_THROWS_WITH(read("mainXxml", "main.xml"), ContainsSubstring("'main.xml' and 'main.xml'"));
  for (const std::string name : {"bindata/data.bin", "bindata/valid.bin", "md5checksum.hex"}) {
    const std::string other = name.substr(0, name.size() - 3) + "???";
    CHECK_THROWS_WITH(read(other, name), ContainsSubstring("'" + name + "' in the archive is there twice"));
  }
}

TEST_CASE("a wrong checksum of an X3P is named", "[formats][contract]") {
  Description d;
  const std::string data = numbers_of_type(NumberType::float64), digest = x3p::md5_of("something else");
  d.third = link(data);
  const std::string main = main_xml(d);
  CHECK_THROWS_WITH(
      decode(deflated(
          {{"main.xml", main}, {"bindata/data.bin", data}, {"md5checksum.hex", digest + " *main.xml"}})),
      "main.xml is damaged: its checksum is wrong (was it edited? Then leave out md5checksum.hex)");
  d.third = link("something else");
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", main_xml(d)}, {"bindata/data.bin", data}})),
                    "bindata/data.bin is damaged: its checksum is wrong");
  d.third = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
  CHECK_NOTHROW(decode(deflated({{"main.xml", main_xml(d)}, {"bindata/data.bin", data}})));
}

TEST_CASE("what an X3P says of itself must be a surface or a profile of one layer, of the size of its numbers",
          "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  const auto refused = [&](const Description& d, const char* words) {
    CHECK_THROWS_WITH(decode(foreign_x3p(d, data)), ContainsSubstring(words));
  };
  CHECK_NOTHROW(decode(foreign_x3p({}, data)));
  refused({.feature = "PCL"}, "FeatureType 'PCL' in main.xml is not supported, only SUR, a surface, and PRF");
  refused({.feature = "PRF"}, "a profile, FeatureType PRF, but SizeY is 2 and not 1");
  refused({.type = "X"}, "number type 'X' is not supported, only I, L, F, D");
  refused({.type = "F"}, "has 48 bytes, the map needs 24");
  refused({.size_x = "4"}, "cut short");
  refused({.size_x = "2"}, "has 48 bytes, the map needs 32");
  refused({.size_x = "-3"}, "the map has no points");
  refused({.size_x = "4611686018427387904", .size_y = "4611686018427387904"}, "cut short");
  refused({.size_x = "3.5"}, "is not a whole number");
  refused({.size_z = "2"}, "more than one layer");
  refused({.dx = "1</Increment><Increment>2"}, "Increment is there twice");
  refused({.dx = "0"}, "Increment 0 of CX in main.xml is not positive");
  refused({.dy = "-1e-6"}, "of CY in main.xml is not positive");
  refused({.dy = "inf"}, "is not a number");
  refused({.z = "<Increment>0</Increment>"}, "Increment of CZ in main.xml is missing or 0");
  refused({.type = "I"}, "Increment of CZ in main.xml is missing or 0");
}

TEST_CASE("an archive that is no X3P, links outside itself or has its numbers elsewhere is refused",
          "[formats][contract]") {
  const std::string data = numbers_of_type(NumberType::float64);
  CHECK_THROWS_WITH(decode("PK\x03\x04 and nothing"), ContainsSubstring("not a zip archive"));
  const std::pair<const char*, const char*> others[] = {
      {"word/document.xml", "the zip archive, with 'word/document.xml', is not X3P, for main.xml is missing"},
      {"a.zmg", "wrote it (`from` gwyddion)"},
      {"z.npy", "NumPy (npz), not X3P: save the map alone"},
      {"xl/workbook.xml", "save its sheet as text"},
      {"content.xml", "save its sheet as text"}};
  for (const auto& [name, words] : others)
    CHECK_THROWS_WITH(decode(deflated({{name, "<a/>"}, {"Xmain.xml", "<a/>"}})), ContainsSubstring(words));
  for (const char* path : {"../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd"}) {
    Description d;
    d.third = "<DataLink><PointDataLink>" + std::string(path) + "</PointDataLink></DataLink>";
    CHECK_THROWS_WITH(decode(deflated({{"main.xml", main_xml(d)}})),
                      ContainsSubstring("'" + std::string(path) + "' in the archive is missing"));
  }
  CHECK_THROWS_AS(decode(deflated({{"main.xml", "no <xml"}})), DataError);
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", "<a><b/></a>"}})), ContainsSubstring("Record1 is missing"));
  Description both;
  both.third = link(data) + "<DataList><Datum>1</Datum></DataList>";
  CHECK_THROWS_WITH(decode(deflated({{"main.xml", main_xml(both)}, {"bindata/data.bin", data}})),
                    ContainsSubstring("both a DataLink and a DataList"));
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
