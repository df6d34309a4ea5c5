// Two maps in one file, and axes that run backwards.
#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "formats/format.hpp"
#include "maps.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Field heights() { return 1e-6 * random_field({5, 4}, 1); }

std::string refused(const Format& format, const std::string& bytes) {
  try {
    format.decode(bytes, Order::xy);
  } catch (const DataError& e) {
    return e.what();
  }
  return "read";
}

}  // namespace

// np.save twice into one file, or `cat a.gsf b.gsf | tool`: the second was lost without a word.
TEST_CASE("a second map behind the first is refused, in every format that says its size or its unit",
          "[formats][contract]") {
  const Map map{.values = heights(), .spacing = {1e-6, 2e-6}, .units = "m"};
  for (const Format& format : formats()) {
    CAPTURE(format.name);
    const std::string one = format.encode(map, Order::xy);
    CHECK(refused(format, one) == "read");
    const std::string words = refused(format, one + one);
    CHECK(words != "read");
    // a grid of ESRI's and a text of NRRD's hold words where numbers should be
    if (format.name == "esri") continue;
    CHECK_THAT(words, ContainsSubstring(format.name == "x3p" ? "bytes do not belong to the archive"
                                                             : "bytes follow"));
    const std::size_t trailer = format.name == "sdf-ascii" ? 3 : 0;  // a line of its own after the numbers
    CHECK_THAT(words, ContainsSubstring(std::to_string(one.size() + trailer) + " bytes"));
  }
}

TEST_CASE("bytes behind a map are refused by their number, and zeros that pad it are not",
          "[formats][contract]") {
  const Map map{.values = heights(), .spacing = {1e-6, 2e-6}, .units = "m"};
  for (const char* name : {"gsf", "gwy", "nrrd", "npy", "sdf", "sur", "x3p"}) {
    CAPTURE(name);
    const Format& format = format_named(name, "from");
    const std::string one = format.encode(map, Order::xy);
    CHECK(refused(format, one + std::string(64, '\0')) == "read");
    CHECK_THAT(refused(format, one + std::string("\1\2\3", 3)), ContainsSubstring("3 bytes follow its end"));
  }
}

TEST_CASE("the trailer that an SDF may have is no second map", "[formats][contract]") {
  const Map map{.values = heights(), .spacing = {1e-6, 2e-6}, .units = "m"};
  for (const char* name : {"sdf", "sdf-ascii"}) {
    const Format& format = format_named(name, "from");
    const std::string one = format.encode(map, Order::xy);
    CHECK(refused(format, one + "measured on a Tuesday\n*\n") == "read");
    CHECK_THAT(refused(format, one + "*\n" + one), ContainsSubstring("bytes follow"));
  }
}

// Their lengths were taken whatever their signs: a mirrored lay.
TEST_CASE("an NRRD whose axes run against those of its space is turned around, a mirrored one refused",
          "[formats][exact]") {
  const Field z = heights();
  const std::string values = format_named("nrrd", "from").encode({.values = z}, Order::xy);
  const std::string numbers = values.substr(values.find("\n\n") + 2);
  auto read = [&](const std::string& directions) {
    return format::nrrd.decode(
        "NRRD0004\ntype: double\ndimension: 2\nsizes: 5 4\nspace units: \"um\" \"um\"\n"
        "space directions: " +
            directions + "\nendian: little\nencoding: raw\n\n" + numbers,
        Order::xy);
  };
  CHECK((read("(1,0) (0,2)").values == z).all());
  CHECK((read("(-1,0) (0,2)").values == z.colwise().reverse()).all());
  CHECK((read("(1,0) (0,-2)").values == z.rowwise().reverse()).all());
  CHECK((read("(-1,0,0) (0,-2,0)").values == z.reverse()).all());
  CHECK((read("(0.6,0.8) (-0.8,0.6)").values == z).all());
  CHECK(relative_error(read("(-1,0) (0,2)").spacing[0], 1e-6) <= 4 * epsilon);
  CHECK_THROWS_WITH(read("(0,1) (1,0)"), ContainsSubstring("mirror"));
  CHECK_THROWS_WITH(read("(0.6,0.8) (0.8,-0.6)"), ContainsSubstring("mirror"));
}
