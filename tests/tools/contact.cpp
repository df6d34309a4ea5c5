// asperity-contact as it is typed: bodies, boundaries, sweeps, unloading, refusals.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "support.hpp"
#include "tools/files.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string elastic = " --young 208GPa --poisson 0.3 ";
const std::string smooth = "asperity-contact --smooth --shape 64x64 --size 3mm" + elastic;
const std::string surface = "asperity-generate --shape 64x64 --size 3mm --rq 0.4um --length 8px";

Outcome require(const std::string& line) {
  Outcome run = shell(line);
  CAPTURE(line, run.error);
  REQUIRE(run.exit == 0);
  return run;
}

Attributes attributes(const std::string& line) {
  require(line + " -o attributes.nc");
  return read_dataset("attributes.nc").attributes;
}

struct Row {
  double load, approach, area, plastic_area, mean_gap, stiffness, max_pressure, residual, convolutions,
      converged;
};

std::vector<Row> rows(const std::string& tsv) {
  std::vector<Row> out;
  std::istringstream in(tsv);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream numbers(line);
    Row r{};
    for (double* value : {&r.load, &r.approach, &r.area, &r.plastic_area, &r.mean_gap, &r.stiffness,
                          &r.max_pressure, &r.residual, &r.convolutions, &r.converged}) {
      std::string text;
      numbers >> text;
      *value = std::stod(text);
    }
    out.push_back(r);
  }
  return out;
}

// ε leaves pressures and approaches some ten times itself (contact/problem.hpp), of the default 1e-6.
constexpr double tolerance = 1e-5;

}  // namespace

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
  // Both positive towards the other body: a peak facing its own image doubles, one facing its negative meets a fit.
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
  CHECK(grid_of(read_dataset("kept.nc")).periodic);
  CHECK(read_dataset("kept.nc").attributes.text("contact_boundary") == "periodic");
  require(press + "--boundary periodic -o asked.nc");
  CHECK((field_of(read_dataset("asked.nc"), "pressure") == field_of(read_dataset("kept.nc"), "pressure"))
            .all());
  require(press + "--boundary free -o freed.nc");
  CHECK_FALSE(grid_of(read_dataset("freed.nc")).periodic);
  require(press + "--boundary free --radius 50mm -o curved.nc");
  // A wave's displacement has no mean; a half-space's has.
  const Field repeated = field_of(read_dataset("kept.nc"), "displacement"),
              alone = field_of(read_dataset("freed.nc"), "displacement");
  CHECK(std::abs(repeated.mean()) <= 1e-12 * repeated.maxCoeff());
  CHECK(alone.minCoeff() > 0);
}

TEST_CASE("a sweep prints a row a load, each the contact of its load alone", "[contact][law]") {
  const std::vector<Row> table = rows(require(smooth + "--radius 50mm --loads 500N:5kN:9").out);
  REQUIRE(table.size() == 9);
  CHECK(table.front().load == Approx(500).epsilon(1e-12));
  CHECK(table.back().load == Approx(5000).epsilon(1e-12));
  const Attributes alone = attributes(smooth + "--radius 50mm --load 5kN");
  CHECK(relative_error(table.back().approach, alone.number("contact_approach", 0)) <= tolerance);
  CHECK(relative_error(table.back().max_pressure, alone.number("contact_max_pressure", 0)) <= tolerance);
  CHECK(relative_error(table.back().mean_gap, alone.number("contact_mean_gap", 0)) <= tolerance);
  CHECK(table.back().area == alone.number("contact_area", 0));
  for (const Row& r : table) {
    CHECK(r.converged == 1);
    CHECK(r.residual <= 1e-6);
    CHECK(r.plastic_area == 0);
    // 2 E* a with a³ = 3QR/(4E*): 1 % is the staircase of a contact of eight cells' radius.
    const double modulus = 208e9 / (2 * 0.91), a = std::cbrt(0.75 * r.load * 25e-3 / modulus);
    CHECK(relative_error(r.stiffness, 2 * modulus * a) <= 0.01);
  }
}

TEST_CASE("a sweep is JSON where asked, and takes a list as well", "[contact][contract]") {
  const auto json = nlohmann::json::parse(require(smooth + "--radius 50mm --loads 500N,1kN,5kN --json").out);
  CHECK(json["load"]["unit"] == "N");
  CHECK(json["stiffness"]["unit"] == "N/m");
  CHECK(json["load"]["values"].size() == 3);
  CHECK(json["load"]["values"][1].get<double>() == Approx(1000).epsilon(1e-12));
}

