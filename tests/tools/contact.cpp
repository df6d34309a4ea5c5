// asperity-contact as it is typed: bodies, boundaries, unloading, refusals.
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tools/contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("a barrel is pressed as Hertz's ellipse and carries his numbers", "[contact][exact]") {
  const Attributes a = attributes(
      "asperity-contact --smooth --shape 96x96 --size 1.8mm,0.6mm --load 1kN "
      "--radius-x 25mm,inf --radius-y 4.1666666666666667mm,inf" +
      elastic);
  CHECK(a.number("contact_hertz_pressure", 0) == Approx(3143.319e6).epsilon(2e-7));
  CHECK(a.number("contact_hertz_radius_x", 0) == Approx(0.7026656e-3).epsilon(1e-7));
  CHECK(a.number("contact_hertz_radius_y", 0) == Approx(0.2161744e-3).epsilon(3e-7));
  CHECK(a.number("contact_hertz_approach", 0) == Approx(15.48254e-6).epsilon(4e-7));
  // The truncation of 37 and 35 cells across the axes, tests/contact/hertz.cpp.
  const double s = 2 * std::pow(2.0 / 34, 2);
  CHECK(relative_error(a.number("contact_max_pressure", 0), 3143.319e6) <= s / 8);
  CHECK(relative_error(a.number("contact_approach", 0), 15.48254e-6) <= 0.03 * s);
}

TEST_CASE("a cylinder has no point contact to compare with, and presses hardest at its ends",
          "[contact][contract]") {
  require(smooth + "--radius-x 50mm,inf --load 5000N -o cylinder.nc");
  const Dataset data = read_dataset("cylinder.nc");
  for (const char* name : {"pressure", "radius", "radius_x", "radius_y", "approach"})
    CHECK(data.attributes.find(std::string("contact_hertz_") + name) == nullptr);
  const Field p = field_of(data, "pressure");
  // The edges of a punch, as far as cells show them.
  CHECK(p(32, 0) > 1.2 * p(32, 32));
  CHECK(relative_error(p(32, 28), p(32, 35)) <= tolerance);
}

TEST_CASE("an approach in place of the load ends in the load that has this approach", "[contact][law]") {
  const Attributes loaded = attributes(smooth + "--radius 50mm --tolerance 1e-9 --load 5000N");
  const std::string approach = nlohmann::json(loaded.number("contact_approach", 0)).dump() + "m";
  const Attributes sunk = attributes(smooth + "--radius 50mm --tolerance 1e-9 --approach " + approach);
  CHECK(relative_error(sunk.number("contact_load", 0), 5000) <= 1e-7);
  CHECK(sunk.number("contact_hertz_approach", 0) ==
        Approx(loaded.number("contact_hertz_approach", 0)).epsilon(1e-7));
}

TEST_CASE("two rough bodies press as one whose heights are the sum of both at the same points",
          "[contact][law]") {
  require(surface + " --seed 1 -o one.nc");
  require(surface + " --seed 2 -o two.nc");
  Dataset sum = read_dataset("one.nc");
  const Field both = field_of(sum, "heights") + field_of(read_dataset("two.nc"), "heights");
  set_field(sum, "heights", both, {"m", "heights"});
  write_dataset(sum, "sum.nc");
  const std::string press = "asperity-contact --radius 50mm --load 5000N --tolerance 1e-9" + elastic;
  require(press + "--counter two.nc one.nc -o pair.nc");
  require(press + "sum.nc -o single.nc");
  const Dataset pair = read_dataset("pair.nc");
  const Field p = field_of(pair, "pressure"), q = field_of(read_dataset("single.nc"), "pressure");
  CHECK((p - q).abs().maxCoeff() <= 1e-7 * q.maxCoeff());
  CHECK(pair.attributes.text("contact_counter") == "two.nc");
  // Both positive towards the other body: a peak facing its own image doubles, one facing its negative meets
  // a fit.
  require(press + "--counter one.nc one.nc -o doubled.nc");
  CHECK(read_dataset("doubled.nc").attributes.number("contact_max_pressure", 0) >
        read_dataset("pair.nc").attributes.number("contact_hertz_pressure", 0));
  Dataset fitting = read_dataset("one.nc");
  set_field(fitting, "heights", -field_of(fitting, "heights"), {"m", "heights"});
  write_dataset(fitting, "fitting.nc");
  require(press + "--counter fitting.nc one.nc -o fitted.nc");
  const Attributes smooth_again = attributes(smooth + "--radius 50mm --load 5000N --tolerance 1e-9");
  CHECK(relative_error(read_dataset("fitted.nc").attributes.number("contact_max_pressure", 0),
                       smooth_again.number("contact_max_pressure", 0)) <= 1e-7);
}

