// What reading takes is known from a file's head, and refused before it is taken.
#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/gzip.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"
#include "maps.hpp"
#include "x3p_archives.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Reading within(std::size_t bytes) {
  Reading out;
  out.memory = {bytes};
  return out;
}

Map wavy_map() {
  return {.values = random_field({40, 30}, 5), .spacing = {1e-6, 1e-6}, .units = "m", .title = "heights"};
}

// As many elements of a list as there are numbers, in the forms that they may have.
std::string list_of(const Field& z, const std::string& prefix) {
  std::string out;
  for (Index j = 0; j < z.cols(); ++j)
    for (Index i = 0; i < z.rows(); ++i) {
      std::string number;
      append_number(number, z(i, j));
      const bool missing = std::isnan(z(i, j));
      out += missing ? "<" + prefix + "Datum/>\n"
                     : "<" + prefix + "Datum>1;2;" + number + "</" + prefix + "Datum>";
      if ((i + j) % 7 == 0) out += "<!-- a line -->\r\n";
    }
  return out;
}

Description listed(const Field& z, const std::string& third) {
  Description d{.size_x = std::to_string(z.rows()), .size_y = std::to_string(z.cols())};
  d.third = third;
  return d;
}

}  // namespace

// A map of n points takes three doubles a point; 4 kB are more than main.xml of it. Nothing was refused
// before.
TEST_CASE("each format refuses a map that takes more memory than is allowed, and says how much",
          "[formats][memory][contract]") {
  const Map map = wavy_map();
  const std::size_t needed = 3 * sizeof(double) * static_cast<std::size_t>(map.values.size());
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    const std::string bytes = format.encode(map, Order::xy);
    CHECK_NOTHROW(format.decode(bytes, within(needed + 4096)));
    CHECK_THROWS_WITH(format.decode(bytes, within(needed - 1)),
                      ContainsSubstring("reading needs 1MB, the memory limit is 1MB: raise `memory`"));
  }
}

// The head is believed where deflating could yield so much: 100 MB of zeros deflate to 100 kB.
TEST_CASE("what inflates to a large map is refused by its head, the numbers not looked at",
          "[formats][memory][contract]") {
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 10000 10000\nencoding: gzip\n\n";
  CHECK_THROWS_WITH(
      format_named("nrrd", "from").decode(head + std::string(100'000, 'x'), within(2'000'000'000)),
      ContainsSubstring("reading needs 2400MB, the memory limit is 2000MB"));
  CHECK_THROWS_WITH(
      format_named("nrrd", "from").decode(head + std::string(100'000, 'x'), within(2'400'000'000)),
      ContainsSubstring("the gzip data are damaged"));
}

TEST_CASE("a text of more numbers than are allowed is refused with what its lines let expect",
          "[formats][text][memory][contract]") {
  std::string text;
  for (int line = 0; line < 1000; ++line) text += "1\t2\t3\t4\t5\t6\t7\t8\t9\t10\n";
  CHECK(matrix_of(text, "map", 1, within(10'000 * 24)).size() == 10'000);
  CHECK_THROWS_AS(matrix_of(text, "map", 1, within(10'000 * 24 - 1)), DataError);
}

// Of a thousand right sums main.xml was digested a thousand times; the size was that which a zip can claim.
TEST_CASE("a file of checksums is read if it is no larger than such a file is",
          "[formats][memory][contract]") {
  const std::string data =
      bytes_of(small_map().values, {NumberType::float64, std::endian::little, Order::yx});
  Description d{.size_x = "5", .size_y = "3"};
  d.third = link(data);
  const std::string main = main_xml(d), line = x3p::md5_of(main) + " *main.xml\n";
  const auto with = [&](std::size_t lines) {
    std::string sums;
    for (std::size_t i = 0; i < lines; ++i) sums += line;
    return deflated({{"bindata/data.bin", data}, {"main.xml", main}, {"md5checksum.hex", sums}});
  };
  CHECK(same(format::x3p.decode(with(1000), {}).values, small_map().values));
  CHECK_THROWS_WITH(format::x3p.decode(with(2000), {}),
                    ContainsSubstring("md5checksum.hex claims 86000 bytes"));
}

// Each < would be looked behind to the end: a second for 100 kB, minutes for 1 MB.
TEST_CASE("a main.xml of beginnings alone is refused in a time of its size", "[formats][contract]") {
  for (const std::string& main :
       {std::string(1'000'000, '<'), "<DataList>" + std::string(1'000'000, '<') + "</DataList>"})
    CHECK_THROWS_AS(format::x3p.decode(deflated({{"main.xml", main}}), {}), DataError);
}

// 150 × 90 numbers in 500 kB are parsed in eight pieces; the lists beside them are none.
TEST_CASE("a list of numbers that is parsed by pieces holds what it does as a whole", "[formats][exact]") {
  Field z = random_field({150, 90}, 11);
  z(0, 0) = z(77, 3) = z(149, 89) = std::nan("");
  for (const std::string prefix : {"", "p:"}) {
    const std::string open = "<" + prefix + "DataList>", close = "</" + prefix + "DataList>",
                      list = open + list_of(z, prefix) + close;
    for (const std::string& before :
         {std::string(), "<!-- " + open + " -->", std::string("<a><![CDATA[<DataList>]]></a>"),
          std::string("<Vendor><DataList><Datum>7</Datum></DataList></Vendor>")}) {
      CAPTURE(prefix, before);
      const std::string main = main_xml(listed(z, before + list));
      REQUIRE(main.size() > 400'000);
      CHECK(same(format::x3p.decode(deflated({{"main.xml", main}}), {}).values, z));
    }
  }
  CHECK_THROWS_WITH(
      format::x3p.decode(deflated({{"main.xml", main_xml(listed(z, "<DataList>" + list_of(z, "")))}}), {}),
      ContainsSubstring("is not valid XML"));
}