TEST_CASE("each load of a sweep leaves the dataset that it alone would leave", "[contact][law]") {
  require(surface +
          " --seed 1 | asperity-contact --radius 50mm --yield 700MPa --tolerance 1e-9 --unload"
          " --loads 500N,5kN --each press-%02d.nc -o table.tsv" +
          elastic);
  const Dataset each = read_dataset("press-02.nc");
  require(surface +
          " --seed 1 | asperity-contact --radius 50mm --yield 700MPa --tolerance 1e-9 --unload"
          " --load 5kN -o alone.nc" +
          elastic);
  const Dataset alone = read_dataset("alone.nc");
  CHECK(std::filesystem::exists(scratch("press-01.nc")));
  REQUIRE(each.variables.size() == alone.variables.size());
  for (std::size_t v = 0; v < alone.variables.size(); ++v)
    CHECK(each.variables[v].name == alone.variables[v].name);
  for (const char* name : {"pressure", "displacement_plastic", "heights_residual"}) {
    const Field one = field_of(each, name), other = field_of(alone, name);
    CHECK((one - other).abs().maxCoeff() <= 1e-7 * other.abs().maxCoeff());
  }
}

TEST_CASE("a sweep with a load that does not converge exits with 3 and prints every row",
          "[contact][contract]") {
  const Outcome run = shell(surface +
                            " --seed 1 | asperity-contact --radius 50mm --loads 500N:5kN:4 "
                            "--max-convolutions 3 --tolerance 1e-9" +
                            elastic);
  CHECK(run.exit == 3);
  CHECK(rows(run.out).size() == 4);
  CHECK(rows(run.out).back().converged == 0);
}

// Proof in contact/flattening.hpp: the former pressure and approach solve the elastic contact of what is left.
TEST_CASE("the unloaded surface carries the load again, elastically and under the same pressure",
          "[contact][exact]") {
  const std::string press = "asperity-contact --radius 50mm --load 5000N --tolerance 1e-9" + elastic;
  require(surface + " --seed 1 | " + press + "--yield 900MPa --unload -o first.nc");
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
  require(smooth + tight + "--limit-pressure 2GPa --unload | asperity-contact --variable heights_residual" +
          tight + elastic + "-o dent.nc");
  CHECK(read_dataset("dent.nc").attributes.number("contact_max_pressure", 0) <= 2e9 * (1 + 1e-7));
}