TEST_CASE("a counter body on another grid is refused, and both grids are named", "[contact][contract]") {
  require(surface + " --seed 1 -o one.nc");
  for (const std::string& other :
       {surface + " --periodic", std::string("asperity-generate --shape 32x64 --size 3mm "
                                             "--rq 0.4um --length 8px")}) {
    require(other + " --seed 2 -o other.nc");
    const Outcome run = shell("asperity-contact --radius 50mm --load 5N --counter other.nc one.nc" + elastic);
    CAPTURE(run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("other.nc") && ContainsSubstring("64x64 cells on 3mm x 3mm"));
  }
  CHECK_THAT(shell("asperity-contact --load 5N --counter absent.nc one.nc" + elastic).error,
             ContainsSubstring("absent.nc"));
}

TEST_CASE("the boundary is that of the grid unless it is freed", "[contact][contract]") {
  require(surface + " --seed 1 --periodic -o periodic.nc");
  const std::string press = "asperity-contact periodic.nc --load 50N" + elastic;
  require(press + "-o kept.nc");
  CHECK(grid_of(read_dataset("kept.nc")).periodic.both());
  CHECK(read_dataset("kept.nc").attributes.text("contact_boundary") == "periodic");
  require(press + "--boundary periodic -o asked.nc");
  CHECK((field_of(read_dataset("asked.nc"), "pressure") == field_of(read_dataset("kept.nc"), "pressure"))
            .all());
  require(press + "--boundary free -o freed.nc");
  CHECK_FALSE(grid_of(read_dataset("freed.nc")).periodic.both());
  require(press + "--boundary free --radius 50mm -o curved.nc");
  // A wave's displacement has no mean; a half-space's has.
  const Field repeated = field_of(read_dataset("kept.nc"), "displacement"),
              alone = field_of(read_dataset("freed.nc"), "displacement");
  CHECK(std::abs(repeated.mean()) <= 1e-12 * repeated.maxCoeff());
  CHECK(alone.minCoeff() > 0);
}

// 64 cells of slope 1e-3: 63 steps of one cell at the seam.
TEST_CASE("a surface that jumps where it is said to continue is warned of", "[contact][contract]") {
  require(surface + " --seed 1 --periodic -o level.nc");
  const std::string press = "asperity-contact -q --load 50N" + elastic;
  CHECK_THAT(shell(press + "level.nc -o out.nc").error, !ContainsSubstring("seam"));
  Dataset tilted = read_dataset("level.nc");
  const Field plane =
      Field::NullaryExpr(64, 64, [](Index, Index j) { return 3e-6 / 64 * static_cast<double>(j); });
  set_field(tilted, "heights", plane, {"m", "heights"});
  write_dataset(tilted, "tilted.nc");
  CHECK_THAT(shell(press + "tilted.nc -o out.nc").error,
             ContainsSubstring("periodic along y but jumps at the seam") && ContainsSubstring("2.95e-06 m") &&
                 ContainsSubstring("63 times") && ContainsSubstring("--boundary periodic_x") &&
                 !ContainsSubstring("along x"));
  CHECK_THAT(shell(press + "tilted.nc --boundary free -o out.nc").error, !ContainsSubstring("seam"));
  CHECK_THAT(shell(press + "tilted.nc level.nc").error, ContainsSubstring("jumps at the seam"));
}

// The truncation of 54 cells across, tests/contact/line.cpp.
TEST_CASE("a cylinder that repeats along one axis is pressed as Hertz's line contact", "[contact][exact]") {
  const std::string press =
      "asperity-contact --smooth --shape 16x256 --size 0.2mm,1mm --radius-y 10mm,inf "
      "--load 20N --boundary periodic_x --tolerance 1e-9" +
      elastic;
  require(press + "-o line.nc");
  const Dataset data = read_dataset("line.nc");
  const Attributes& a = data.attributes;
  auto number = [&](const char* name) { return a.number(std::string("contact_") + name, 0); };
  CHECK(grid_of(data).periodic == Periodic{true, false});
  CHECK(a.text("contact_boundary") == "periodic_x");
  const double modulus = number("composite_modulus"), q = 20 / 0.2e-3;
  CHECK(number("hertz_pressure") == Approx(std::sqrt(q * modulus / (M_PI * 10e-3))).epsilon(1e-12));
  CHECK(number("hertz_half_width") == Approx(std::sqrt(4 * q * 10e-3 / (M_PI * modulus))).epsilon(1e-12));
  CHECK(number("approach_datum") == Approx(0.5e-3).epsilon(1e-12));
  CHECK(number("max_pressure") == Approx(number("hertz_pressure")).epsilon(3e-4));
  CHECK(number("approach") == Approx(number("hertz_approach")).epsilon(1e-4));
  CHECK(a.find("contact_hertz_radius") == nullptr);
  // The rough line: a surface that repeats along both axes, pressed as a cylinder along x.
  require(surface + " --seed 1 --periodic -o periodic.nc");
  require("asperity-contact periodic.nc --boundary periodic_x --radius-y 50mm --load 50N" + elastic +
          "-o rough.nc");
  CHECK(grid_of(read_dataset("rough.nc")).periodic == Periodic{true, false});
  require("asperity-contact rough.nc --radius-y 50mm --load 50N" + elastic + "-o again.nc");
  CHECK((field_of(read_dataset("again.nc"), "pressure") == field_of(read_dataset("rough.nc"), "pressure"))
            .all());
}

