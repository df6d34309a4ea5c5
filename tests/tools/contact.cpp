// asperity-contact as it is typed: bodies, boundaries, unloading, sweeps.
#include <filesystem>

#include <fmt/format.h>

#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string press_sphere = "asperity-contact --radius 50mm" + steel;

double pressure_of(const std::string& name) { return attribute(name, "contact_max_pressure"); }

// Hertz's: 2 E* a with a³ = 3QR/(4E*).
double hertz_radius(double load) { return std::cbrt(0.75 * load * 25e-3 / (208e9 / (2 * 0.91))); }
double hertz_stiffness(double load) { return 208e9 / 0.91 * hertz_radius(load); }

}  // namespace

TEST_CASE("a barrel is pressed as Hertz's ellipse and carries his numbers", "[contact][exact]") {
  const Attributes a = attributes_of(
      "asperity-contact --smooth --shape 96x96 --size 1.8mm,0.6mm --load 1kN "
      "--radius-x 25mm,inf --radius-y 4.1666666666666667mm,inf" +
      steel);
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
  require(
      "asperity-contact --smooth --shape 64x64 --size 3mm --radius-x 50mm,inf --load 5000N -o cylinder.nc" +
      steel);
  for (const char* name : {"pressure", "radius", "radius_x", "radius_y", "approach"})
    CHECK(attributes_in("cylinder.nc").find(std::string("contact_hertz_") + name) == nullptr);
  const Field p = field_in("cylinder.nc", "pressure");
  // The edges of a punch, as far as cells show them.
  CHECK(p(32, 0) > 1.2 * p(32, 32));
  CHECK(relative_error(p(32, 28), p(32, 35)) <= solver_error);
}

TEST_CASE("an approach in place of the load ends in the load that has this approach", "[contact][law]") {
  const Attributes loaded = attributes_of(sphere + "--tolerance 1e-9 --load 5000N");
  const Attributes sunk = attributes_of(sphere + "--tolerance 1e-9 --approach " +
                                        fmt::format("{}m", loaded.number("contact_approach", 0)));
  CHECK(relative_error(sunk.number("contact_load", 0), 5000) <= 1e-7);
  CHECK(sunk.number("contact_hertz_approach", 0) ==
        Approx(loaded.number("contact_hertz_approach", 0)).epsilon(1e-7));
}

// Under an approach the contact on coarser cells has the approach, and another load.
TEST_CASE("a contact tells whether its load or its approach was prescribed", "[contact][contract]") {
  CHECK(attributes_of(sphere + "--load 5kN").text("contact_prescribed") == "load");
  CHECK(attributes_of(sphere + "--approach 30um").text("contact_prescribed") == "approach");
}

TEST_CASE("two rough bodies press as one whose heights are the sum of both at the same points",
          "[contact][law]") {
  require(rough + " --seed 1 -o one.nc; " + rough + " --seed 2 -o two.nc");
  const auto write = [](const Field& heights, const std::string& name) {
    Dataset data = read_dataset("one.nc");
    set_field(data, "heights", heights, {"m", "heights"});
    write_dataset(data, name);
  };
  const std::string tight = press_sphere + "--load 5000N --tolerance 1e-9 ";
  write(field_in("one.nc") + field_in("two.nc"), "sum.nc");
  require(tight + "--counter two.nc one.nc -o pair.nc; " + tight + "sum.nc -o single.nc");
  const Field p = field_in("pair.nc", "pressure"), q = field_in("single.nc", "pressure");
  CHECK(greatest_difference(p, q) <= 1e-7 * q.maxCoeff());
  CHECK(attributes_in("pair.nc").text("contact_counter") == "two.nc");
  // Both positive towards the other body: a peak facing its own image doubles, one facing its negative fits.
  require(tight + "--counter one.nc one.nc -o doubled.nc");
  CHECK(pressure_of("doubled.nc") > attribute("pair.nc", "contact_hertz_pressure"));
  write(-field_in("one.nc"), "fitting.nc");
  require(tight + "--counter fitting.nc one.nc -o fitted.nc; " + sphere +
          "--load 5000N --tolerance 1e-9 -o smooth.nc");
  CHECK(relative_error(pressure_of("fitted.nc"), pressure_of("smooth.nc")) <= 1e-7);
}