TEST_CASE("what asperity-contact cannot do is one line that names the option, the value and the bound",
          "[contact][contract]") {
  const std::string sphere = smooth + "--radius 50mm ";
  const std::pair<std::string, std::string> wrong[] = {
      {sphere, "--load: is needed"},
      {sphere + "--load 5um", "--load: '5um'"},
      {sphere + "--load 5", "--load: '5' has no unit"},
      {sphere + "--load 5N --approach 1um", "--load: only one"},
      {sphere + "--load 5N --loads 1N,2N", "--load: only one"},
      {sphere + "--approach 5N", "--approach: '5N'"},
      {sphere + "--approach=-5um", "--approach"},
      {sphere + "--load 1MN --limit-pressure 1GPa", "9000"},
      {sphere + "--loads 1N,1MN --limit-pressure 1GPa", "--loads"},
      {sphere + "--loads 1N:5N", "--loads: '1N:5N'"},
      {sphere + "--loads 1N:5N:1", "--loads: '1'"},
      {sphere + "--loads 5N:1N:3", "--loads: '5N:1N:3' does not increase"},
      {sphere + "--loads 0N,1N", "--loads: '0N' is not above 0"},
      {sphere + "--loads 1N,", "--loads"},
      {sphere + "--loads 1N,5N --each press.nc", "--each: 'press.nc'"},
      {sphere + "--loads 1N,5N --report r.json", "--report"},
      {sphere + "--loads 1N,5N --unload --yield 1GPa", "--unload"},
      {sphere + "--load 5N --each press-%d.nc", "--each"},
      {sphere + "--load 5N --unload", "--unload"},
      {sphere + "--load 5N --json", "--json"},
      {sphere + "--load 5N --boundary periodic", "--radius: a periodic surface"},
      {smooth + "--radius-y 5mm --load 5N --boundary periodic", "--radius-y: a periodic surface"},
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
      {"nan.nc", "heights: the value at point (1, 6) is not a number"},
      {"fill.nc", "heights: 1 of its points are missing (_FillValue)"},
      {"missing.nc", "heights: 1 of its points are missing (missing_value)"},
      {"mask.nc", "heights: 1 of its points are masked"},
      {"force.nc", "heights: 'N'"},
      {"none.nc", "heights"},
      {"--counter nan.nc good.nc", "heights: in nan.nc: "},
      {"--variable absent good.nc", "absent"},
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

// Once (10 N, 100 N, 1 kN) had -1.75e7 N/m. The outline's cells leave 0.2 Δx/a, 4 % of the least contact.
TEST_CASE("the stiffness of a sweep's loads is that of each load alone, and Hertz's", "[contact][law]") {
  const std::string sphere = "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm" + elastic;
  const std::vector<Row> table = rows(require(sphere + "--loads 10N,100N,1kN --tolerance 1e-9").out);
  REQUIRE(table.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double q = std::pow(10, i + 1), modulus = 208e9 / (2 * 0.91),
                 a = std::cbrt(0.75 * q * 25e-3 / modulus);
    CAPTURE(i, table[i].stiffness);
    CHECK(relative_error(table[i].stiffness, 2 * modulus * a) <= 0.2 * (3e-3 / 128) / a);
    const Attributes alone =
        attributes(sphere + "--tolerance 1e-9 --stiffness --load " + std::to_string(q) + "N");
    CHECK(relative_error(alone.number("contact_stiffness", 0), table[i].stiffness) <= 1e-8);
    CHECK(alone.number("contact_stiffness_residual", 1) <= 1e-6);
    CHECK(alone.number("contact_stiffness_converged", 0) == 1);
  }
  const Attributes sunk = attributes(sphere + "--approach 12um --stiffness");
  CHECK(relative_error(sunk.number("contact_stiffness", 0), 2 * 208e9 / 1.82 * std::sqrt(12e-6 * 25e-3)) <=
        0.01);
  require(sphere + "--loads 10N,100N --each stiff-%d.nc -o stiff.tsv");
  CHECK(read_dataset("stiff-2.nc").attributes.number("contact_stiffness", 0) > 0);
}

TEST_CASE("a stiffness is not kept from a former contact", "[contact][contract]") {
  const std::string press = "asperity-contact --radius 50mm" + elastic;
  require(surface + " --seed 1 | " + press + "--load 50N --stiffness -o stiff.nc");
  require(press + "--load 5N stiff.nc -o less.nc");
  for (const char* name :
       {"contact_stiffness", "contact_stiffness_residual", "contact_stiffness_converged"}) {
    CHECK(read_dataset("stiff.nc").attributes.find(name) != nullptr);
    CHECK(read_dataset("less.nc").attributes.find(name) == nullptr);
  }
}

TEST_CASE("a stiffness that does not converge is no number, one line and exit 3", "[contact][contract]") {
  const Outcome run = shell(surface + " --seed 1 | asperity-contact --radius 50mm --load 5kN --stiffness" +
                            " --tolerance 0.1 --max-convolutions 6 -o cut.nc" + elastic);
  CHECK(run.exit == 3);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring("the stiffness is not converged: residual"));
  const Attributes a = read_dataset("cut.nc").attributes;
  CHECK(a.number("contact_converged", 0) == 1);
  CHECK(a.number("contact_stiffness_converged", 1) == 0);
  CHECK(std::isnan(a.number("contact_stiffness", 0)));
}

// One spike that the window in the middle does not see: 739 in place of 6988 MPa once, "round-off allows no smaller".
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

TEST_CASE("what makes a contact doubtful is told even with --quiet, in a sweep by each load",
          "[contact][contract]") {
  const Outcome run = shell(smooth + "--radius 50mm --loads 5kN,50kN,500kN --quiet --json");
  CHECK(run.exit == 0);
  CHECK(lines(run.error) == 3);
  CHECK(nlohmann::json::parse(run.out)["load"]["values"].size() == 3);
  CHECK_THAT(run.error, ContainsSubstring("warning: 50kN: the contact touches the edge") &&
                            ContainsSubstring("make it 0.00605 x 0.00605 m") &&
                            ContainsSubstring("warning: 500kN: the greatest pressure, ") &&
                            ContainsSubstring("above the composite modulus, 1.14e+11 Pa"));
  // Each kind once, however many loads have it, and none hidden behind another: 31 lines on small contacts once.
  const Outcome many = shell(smooth + "--radius 50mm --loads 0.01N:50kN:30 -q");
  CHECK(lines(many.error) == 4);
  CHECK_THAT(many.error, ContainsSubstring("10mN: the contact has") &&
                             ContainsSubstring("the contact has few cells under ") &&
                             ContainsSubstring("kN: the contact touches the edge") &&
                             ContainsSubstring("to 50kN"));
  CHECK_THAT(shell(smooth + "--load 5N -q -o flat.nc").error,
             ContainsSubstring("periodic, or give a radius"));
  const Outcome ball = shell(smooth + "--radius 1mm --loads 5kN,6kN -q");
  CHECK_THAT(ball.error, ContainsSubstring(
                             "warning: the domain ends at x = 0.0015 m, beyond a body's radius of 0.001 m"));
  CHECK(lines(ball.error) == 1);
}
