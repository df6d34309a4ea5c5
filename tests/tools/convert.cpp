// asperity-convert, and the formats that every tool reads.
#include <fstream>

#include "dataset/layout.hpp"
#include "formats/format.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string surface =
    "asperity-generate --shape 24x16 --size 3mm,1mm --rq 0.4um --length 3px --seed 7 -o surface.nc && ";

void write_text(const std::string& name, const std::string& text) {
  std::ofstream(scratch(name), std::ios::binary) << text;
}

// 6 × 4 heights 10 i + j [µm], one of them missing.
void write_numbers() {
  write_text("numbers.txt",
             "# Channel: numbers\n# Width: 6 um\n# Height: 8 um\n# Value units: um\n"
             "0 10 20 30 40 50\n1 11 21 nan 41 51\n2 12 22 32 42 52\n3 13 23 33 43 53\n");
}

Field heights_in(const std::string& name) {
  return field_of(read_dataset(name), "heights", Missing::not_a_number);
}

}  // namespace

// gsf holds 24 bits: heights within half a unit of the 24th, 6e-8 of the largest. sur holds 2^31 steps of the
// range, which is at most twice the largest, and 24 bits of a spacing.
TEST_CASE("a surface comes back from every format the same, with its spacing", "[convert][exact]") {
  REQUIRE(shell(surface + "true").exit == 0);
  const Field heights = heights_in("surface.nc");
  for (const Format& format : formats()) {
    const std::string name(format.name);
    CAPTURE(name);
    const bool bare = name == "npy";
    const Outcome run =
        shell("asperity-convert surface.nc --to " + name + " -o there && asperity-convert there --from " +
              name + (bare ? " --size 3mm,1mm" : "") + " -o back.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    const double digits = name == "gsf"   ? 6e-8
                          : name == "sur" ? 5e-10
                                          : 0,
                 of_spacing = name == "sur" ? 6e-8 : 1e-9;
    CHECK((heights_in("back.nc") - heights).abs().maxCoeff() <= digits * heights.abs().maxCoeff());
    const Grid grid = grid_of(read_dataset("back.nc"));
    CHECK(relative_error(grid.dx, 3e-3 / 24) <= of_spacing);
    CHECK(relative_error(grid.dy, 1e-3 / 16) <= of_spacing);
  }
}

TEST_CASE("a matrix in text has the order, the size and the unit that it is given", "[convert][exact]") {
  write_text("matrix.txt", "1,2,3\n4,5,6\n");
  REQUIRE(shell("asperity-convert matrix.txt --from-order yx --size 6mm,4mm --unit nm -o m.nc").exit == 0);
  const Field z = heights_in("m.nc");
  REQUIRE(shape_of(z) == Shape{3, 2});
  CHECK(relative_error(z(2, 1), 6e-9) <= 2 * epsilon);
  CHECK(relative_error(grid_of(read_dataset("m.nc")).dy, 2e-3) <= 4 * epsilon);
  const Outcome back = shell("asperity-convert m.nc --to text --to-order yx");
  CHECK_THAT(back.out, ContainsSubstring("\n# order: yx\n1e-09\t"));
  CHECK(lines(back.out) == 5);
}

TEST_CASE("every tool reads a text with labels as it stands, and says in one line what it understood",
          "[convert][contract]") {
  write_text("labels.csv", "Sample;A\nX [um];Y [um];Z [nm]\n0,5;0;1,5\n0;0;2\n0;1;-9999\n0,5;1;void\n");
  const Outcome run = shell("asperity-stats --parameters height labels.csv");
  CHECK(run.exit == 0);
  CHECK_THAT(run.error,
             ContainsSubstring("asperity-stats: labels.csv: read as a map of 2 x 2, points x y z"));
  CHECK_THAT(shell("asperity-stats --parameters height -q labels.csv").error, !ContainsSubstring("read as"));
  REQUIRE(shell("asperity-convert labels.csv --missing -9999 --missing x -o told.nc").exit == 0);
  CHECK(heights_in("told.nc").isNaN().count() == 2);
  const Outcome config = shell("asperity-convert --missing -9999 --missing x --dump-config");
  CHECK_THAT(config.out, ContainsSubstring("missing = [\"-9999\", \"x\"]"));
}

// Each of them was read, shifted or cut into columns, without a word.
TEST_CASE("a text that can be read in two ways is refused until an option tells, by every tool",
          "[convert][contract]") {
  write_text("both.csv", "1,5\n3,5\n2,5\n");
  write_text("xyz.txt", "# units: nm\n0 0 1\n0 2 2\n1 0 3\n1 2 4\n2 0 5\n2 2 6\n");
  write_text("xz.txt", "0 1\n1 2\n2 4\n");
  write_text("spaced.csv", "1,5, 2,5, 3,5\n4,5, 5,5, 6,5\n");  // six numbers a line, or three
  const std::pair<const char*, const char*> cases[] = {{"both.csv", "the --separator or the --decimal mark"},
                                                       {"spaced.csv", "that the comma is the separator"},
                                                       {"xyz.txt", "(--xyz 1/um,2/um,3/nm)"},
                                                       {"xz.txt", "(--xyz none)"}};
  for (const auto& [file, option] : cases)
    for (const char* tool :
         {"asperity-convert ", "asperity-stats --parameters height ", "asperity-acf --max-lag 1x1 "}) {
      const Outcome run = shell(std::string(tool) + file);
      CAPTURE(file, tool, run.error);
      CHECK(run.exit == 4);
      CHECK(lines(run.error) == 1);
      CHECK_THAT(run.error, ContainsSubstring(option));
    }
  auto converted = [](const std::string& arguments) {
    const Outcome run = shell("asperity-convert " + arguments + " -o told.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return heights_in("told.nc");
  };
  CHECK(shape_of(converted("both.csv --separator comma --size 1mm")) == Shape{3, 2});
  CHECK(shape_of(converted("spaced.csv --separator comma --size 1mm")) == Shape{2, 6});
  CHECK(converted("both.csv --decimal comma --size 1mm").col(0)(1) == 3.5);
  CHECK(shape_of(converted("xyz.txt --xyz none --size 1mm")) == Shape{6, 3});
  const Field z = converted("xyz.txt --xyz 1/mm,2/mm,3");
  REQUIRE(shape_of(z) == Shape{3, 2});
  CHECK(relative_error(z(2, 1), 6e-9) <= 2 * epsilon);
  CHECK(relative_error(grid_of(read_dataset("told.nc")).dy, 2e-3) <= 2 * epsilon);
  CHECK(shape_of(converted("xz.txt --xyz 1/um,2/um")) == Shape{3, 1});
}

TEST_CASE("what an option tells of a text is refused where the input is none, or says so itself",
          "[convert][contract]") {
  REQUIRE(shell(surface + "asperity-convert surface.nc -o map.gsf").exit == 0);
  write_numbers();
  for (const char* arguments :
       {"surface.nc --separator tab", "map.gsf --decimal comma", "numbers.txt --xyz 1/um,2",
        "numbers.txt --xyz none", "surface.nc --missing -9999",
        "numbers.txt --separator comma --decimal comma", "numbers.txt --separator word"}) {
    const Outcome run = shell(std::string("asperity-convert ") + arguments + " -o out.nc");
    CAPTURE(arguments, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
  }
}

TEST_CASE("every tool of the chain reads a map as it stands, its missing points left out or refused",
          "[convert][contract]") {
  write_numbers();
  const Outcome stats = shell("asperity-stats --parameters height --json numbers.txt");
  CHECK(stats.exit == 0);
  CHECK_THAT(stats.out, ContainsSubstring("\"Sq\""));
  CHECK(shell("cat numbers.txt | asperity-stats --parameters height").exit == 0);
  CHECK(shell("asperity-stats --parameters height --memory 100B numbers.txt").exit == 0);
  CHECK(shell("asperity-acf numbers.txt --max-lag 2x2 -o acf.nc").exit == 0);
  const Outcome contact =
      shell("asperity-contact numbers.txt --radius 1mm --young 2GPa --poisson 0.3 --load 1N");
  CHECK(contact.exit == 4);
  CHECK_THAT(contact.error, ContainsSubstring("heights"));
}

TEST_CASE("a measured map goes through the chain: its correlation, a twin, its contact",
          "[convert][contract]") {
  const Outcome run =
      shell(surface +
            "asperity-convert surface.nc -o map.x3p && asperity-acf map.x3p --max-lag 8x8 | asperity-kernel "
            "--acf - "
            "--infeasible nearest | asperity-generate --kernel - --shape 32x16 | "
            "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 5N -o contact.nc");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const Grid grid = grid_of(read_dataset("contact.nc"));
  CHECK(relative_error(grid.dx, 3e-3 / 24) <= 1e-9);
  CHECK(relative_error(grid.dy, 1e-3 / 16) <= 1e-9);
}

TEST_CASE("a dataset with depths becomes an image for ParaView, one of uneven depths a rectilinear grid",
          "[convert][contract]") {
  const std::string stress = surface +
                             "asperity-contact surface.nc --radius 50mm --young 208GPa --poisson 0.3 --load "
                             "5N | asperity-stress -o s.nc --depths ";
  REQUIRE(shell(stress + "0:0.1mm:4 && asperity-convert s.nc -o s.vti").exit == 0);
  CHECK_THAT(shell("head -c 400 s.vti").out, ContainsSubstring("type=\"ImageData\""));
  const Outcome uneven =
      shell(stress + "0,0.1mm,0.3mm && asperity-convert s.nc -o s.vtr && asperity-convert s.nc -o no.vti");
  CHECK(uneven.exit == 4);
  CHECK_THAT(uneven.error, ContainsSubstring("asperity-convert: s.nc: z: depths are not evenly spaced"));
  CHECK_THAT(shell("head -c 400 s.vtr").out, ContainsSubstring("type=\"RectilinearGrid\""));
}

TEST_CASE("a dataset passes from NetCDF to NetCDF whole", "[convert][contract]") {
  const Outcome run =
      shell(surface + "asperity-convert surface.nc --no-history | asperity-convert --no-history -o whole.nc");
  REQUIRE(run.exit == 0);
  const Dataset before = read_dataset("surface.nc"), after = read_dataset("whole.nc");
  REQUIRE(after.variables.size() == before.variables.size());
  for (std::size_t v = 0; v < before.variables.size(); ++v)
    CHECK(after.variables[v].values == before.variables[v].values);
}

TEST_CASE("a dataset in the order of viewers comes back as it was, and gives the same statistics",
          "[convert][exact]") {
  const Outcome run = shell(
      surface +
      "asperity-contact surface.nc --radius 50mm --young 208GPa --poisson 0.3 --load 5N | asperity-stress "
      "--depths 0,0.1mm,0.3mm --no-history -o s.nc && asperity-convert s.nc --to-order yx --no-history -o "
      "v.nc "
      "&& asperity-convert v.nc --no-history -o back.nc && ncdump -h v.nc | grep von_mises\\(z,\\ y,\\ x\\)");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  Dataset before = read_dataset("s.nc"), after = read_dataset("back.nc");
  for (Dataset* data : {&before, &after}) data->attributes.erase("source");
  CHECK(encode_netcdf(after) == encode_netcdf(before));
  const Outcome swapped = shell("asperity-stats --parameters height v.nc");
  CHECK(swapped.exit == 0);
  CHECK(swapped.out == shell("asperity-stats --parameters height s.nc").out);
}

TEST_CASE("the surface of a dataset with depths is the dataset before there were any, in VTK's eyes too",
          "[convert][foreign][exact]") {
  const Outcome run =
      shell(surface +
            "asperity-contact surface.nc --radius 50mm --young 208GPa --poisson 0.3 --load 5N -o c.nc &&"
            "asperity-stress c.nc --depths 0,0.1mm,0.3mm -o s.nc && for e in vti vtr; do asperity-convert "
            "c.nc -o c.$e && "
            "asperity-convert s.nc --surface -o s.$e && cmp c.$e s.$e; done && asperity-convert s.nc "
            "--surface -o t.nc");
  INFO(run.error);
  CHECK(run.exit == 0);
  CHECK(!read_dataset("t.nc").has("z"));
  CHECK(read_dataset("t.nc").at("pressure").values == read_dataset("c.nc").at("pressure").values);
  const Outcome seen = shell(
      "/usr/bin/python3 -c 'from vtkmodules.vtkIOXML import vtkXMLImageDataReader as R; r = R();"
      "r.SetFileName(\"s.vti\"); r.Update(); o = r.GetOutput();"
      "print(o.GetDimensions(), o.GetBounds()[4:], o.GetPointData().HasArray(\"pressure\"))' || "
      "/usr/bin/python3 -c 'import vtkmodules' || echo SKIPPED: there is no python3-vtk9");
  if (skipped(seen)) return;
  CHECK(seen.out == "(24, 16, 1) (0.0, 0.0) 1\n");
  CHECK(shell("asperity-convert s.nc --surface -o s.gsf").exit == 2);
}

TEST_CASE("what cannot be converted is refused with a line that names it", "[convert][contract]") {
  write_numbers();
  write_text("matrix.txt", "1 2\n3 4\n");
  write_text("rubbish.gsf", std::string("\x01\x02\x00\x03", 4));
  const std::pair<const char*, std::pair<int, const char*>> cases[] = {
      {"matrix.txt", {4, "asperity-convert: matrix.txt: x: the file does not give the size of the map"}},
      {"rubbish.gsf", {4, "asperity-convert: rubbish.gsf: map: unknown format"}},
      {"numbers.txt --from gsf", {4, "asperity-convert: "}},
      {"numbers.txt --from word", {2, "asperity-convert: --from: "}},
      {"numbers.txt --to word", {2, "asperity-convert: --to: "}},
      {"numbers.txt --unit nm", {2, "asperity-convert: --unit: the file gives its own unit, um"}},
      {"matrix.txt --size 0mm", {2, "asperity-convert: --size 0mm: 0 is not a positive length"}},
  };
  for (const auto& [arguments, expected] : cases) {
    CAPTURE(arguments);
    const Outcome run = shell(std::string("asperity-convert ") + arguments +
                              " -o out.nc; code=$?; test ! -e out.nc; exit $code");
    CHECK(run.exit == expected.first);
    CHECK_THAT(run.error, Catch::Matchers::StartsWith(expected.second));
    CHECK(lines(run.error) == 1);
  }
}

TEST_CASE("a NetCDF-4 file at which the HDF5 library hangs ends a tool with status 4 and one line",
          "[convert][contract][slow]") {
  const Outcome run = shell("ulimit -t 5; asperity-stats " ASPERITY_TEST_DATA "/../corpus/netcdf4/hangs");
  CAPTURE(run.error);
  CHECK(run.exit == 4);
  CHECK_THAT(run.error, ContainsSubstring(": dataset: "));
  CHECK(lines(run.error) == 1);
}