TEST_CASE("the boundary is that of the grid unless it is freed", "[contact][contract]") {
  const std::string flat = "asperity-contact periodic.nc --load 50N" + steel;
  require(rough + " --seed 1 --periodic -o periodic.nc; " + flat + "-o kept.nc; " + flat +
          "--boundary periodic -o asked.nc; " + flat + "--boundary free -o freed.nc; " + flat +
          "--boundary free --radius 50mm -o curved.nc");
  CHECK(grid_of(read_dataset("kept.nc")).periodic.both());
  CHECK(attributes_in("kept.nc").text("contact_boundary") == "periodic");
  CHECK(same_bits(field_in("asked.nc", "pressure"), field_in("kept.nc", "pressure")));
  CHECK_FALSE(grid_of(read_dataset("freed.nc")).periodic.both());
  // A wave's displacement has no mean; a half-space's has.
  const Field repeated = field_in("kept.nc", "displacement");
  CHECK(std::abs(repeated.mean()) <= 1e-12 * repeated.maxCoeff());
  CHECK(field_in("freed.nc", "displacement").minCoeff() > 0);
}

// 64 cells of slope 1e-3: 63 steps of one cell at the seam.
TEST_CASE("a surface that jumps where it is said to continue is warned of", "[contact][contract]") {
  require(rough + " --seed 1 --periodic -o level.nc");
  const auto warned = [](const std::string& files) {
    return shell("asperity-contact -q --load 50N" + steel + files).error;
  };
  CHECK_THAT(warned("level.nc -o out.nc"), !ContainsSubstring("seam"));
  Dataset tilted = read_dataset("level.nc");
  const Field plane =
      Field::NullaryExpr(64, 64, [](Index, Index j) { return 3e-6 / 64 * static_cast<double>(j); });
  set_field(tilted, "heights", plane, {"m", "heights"});
  write_dataset(tilted, "tilted.nc");
  CHECK_THAT(warned("tilted.nc -o out.nc"),
             ContainsSubstring("periodic along y but jumps at the seam") && ContainsSubstring("2.95e-06 m") &&
                 ContainsSubstring("63 times") && ContainsSubstring("--boundary periodic_x") &&
                 !ContainsSubstring("along x"));
  CHECK_THAT(warned("tilted.nc --boundary free -o out.nc"), !ContainsSubstring("seam"));
  CHECK_THAT(warned("tilted.nc level.nc"), ContainsSubstring("jumps at the seam"));
}

// The truncation of 54 cells across, tests/contact/line.cpp.
TEST_CASE("a cylinder that repeats along one axis is pressed as Hertz's line contact", "[contact][exact]") {
  require(
      "asperity-contact --smooth --shape 16x256 --size 0.2mm,1mm --radius-y 10mm,inf --load 20N "
      "--boundary periodic_x --tolerance 1e-9 -o line.nc" +
      steel);
  auto number = [&](const char* name) { return attribute("line.nc", std::string("contact_") + name); };
  CHECK(grid_of(read_dataset("line.nc")).periodic == Periodic{true, false});
  CHECK(attributes_in("line.nc").text("contact_boundary") == "periodic_x");
  const double modulus = number("composite_modulus"), q = 20 / 0.2e-3;
  CHECK(number("hertz_pressure") == Approx(std::sqrt(q * modulus / (M_PI * 10e-3))).epsilon(1e-12));
  CHECK(number("hertz_half_width") == Approx(std::sqrt(4 * q * 10e-3 / (M_PI * modulus))).epsilon(1e-12));
  CHECK(number("approach_datum") == Approx(0.5e-3).epsilon(1e-12));
  CHECK(number("max_pressure") == Approx(number("hertz_pressure")).epsilon(3e-4));
  CHECK(number("approach") == Approx(number("hertz_approach")).epsilon(1e-4));
  CHECK(std::isnan(number("hertz_radius")));
  // The rough line: a surface that repeats along both axes, pressed as a cylinder along x.
  const std::string line = " --radius-y 50mm --load 50N" + steel;
  require(rough + " --seed 1 --periodic -o periodic.nc; asperity-contact periodic.nc --boundary periodic_x" +
          line + "-o rough.nc; asperity-contact rough.nc" + line + "-o again.nc");
  CHECK(grid_of(read_dataset("rough.nc")).periodic == Periodic{true, false});
  CHECK(same_bits(field_in("again.nc", "pressure"), field_in("rough.nc", "pressure")));
}

// Proof in contact/energy.hpp: the former pressure and approach solve the elastic contact of what is left.
TEST_CASE("the unloaded surface carries the load again, elastically and under the same pressure",
          "[contact][exact]") {
  const std::string tight = press_sphere + "--load 5000N --tolerance 1e-9 ";
  require(rough + " --seed 1 | " + tight + "--yield 900MPa --add heights_residual -o first.nc; " + tight +
          "--variable heights_residual first.nc -o second.nc");
  const double limit = 2700e6;
  CHECK(attribute("first.nc", "contact_plastic_area") > 0);
  CHECK(pressure_of("second.nc") <= limit * (1 + 1e-7));
  CHECK(greatest_difference(field_in("first.nc", "pressure"), field_in("second.nc", "pressure")) <=
        1e-7 * limit);
  CHECK_FALSE(read_dataset("second.nc").has("displacement_plastic"));
  const Field heights = field_in("first.nc"), flattened = field_in("first.nc", "displacement_plastic"),
              gap = field_in("first.nc", "gap");
  CHECK(same_bits(field_in("second.nc"), heights));
  CHECK((flattened - (-gap).max(0.0) * (flattened > 0).cast<double>()).abs().maxCoeff() == 0);
  CHECK((heights - flattened - field_in("first.nc", "heights_residual")).abs().maxCoeff() == 0);
}

