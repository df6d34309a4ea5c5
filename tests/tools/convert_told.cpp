// What asperity-convert is told, and what a format cannot keep: nothing of it is dropped without a word.
#include <fstream>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/maps.hpp"

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

// The refusal of a text without a size names --size, which a dataset then refused: x was missing all the same.
TEST_CASE("a bare array of NetCDF gets its axes, size and unit from the options, like a text",
          "[convert][exact]") {
  const std::vector<double> nm{1, 2, 3, 4, 5, 6};
  const auto convert = [&](Dataset data, const std::string& options) {
    write_dataset(data, "bare.nc");
    require("asperity-convert bare.nc -o whole.nc --size 3mm,1mm " + options);
    return read_dataset("whole.nc");
  };
  const auto bare = [&](const char* slow, const char* fast) {
    return Dataset{{{slow, 3}, {fast, 2}}, {{"heights", {slow, fast}, nm, {}}}, {}, {}};
  };
  const Field heights = 1e-9 * Eigen::Map<const Field>(nm.data(), 3, 2);
  for (const Dataset& one :
       {convert(bare("x", "y"), "--unit nm"), convert(bare("row", "column"), "--unit nm")}) {
    CHECK(same_bits(field_of(one, "heights"), heights));
    CHECK(relative_error(grid_of(one).size_x(), 3e-3) <= 2 * epsilon);
    CHECK(relative_error(grid_of(one).size_y(), 1e-3) <= 2 * epsilon);
  }
  const Field turned = heights.transpose();
  CHECK(same_bits(field_of(convert(bare("y", "x"), "--unit nm"), "heights"), turned));
  CHECK(same_bits(field_of(convert(bare("a", "b"), "--unit nm --from-order yx"), "heights"), turned));
  Dataset other = bare("i", "j");  // what stands on the same dimensions goes with it
  other.find("heights")->name = "z";
  other.find("z")->attributes.set("units", "nm");
  other.put({"mask", {"i", "j"}, std::vector<std::int8_t>{0, 0, 1, 0, 0, 0}, {}});
  const Field masked = field_of(convert(other, "--variable z"), "heights", Missing::not_a_number);
  CHECK((std::isnan(masked(1, 0)) && masked.isNaN().count() == 1 && masked(1, 1) == heights(1, 1)));
  Dataset counted = bare("x", "y");  // samples in place of metres
  counted.put({"x", {"x"}, std::vector<double>{0, 1, 2}, {}});
  CHECK(same_bits(field_of(convert(counted, "--unit nm"), "heights"), heights));
  CHECK_THAT(told("asperity-convert bare.nc --unit nm -o o.nc", 4), ContainsSubstring("x has no unit"));
  write_dataset(bare("row", "column"), "bare.nc");
  CHECK_THAT(told("asperity-stats bare.nc", 4),
             ContainsSubstring("x is missing") && ContainsSubstring("--size"));
  CHECK_THAT(told("asperity-convert bare.nc --size 3mm -o o.nc", 4),
             ContainsSubstring("heights has no unit"));
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
