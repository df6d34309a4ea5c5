// What asperity-convert is told, and what a format cannot keep: nothing of it is dropped without a word.
#include <fstream>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string points = "x [um];y [um];u [V]\n0;0;1.5\n0;1;2\n1;0;1\n1;1;4\n";

void write_text(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name), std::ios::binary) << text;
}

// The line that a command ends with, which must have the status.
std::string told(const std::string& command, int status) {
  const Outcome run = shell(command);
  CAPTURE(command, run.error);
  CHECK(run.exit == status);
  CHECK(lines(run.error) == 1);
  return run.error;
}

}  // namespace

TEST_CASE("a map in volts is refused by formats without units, and every tool names --variable values",
          "[convert][contract]") {
  write_text("v.csv", points);
  CHECK_THAT(told("asperity-convert v.csv --xyz x,y,u -o v.asc", 4), ContainsSubstring("holds only lengths"));
  for (const char* tool : {"asperity-filter --median 3px -o f.nc", "asperity-stats --parameters height"})
    CHECK_THAT(
        shell(std::string("asperity-convert v.csv --xyz x,y,u -q -o v.nc && ") + tool + " v.nc").error,
        ContainsSubstring("heights is missing; the dataset has x, y, values: its map is --variable values"));
  CHECK(shell("asperity-stats --parameters height v.nc --variable values").exit == 0);
}

TEST_CASE("the field of --variable becomes the map in every format, and a wrong name is refused",
          "[convert][contract]") {
  write_text("v.csv", points);
  REQUIRE(shell("asperity-convert v.csv --xyz x,y,u -q -o v.nc").exit == 0);
  for (const char* out : {"o.nc", "o.vti", "o.vtr", "o.nc --to-order yx", "o.gsf"})
    CHECK_THAT(told(std::string("asperity-convert v.nc --variable no -o ") + out, 4),
               ContainsSubstring("no is missing"));
  const Outcome run = shell(
      "asperity-generate --shape 24x16 --size 3mm,1mm --rq 0.4um --length 3px --seed 7 | "
      "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 5N -o c.nc && "
      "asperity-convert c.nc --variable pressure -o p.nc && asperity-convert c.nc --variable pressure -o "
      "p.vti && asperity-convert c.nc --variable heights -o h.nc");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const Dataset from = read_dataset("c.nc"), now = read_dataset("p.nc");
  CHECK((field_of(now, "values") == field_of(from, "pressure")).all());
  CHECK(!now.has("heights"));
  CHECK(!now.has("pressure"));
  CHECK_THAT(shell("head -c 2000 p.vti").out, !ContainsSubstring("\"heights\""));
  CHECK(read_dataset("h.nc").has("pressure"));
}

TEST_CASE("notes and refusals of a text say what was told and what stands in the file",
          "[convert][contract]") {
  write_text("m.txt", "1 2\n3 5\n");
  CHECK_THAT(shell("asperity-convert m.txt --size 2mm --unit um -o m.nc").error,
             !ContainsSubstring("no size given"));
  CHECK_THAT(shell("asperity-stats --parameters height m.txt").error, ContainsSubstring("size"));
  write_text("nm.txt", "# units: nm\n1 2\n3 5\n");
  CHECK_THAT(told("asperity-convert nm.txt --size 2mm --unit um -o m.nc", 2),
             ContainsSubstring("the file gives its own unit, nm: omit it"));
  write_text("v.csv", points);
  CHECK_THAT(told("asperity-convert v.csv --xyz x,y,u --from-order yx -o v.nc", 4),
             ContainsSubstring("--from-order"));
}

TEST_CASE("a profile comes back from SDF with its spacing in y", "[convert][exact]") {
  write_text("p.csv", "x [um];z [nm]\n0;1\n2;5\n4;3\n");
  for (const char* to : {"sdf", "sdf-ascii"}) {
    const Outcome run =
        shell(std::string("asperity-convert p.csv -q -o p.nc && asperity-convert p.nc -o p.out --to ") + to +
              " && asperity-convert p.out -o back.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    const Grid was = grid_of(read_dataset("p.nc")), now = grid_of(read_dataset("back.nc"));
    CHECK(relative_error(now.dx, was.dx) <= 4 * epsilon);
    CHECK(relative_error(now.dy, was.dy) <= 4 * epsilon);
  }
}

TEST_CASE("one note says that a format does not hold that a map is periodic", "[convert][contract]") {
  REQUIRE(shell("asperity-generate --periodic --shape 24x16 --size 3mm,1mm --rq 0.4um --length 3px --seed 7 "
                "-o per.nc")
              .exit == 0);
  for (const char* out : {"a.gsf", "a.x3p", "a.txt", "a.sdf", "a.vti"})
    CHECK_THAT(told(std::string("asperity-convert per.nc -o ") + out, 0), ContainsSubstring("periodic"));
  CHECK(shell("asperity-convert per.nc -o a.nc").error.empty());
}