TEST_CASE("smooth bodies that yield leave a dent that is pressed again through the pipe",
          "[contact][exact]") {
  require(sphere +
          "--load 5000N --tolerance 1e-9 --limit-pressure 2GPa --add heights_residual | asperity-contact "
          "--variable heights_residual --tolerance 1e-9 --radius 50mm --load 5000N -o dent.nc" +
          steel);
  CHECK(pressure_of("dent.nc") <= 2e9 * (1 + 1e-7));
}

// One spike that the window in the middle does not see: 739 in place of 6988 MPa once, "round-off allows no smaller".
TEST_CASE("a tolerance below round-off is not converged and names the residual of the right answer",
          "[contact][contract]") {
  Field spike = Field::Zero(256, 256);
  spike(200, 128) = 13e-6;
  write_map(spike, {{256, 256}, 3e-3 / 256, 3e-3 / 256}, "flat.nc");
  const Outcome run =
      shell(press_sphere + "flat.nc --load 100N --tolerance 1e-16 --max-convolutions 1000000 -o spike.nc");
  CHECK(run.exit == 3);
  CHECK_THAT(run.error, ContainsSubstring("not converged: round-off allows no smaller residual than"));
  CHECK(relative_error(pressure_of("spike.nc"), 6987.8576e6) <= 1e-7);
  CHECK(attribute("spike.nc", "contact_residual") <= 1e-11);
}

// ---- sweeps ----

// The load is met to 1e-12 (docs/accuracy), on sides that differ.
TEST_CASE(
    "a mean pressure is the load over the whole surface, alone and in a sweep, of flats that repeat or end",
    "[contact][law]") {
  constexpr double area = 1.2e-3 * 1e-3, pressure = 50e6, round_off = 1e-11;
  require(
      "asperity-generate --periodic --shape 48x32 --size 1.2mm,1mm --rq 0.4um --model gaussian --length "
      "0.2mm "
      "--seed 5 -o flat.nc");
  for (const std::string boundary : {"periodic", "free"}) {
    const std::string flats = "asperity-contact flat.nc --boundary " + boundary + steel;
    const Attributes a = attributes_of(flats + "--mean-pressure 50MPa"),
                     loaded = attributes_of(flats + "--load 60N");
    CAPTURE(boundary);
    CHECK(a.text("contact_prescribed") == "mean_pressure");
    CHECK(relative_error(a.number("contact_mean_pressure", 0), pressure) <= round_off);
    CHECK(relative_error(a.number("contact_load", 0), pressure * area) <= round_off);
    CHECK(relative_error(a.number("contact_area", 0), loaded.number("contact_area", 0)) <= round_off);
    CHECK(loaded.find("contact_mean_pressure") == nullptr);
    const Printed sweep = printed(flats + "--sweep 25MPa:50MPa:2,20MPa");
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = std::array{25e6, 50e6, 20e6}[k];
      CHECK(relative_error(sweep["mean_pressure"].at(k), expected) <= round_off);
      CHECK(relative_error(sweep["load"].at(k), expected * area) <= round_off);
    }
  }
}

TEST_CASE("a sweep prints a row a load, each the contact of its load alone", "[contact][law]") {
  const Printed table = printed(sphere + "--sweep 500N:5kN:9");
  REQUIRE(table.rows.size() == 9);
  CHECK(table["load"].front() == Approx(500).epsilon(1e-12));
  CHECK(table["load"].back() == Approx(5000).epsilon(1e-12));
  const Attributes alone = attributes_of(sphere + "--load 5kN");
  for (const std::string name : {"approach", "max_pressure", "mean_gap"})
    CHECK(relative_error(table[name].back(), alone.number("contact_" + name, 0)) <= solver_error);
  CHECK(table["area"].back() == alone.number("contact_area", 0));
  for (std::size_t k = 0; k < 9; ++k) {
    CHECK(table["converged"][k] == 1);
    CHECK(table["residual"][k] <= 1e-6);
    CHECK(table["plastic_area"][k] == 0);
    // 1 % is the staircase of a contact of eight cells' radius.
    CHECK(relative_error(table["stiffness"][k], hertz_stiffness(table["load"][k])) <= 0.01);
  }
}

