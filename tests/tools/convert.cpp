// asperity-convert, the formats that every tool reads, and what other programs write: units, signs, descending axes.
#include "formats/format.hpp"
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string draw_small =
    "asperity-generate --shape 32x24 --size 3.2mm,2.4mm --rq 0.4um --length 6px,3px --seed 7 ";
const std::string press_small = "asperity-contact --radius 50mm --young 208GPa --poisson 0.3 --load 500N ";

void write_pressed() {
  static const bool once = [] {
    const Outcome run = shell(draw_small + "-o drawn.nc && " + press_small + "drawn.nc -o pressed.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return true;
  }();
  REQUIRE(once);
}

std::vector<double>& doubles(Dataset& data, const char* name) {
  return std::get<std::vector<double>>(data.find(name)->values);
}

// The pressure as another program has it.
void write_pressure(const std::string& name, const char* unit, double factor) {
  Dataset data = read_dataset("pressed.nc");
  for (double& p : doubles(data, "pressure")) p *= factor;
  Attributes& attributes = data.find("pressure")->attributes;
  attributes.erase("units");
  if (unit) attributes.set("units", unit);
  write_dataset(data, name);
}

const std::string layers_below = "asperity-stress --depths 0:0.5mm:3 ";

// Every variable on x backwards, as xarray's isel leaves it.
Dataset backwards(Dataset data) {
  for (Variable& v : data.variables) {
    if (v.dimensions.empty() || v.dimensions.front() != "x") continue;
    std::visit(
        [&](auto& values) {
          const auto rows = data.length("x"), piece = static_cast<Index>(values.size()) / rows;
          for (Index i = 0; i < rows / 2; ++i)
            std::swap_ranges(values.begin() + i * piece, values.begin() + (i + 1) * piece,
                             values.begin() + (rows - 1 - i) * piece);
        },
        v.values);
  }
  return data;
}

// The line that a command ends with, which must have the status.
std::string told(const std::string& command, int status) {
  const Outcome run = shell(command);
  CAPTURE(command, run.error);
  CHECK(run.exit == status);
  CHECK(lines(run.error) == 1);
  return run.error;
}

const std::string small_surface =
    "asperity-generate --shape 24x16 --size 3mm,1mm --rq 0.4um --length 3px --seed 7 -o surface.nc && ";

}  // namespace

// gsf holds 24 bits: heights within half a unit of the 24th, 6e-8 of the largest. sur holds 2^31 steps of the
// range, which is at most twice the largest, and 24 bits of a spacing.
TEST_CASE("a surface comes back from every format the same, with its spacing", "[convert][exact]") {
  require(small_surface + "true");
  const Field heights = field_in("surface.nc");
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
    CHECK((field_in("back.nc") - heights).abs().maxCoeff() <= digits * heights.abs().maxCoeff());
    const Grid grid = grid_of(read_dataset("back.nc"));
    CHECK(relative_error(grid.dx, 3e-3 / 24) <= of_spacing);
    CHECK(relative_error(grid.dy, 1e-3 / 16) <= of_spacing);
  }
}

TEST_CASE("what gzip has packed is read as its content is, by every tool", "[convert][exact]") {
  REQUIRE(shell(draw_small +
                "-o plain.nc && asperity-convert plain.nc -o plain.txt && gzip -kf plain.nc plain.txt && "
                "asperity-psd plain.nc --result radial > plain.tsv && gzip -kf plain.tsv")
              .exit == 0);
  for (const std::string file : {"plain.nc", "plain.txt"})
    for (const std::string tool :
         {"asperity-stats ", "asperity-acf --result lengths ", "asperity-convert --to gsf "})
      CHECK(shell(tool + file + ".gz").out == shell(tool + file).out);
  CHECK(shell("asperity-stats < plain.nc.gz").out == shell("asperity-stats plain.nc").out);
  const std::string twin = "asperity-generate -q --shape 32x24 --size 3.2mm,2.4mm --seed 1 --psd ";
  CHECK(shell(twin + "plain.tsv.gz | asperity-stats").out == shell(twin + "plain.tsv | asperity-stats").out);
  CHECK_THAT(shell("head -c 99 plain.nc.gz | asperity-stats").error,
             ContainsSubstring("map: the file is cut short"));
}

TEST_CASE("a matrix in text has the order, the size and the unit that it is given", "[convert][exact]") {
  write_text("matrix.txt", "1,2,3\n4,5,6\n");
  REQUIRE(shell("asperity-convert matrix.txt --from-order yx --size 6mm,4mm --unit nm -o m.nc").exit == 0);
  const Field z = field_in("m.nc");
  REQUIRE(shape_of(z) == Shape{3, 2});
  CHECK(relative_error(z(2, 1), 6e-9) <= 2 * epsilon);
  CHECK(relative_error(grid_of(read_dataset("m.nc")).dy, 2e-3) <= 4 * epsilon);
  const Outcome back = shell("asperity-convert m.nc --to text --to-order yx");
  CHECK_THAT(back.out, ContainsSubstring("\n# order: yx\n1e-09\t"));
  CHECK(lines(back.out) == 5);
}

