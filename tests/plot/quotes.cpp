// Text of users and of files in pictures that gnuplot really draws.
#include <fstream>
#include <iterator>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// What gnuplot has a meaning for: ends of strings, escapes, commands, macros, enhanced text, formats; and
// what XML has.
const std::string hard[] = {"'Ground' steel",
                            "''",
                            "'",
                            "it''s '",
                            R"(back\slash \n \101)",
                            "`date` $(date)",
                            "@name ^2 _3 {a} & ~b",
                            "50 % %s %g",
                            "-0.5037 (12)",
                            "\"quoted\" <b>&amp;</b>",
                            "a ]]> b",
                            "µm σ × 17"};

std::string in_shell(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// The texts of an SVG, as they are read, a line each.
std::string words_of(const std::string& name) {
  const Outcome run = shell("python3 -c 'import sys, xml.etree.ElementTree as t\nfor e in t.parse(\"" + name +
                            "\").iter():\n if e.tag.endswith(\"}text\"): print(\"\".join(e.itertext()))'");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  return run.out;
}

// Heights and values of a unit and a name of their own.
void write_scene(const std::string& unit, const std::string& name) {
  const Grid grid{{12, 10}, 1e-6, 1e-6};
  Dataset data;
  set_grid(data, grid);
  set_field(data, "heights", 1e-7 * random_field(grid.shape, 1), {"m", "height"});
  set_field(data, "values", random_field(grid.shape, 2), {unit, name});
  write_dataset(data, "quoted.nc");
}

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != text.npos;
}

}  // namespace

// A title in single quotes that began or ended with one: "unexpected or unrecognized token: 'Ground''
// steel'".
TEST_CASE("a title stands in the picture letter by letter, whatever gnuplot means by them",
          "[plot][contract][slow]") {
  write_scene("V", "voltage");
  for (const std::string& title : hard) {
    const Outcome run =
        shell("asperity-plot quoted.nc --kind map -o a.svg --title " + in_shell(title) + "; ls");
    CAPTURE(title, run.error);
    CHECK((run.exit == 0 && run.error.empty()));
    CHECK(has_line(words_of("a.svg"), title));
  }
}

TEST_CASE("names of files, units and quantities stand in the picture letter by letter",
          "[plot][contract][slow]") {
  for (const std::string& text : hard) {
    write_scene(text, "of " + text);
    const Outcome run = shell("cp quoted.nc " + in_shell("2 " + text.substr(0, text.find('/')) + ".nc") +
                              "; asperity-plot quoted.nc 2*.nc --variable values --kind map --pixels "
                              "1000x1500 -o a.svg; status=$?; rm 2*.nc; "
                              "exit $status");
    CAPTURE(text, run.error);
    CHECK((run.exit == 0 && run.error.empty()));
    const std::string words = words_of("a.svg");
    CHECK(has_line(words, "of " + text + " [" + text + "]"));
    CHECK(has_line(words, "2 " + text.substr(0, text.find('/'))));
  }
}

TEST_CASE("a unit in Latin-1, with control characters or of 100 kB is drawn as a line of UTF-8",
          "[plot][contract]") {
  write_scene("\xb5m\x1b[31m\n", "h\xf6he");
  for (const char* picture : {"a.svg", "a.png", "a.pdf"}) {
    const Outcome run =
        shell(std::string("asperity-plot quoted.nc --variable values --kind map -o ") + picture);
    CAPTURE(picture, run.error);
    CHECK((run.exit == 0 && run.error.empty()));
  }
  CHECK(has_line(words_of("a.svg"), "höhe [µm [31m ]"));
  write_scene(std::string(100000, 'a'), "long");
  CHECK(shell("asperity-plot quoted.nc --variable values --kind map -o a.svg && test $(stat -c %s a.svg) -lt "
              "100000")
            .exit == 0);
}