TEST_CASE("each load of a sweep leaves the dataset that it alone would leave", "[contact][law]") {
  const std::string yielding =
      rough + " --seed 1 | " + press_sphere + "--yield 700MPa --tolerance 1e-9 --add heights_residual ";
  require(yielding + "--sweep 500N,5kN --each press-%02d.nc -o table.tsv; " + yielding +
          "--load 5kN -o alone.nc");
  const Dataset each = read_dataset("press-02.nc"), alone = read_dataset("alone.nc");
  CHECK(std::filesystem::exists(scratch("press-01.nc")));
  REQUIRE(each.variables.size() == alone.variables.size());
  for (std::size_t v = 0; v < alone.variables.size(); ++v)
    CHECK(each.variables[v].name == alone.variables[v].name);
  for (const char* name : {"pressure", "displacement_plastic", "heights_residual"}) {
    const Field one = field_of(each, name), other = field_of(alone, name);
    CHECK(greatest_difference(one, other) <= 1e-7 * other.abs().maxCoeff());
  }
}

// Once (10 N, 100 N, 1 kN) had -1.75e7 N/m. The outline's cells leave 0.2 Δx/a, 4 % of the least contact.
TEST_CASE("the stiffness of a sweep's loads is that of each load alone, and Hertz's", "[contact][law]") {
  const std::string fine = "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm" + steel;
  const std::vector<double> stiffness = printed(fine + "--sweep 10N,100N,1kN --tolerance 1e-9")["stiffness"];
  REQUIRE(stiffness.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double load = std::pow(10, i + 1);
    CAPTURE(i, stiffness[i]);
    CHECK(relative_error(stiffness[i], hertz_stiffness(load)) <= 0.2 * (3e-3 / 128) / hertz_radius(load));
    const Attributes alone =
        attributes_of(fine + "--tolerance 1e-9 --add contact_stiffness --load " + std::to_string(load) + "N");
    CHECK(relative_error(alone.number("contact_stiffness", 0), stiffness[i]) <= 1e-8);
    CHECK(alone.number("contact_stiffness_residual", 1) <= 1e-6);
    CHECK(alone.number("contact_stiffness_converged", 0) == 1);
  }
  const Attributes sunk = attributes_of(fine + "--approach 12um --add contact_stiffness");
  CHECK(relative_error(sunk.number("contact_stiffness", 0), 208e9 / 0.91 * std::sqrt(12e-6 * 25e-3)) <= 0.01);
  require(fine + "--sweep 10N,100N --each stiff-%d.nc -o stiff.tsv");
  CHECK(attribute("stiff-2.nc", "contact_stiffness") > 0);
}

TEST_CASE("a sweep goes up and down, presses its turning point once and writes each contact",
          "[contact][law]") {
  const Printed table = printed(rough + " --seed 1 | " + press_sphere +
                                "--yield 700MPa --sweep 50N:5kN:5,5kN:50N:5 --each way-%d.nc "
                                "--add heights_residual --tolerance 1e-9");
  REQUIRE(table.rows.size() == 9);
  for (std::size_t up = 0, down = 8; up < 4; ++up, --down) {
    CHECK(relative_error(table["load"][up], table["load"][down]) <= 1e-12);
    CHECK(table["approach"][down] > table["approach"][up]);
    CHECK(table["max_pressure"][down] < table["max_pressure"][up] * (1 + 1e-9));
    CHECK(table["converged"][down] == 1);
  }
  CHECK(std::isnan(attribute("way-5.nc", "contact_flattening_load")));
  CHECK(relative_error(attribute("way-8.nc", "contact_flattening_load"), 5000) <= 1e-12);
  for (const char* name : {"displacement_plastic", "heights_residual"})
    CHECK(greatest_difference(field_in("way-5.nc", name), field_in("way-8.nc", name)) <= 1e-7 * 0.4e-6);
  // What the load left, pressed alone.
  require(press_sphere +
          "way-5.nc --variable heights_residual --load 158.11388300841898N --tolerance 1e-9 -o again.nc");
  const Field again = field_in("again.nc", "pressure");
  CHECK(greatest_difference(again, field_in("way-8.nc", "pressure")) <= 1e-7 * again.maxCoeff());
}

TEST_CASE("ranges of a sweep fall and join as they are typed", "[contact][contract]") {
  for (const auto& [sweep, loads] :
       {std::pair{"1kN:3kN:3:uniform,3kN:1kN:3:uniform", std::vector<double>{1000, 2000, 3000, 2000, 1000}},
        {"4kN:1kN:3", {4000, 2000, 1000}},
        {"1kN,2kN:4kN:2,500N", {1000, 2000, 4000, 500}}}) {
    CAPTURE(sweep);
    const std::vector<double> found = printed(sphere + "--sweep " + sweep)["load"];
    REQUIRE(found.size() == loads.size());
    for (std::size_t k = 0; k < found.size(); ++k) CHECK(relative_error(found[k], loads[k]) <= 1e-12);
  }
}