TEST_CASE("a text that can be read in two ways is read as an option tells", "[convert][exact]") {
  write_text("both.csv", "1,5\n3,5\n2,5\n");
  write_text("xyz.txt", "# units: nm\n0 0 1\n0 2 2\n1 0 3\n1 2 4\n2 0 5\n2 2 6\n");
  write_text("xz.txt", "0 1\n1 2\n2 4\n");
  write_text("spaced.csv", "1,5, 2,5, 3,5\n4,5, 5,5, 6,5\n");  // six numbers a line, or three
  auto converted = [](const std::string& arguments) {
    const Outcome run = shell("asperity-convert " + arguments + " -o told.nc");
    INFO(run.error);
    REQUIRE(run.exit == 0);
    return field_in("told.nc");
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

TEST_CASE("a measured map goes through the chain: its correlation, a twin, its contact",
          "[convert][contract]") {
  const Outcome run =
      shell(small_surface +
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

TEST_CASE("the field of --variable becomes the map in every format", "[convert][contract]") {
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

// ---- what other programs write ----

// In MPa, psi, m or without a unit it passed as Pa. Factors are known to ε, the stress is linear in them.
TEST_CASE("a pressure in MPa makes the stress of the same pressure in Pa", "[units][exact]") {
  write_pressed();
  REQUIRE(shell(layers_below + "pressed.nc -o pa.nc").exit == 0);
  const std::vector<double> pascals = numbers(read_dataset("pa.nc").at("von_mises").values);
  const double largest = *std::ranges::max_element(pascals);
  for (const auto& [unit, factor] : {std::pair{"MPa", 1e-6}, {"N/mm2", 1e-6}, {"kPa", 1e-3}}) {
    write_pressure("other.nc", unit, factor);
    const Outcome run = shell(layers_below + "other.nc -o other-stress.nc");
    CAPTURE(unit, run.error);
    REQUIRE(run.exit == 0);
    const std::vector<double> other = numbers(read_dataset("other-stress.nc").at("von_mises").values);
    for (std::size_t i = 0; i < other.size(); ++i)
      if (!(std::abs(other[i] - pascals[i]) <= 64 * epsilon * largest)) FAIL(i << " " << other[i]);
  }
}

// Lags in mm counted samples: a surface of another size, or a demand for one.
TEST_CASE("a kernel whose lags and heights are in mm and um draws the same surface", "[units][exact]") {
  REQUIRE(shell("asperity-kernel --length 6px,3px --spacing 0.1mm --rq 0.4um -o kernel.nc").exit == 0);
  Dataset data = read_dataset("kernel.nc");
  for (const auto& [name, unit, factor] : {std::tuple{"p", "mm", 1e3},
                                           {"q", "mm", 1e3},
                                           {"kernel", "um", 1e6},
                                           {"acf_target", "um2", 1e12},
                                           {"acf_achieved", "um2", 1e12}}) {
    for (double& v : doubles(data, name)) v *= factor;
    data.find(name)->attributes.set("units", unit);
  }
  write_dataset(data, "other.nc");
  const Outcome run = shell(
      "for k in kernel other; do asperity-generate --kernel $k.nc --shape 32x24 --seed 3 -o "
      "$k-drawn.nc || exit; done");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  const Dataset one = read_dataset("kernel-drawn.nc"), other = read_dataset("other-drawn.nc");
  CHECK(relative_error(grid_of(other).dx, grid_of(one).dx) <= 8 * epsilon);
  const Field a = field_of(one, "heights"), b = field_of(other, "heights");
  CHECK((a - b).abs().maxCoeff() <= 64 * epsilon * a.abs().maxCoeff());
  data.find("acf_target")->attributes.set("units", "Pa2");
  write_dataset(data, "other.nc");
  CHECK_THAT(shell("asperity-generate --kernel other.nc --shape 32x24 --seed 3 -o d.nc").error,
             ContainsSubstring("acf_target: 'Pa2' cannot be converted"));
}

// Parameters of the mirror image; the place of the largest stress had the wrong sign.
TEST_CASE("a surface whose x descends is turned around, which a note and the history say once",
          "[axes][contract]") {
  write_pressed();
  write_dataset(read_dataset("pressed.nc"), "up.nc");
  const Dataset up = read_dataset("up.nc");
  write_dataset(backwards(up), "down.nc");
  const std::string find = "asperity-stress --maximum --no-history ";
  const Outcome one = shell(find + "up.nc -o up-stress.nc"),
                other = shell(find + "down.nc -o down-stress.nc");
  INFO(other.error);
  REQUIRE((one.exit == 0 && other.exit == 0));
  const std::string line = "descending coordinate x reversed, with all values on it";
  const std::string said = "asperity-stress: down.nc: " + line + "\n";
  const std::size_t at = other.error.find(said);
  CHECK((at != other.error.npos && other.error.find(said, at + 1) == other.error.npos));
  CHECK(one.error.find(line) == one.error.npos);
  CHECK(shell(find + "--quiet down.nc -o down-stress.nc").error.find(line) == std::string::npos);
  const Dataset a = read_dataset("up-stress.nc"), b = read_dataset("down-stress.nc");
  CHECK(a.attributes.number("stress_max_x", 0) == b.attributes.number("stress_max_x", 1));
  CHECK(a.at("heights").values == b.at("heights").values);
  CHECK(b.attributes.text("history").starts_with(line + "\n"));
  CHECK(shell("asperity-stats down-stress.nc").error.empty());
}