// Proof in contact/energy.hpp: the former pressure and approach solve the elastic contact of what is
// left.
TEST_CASE("the unloaded surface carries the load again, elastically and under the same pressure",
          "[contact][exact]") {
  const std::string press = "asperity-contact --radius 50mm --load 5000N --tolerance 1e-9" + elastic;
  require(surface + " --seed 1 | " + press + "--yield 900MPa --add heights_residual -o first.nc");
  require(press + "--variable heights_residual first.nc -o second.nc");
  const Dataset first = read_dataset("first.nc"), second = read_dataset("second.nc");
  const double limit = 2700e6, reached = second.attributes.number("contact_max_pressure", 0);
  CHECK(first.attributes.number("contact_plastic_area", 0) > 0);
  CHECK(reached <= limit * (1 + 1e-7));
  CHECK((field_of(first, "pressure") - field_of(second, "pressure")).abs().maxCoeff() <= 1e-7 * limit);
  CHECK_FALSE(second.has("displacement_plastic"));
  CHECK((field_of(second, "heights") == field_of(first, "heights")).all());
  const Field flattened = field_of(first, "displacement_plastic"), gap = field_of(first, "gap");
  CHECK((flattened - (-gap).max(0.0) * (flattened > 0).cast<double>()).abs().maxCoeff() == 0);
  CHECK((field_of(first, "heights") - flattened - field_of(first, "heights_residual")).abs().maxCoeff() == 0);
}

TEST_CASE("smooth bodies that yield leave a dent that is pressed again through the pipe",
          "[contact][exact]") {
  const std::string tight = " --tolerance 1e-9 --radius 50mm --load 5000N ";
  require(smooth + tight +
          "--limit-pressure 2GPa --add heights_residual | asperity-contact --variable heights_residual" +
          tight + elastic + "-o dent.nc");
  CHECK(read_dataset("dent.nc").attributes.number("contact_max_pressure", 0) <= 2e9 * (1 + 1e-7));
}

TEST_CASE("what asperity-contact cannot do is one line that names the option, the value and the bound",
          "[contact][contract][slow]") {
  const std::string sphere = smooth + "--radius 50mm ";
  const std::pair<std::string, std::string> wrong[] = {
      {sphere, "--load is required"},
      {sphere + "--load 5um", "--load: '5um'"},
      {sphere + "--load 5", "--load: '5' has no unit"},
      {sphere + "--load 5N --approach 1um", "--load: only one"},
      {sphere + "--load 5N --sweep 1N,2N", "--load: only one"},
      {sphere + "--approach 5N", "--approach: '5N'"},
      {sphere + "--approach=-5um", "--approach -5um: -5e-06 m is not above "},
      {sphere + "--load=-2mN", "--load -2mN: -0.002 N is not above 0"},
      {sphere + "--load 1MN --limit-pressure 1GPa", "9000"},
      {sphere + "--sweep 1N,1MN --limit-pressure 1GPa", "--sweep"},
      {sphere + "--sweep 1N:5N", "--sweep: '1N:5N'"},
      {sphere + "--sweep 1N:5N:1", "--sweep: '1'"},
      {sphere + "--sweep 5N:5N:3", "--sweep: '5N:5N:3' does not increase"},
      {sphere + "--sweep 0N,1N", "--sweep: '0N' is not above 0"},
      {sphere + "--sweep 1N,", "--sweep"},
      {sphere + "--sweep 1N,5N --each press.nc", "--each: 'press.nc'"},
      {sphere + "--sweep 1N,5N --report r.json", "--report"},
      {sphere + "--sweep 1N,5N --add heights_residual --yield 1GPa", "--add: heights_residual needs --each"},
      {sphere + "--load 5N --each press-%d.nc", "--each"},
      {sphere + "--load 5N --add heights_residual", "--add: heights_residual needs --yield"},
      {sphere + "--load 5N --json", "--json"},
      {sphere + "--load 5N --boundary periodic", "--radius: a periodic surface"},
      {smooth + "--radius-y 5mm --load 5N --boundary periodic", "--radius-y: a periodic surface"},
      {sphere + "--load 5N --boundary periodic_x",
       "--radius: a surface periodic along x has no radius along x"},
      {smooth + "--radius-x 5mm --radius-y 5mm --load 5N --boundary periodic_y",
       "--radius-y: a surface periodic along y"},
      {surface + " | asperity-contact --load 5N --boundary periodic_y" + elastic, "--boundary: periodic_y"},
      {sphere + "--radius-x 5mm --load 5N", "--radius"},
      {smooth + "--radius-y=0mm --load 5N", "--radius-y"},
      {smooth + "--radius 5mm,-4mm --load 5N", "narrower"},
      {surface + " | asperity-contact --load 5N --boundary periodic" + elastic, "--boundary: periodic"},
      {surface + " | asperity-contact --load 5N --counter -" + elastic, "--counter: standard input"},
  };
  for (const auto& [line, words] : wrong) {
    const Outcome run = shell(line + " -o absent");
    CAPTURE(line, run.error);
    CHECK(run.exit == 2);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("asperity-contact: ") && ContainsSubstring(words));
  }
  CHECK_FALSE(std::filesystem::exists(scratch("absent")));
}

TEST_CASE("heights that are missing, masked, no length or no numbers are exit 4 and one line",
          "[contact][contract]") {
  require(surface + " --seed 1 -o good.nc");
  const Dataset good = read_dataset("good.nc");
  auto with = [&](const std::string& name, auto change) {
    Dataset data = good;
    change(data, *data.find("heights"));
    write_dataset(data, name);
  };
  auto height = [](Variable& v) -> double& { return std::get<std::vector<double>>(v.values)[70]; };
  with("nan.nc", [&](Dataset&, Variable& v) { height(v) = NAN; });
  with("fill.nc", [&](Dataset&, Variable& v) { v.attributes.set("_FillValue", height(v) = -9999); });
  with("missing.nc", [&](Dataset&, Variable& v) { v.attributes.set("missing_value", height(v) = 1e20); });
  with("mask.nc", [&](Dataset& d, Variable&) {
    std::vector<std::int8_t> mask(64 * 64, 0);
    mask[70] = 1;
    set_flags(d, "mask", mask, "missing", "no yes");
  });
  with("force.nc", [&](Dataset&, Variable& v) { v.attributes.set("units", "N"); });
  with("none.nc", [&](Dataset& d, Variable&) { d.erase("heights"); });
  const std::pair<std::string, std::string> bad[] = {
      {"nan.nc", "nan.nc: heights: the value at point (1, 6) is not a number"},
      {"fill.nc", "fill.nc: heights: 1 point missing (_FillValue)"},
      {"missing.nc", "missing.nc: heights: 1 point missing (missing_value)"},
      {"mask.nc", "mask.nc: heights: 1 point masked as missing"},
      {"force.nc", "force.nc: heights: 'N'"},
      {"none.nc", "none.nc: heights is missing"},
      {"--counter nan.nc good.nc", "nan.nc: heights: "},
      {"--variable absent good.nc", "good.nc: absent is missing"},
      {"- < /dev/null", "standard input: it is empty"},
  };
  for (const auto& [input, words] : bad) {
    const Outcome run = shell("asperity-contact --radius 50mm --load 5N -o absent.nc" + elastic + input);
    CAPTURE(input, run.error);
    CHECK(run.exit == 4);
    CHECK(lines(run.error) == 1);
    CHECK_THAT(run.error, ContainsSubstring("asperity-contact: " + words));
  }
  CHECK_FALSE(std::filesystem::exists(scratch("absent.nc")));
}

// One spike that the window in the middle does not see: 739 in place of 6988 MPa once, "round-off allows no
// smaller".
TEST_CASE("a tolerance below round-off is not converged and names the residual of the right answer",
          "[contact][contract]") {
  std::ofstream text(scratch("spike.txt"));
  text << "# Channel: spike\n# Width: 3 mm\n# Height: 3 mm\n# Value units: m\n";
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) text << (i == 128 && j == 200 ? "13e-6" : "0") << (j < 255 ? '\t' : '\n');
  text.close();
  const Outcome run = shell(
      "asperity-contact spike.txt --radius 50mm,50mm --load 100N --tolerance 1e-16 -o spike.nc"
      " --max-convolutions 1000000" +
      elastic);
  CHECK(run.exit == 3);
  CHECK_THAT(run.error, ContainsSubstring("not converged: round-off allows no smaller residual than"));
  const Attributes a = read_dataset("spike.nc").attributes;
  CHECK(relative_error(a.number("contact_max_pressure", 0), 6987.8576e6) <= 1e-7);
  CHECK(a.number("contact_residual", 1) <= 1e-11);
}
