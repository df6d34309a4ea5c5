// Sweeps of loads, and the stiffness, as they are typed.
#include <filesystem>

#include <nlohmann/json.hpp>

#include "tools/contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;

TEST_CASE("a sweep prints a row a load, each the contact of its load alone", "[contact][law]") {
  const std::vector<Row> table = rows(require(smooth + "--radius 50mm --sweep 500N:5kN:9").out);
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
  const auto json = nlohmann::json::parse(require(smooth + "--radius 50mm --sweep 500N,1kN,5kN --json").out);
  CHECK(json["load"]["unit"] == "N");
  CHECK(json["stiffness"]["unit"] == "N/m");
  CHECK(json["load"]["values"].size() == 3);
  CHECK(json["load"]["values"][1].get<double>() == Approx(1000).epsilon(1e-12));
}

TEST_CASE("each load of a sweep leaves the dataset that it alone would leave", "[contact][law]") {
  require(surface +
          " --seed 1 | asperity-contact --radius 50mm --yield 700MPa --tolerance 1e-9 --add heights_residual"
          " --sweep 500N,5kN --each press-%02d.nc -o table.tsv" +
          elastic);
  const Dataset each = read_dataset("press-02.nc");
  require(surface +
          " --seed 1 | asperity-contact --radius 50mm --yield 700MPa --tolerance 1e-9 --add heights_residual"
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
                            " --seed 1 | asperity-contact --radius 50mm --sweep 500N:5kN:4 "
                            "--max-convolutions 3 --tolerance 1e-9" +
                            elastic);
  CHECK(run.exit == 3);
  CHECK(rows(run.out).size() == 4);
  CHECK(rows(run.out).back().converged == 0);
}

// Once (10 N, 100 N, 1 kN) had -1.75e7 N/m. The outline's cells leave 0.2 Δx/a, 4 % of the least contact.
TEST_CASE("the stiffness of a sweep's loads is that of each load alone, and Hertz's", "[contact][law]") {
  const std::string sphere = "asperity-contact --smooth --shape 128x128 --size 3mm --radius 50mm" + elastic;
  const std::vector<Row> table = rows(require(sphere + "--sweep 10N,100N,1kN --tolerance 1e-9").out);
  REQUIRE(table.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double q = std::pow(10, i + 1), modulus = 208e9 / (2 * 0.91),
                 a = std::cbrt(0.75 * q * 25e-3 / modulus);
    CAPTURE(i, table[i].stiffness);
    CHECK(relative_error(table[i].stiffness, 2 * modulus * a) <= 0.2 * (3e-3 / 128) / a);
    const Attributes alone =
        attributes(sphere + "--tolerance 1e-9 --add contact_stiffness --load " + std::to_string(q) + "N");
    CHECK(relative_error(alone.number("contact_stiffness", 0), table[i].stiffness) <= 1e-8);
    CHECK(alone.number("contact_stiffness_residual", 1) <= 1e-6);
    CHECK(alone.number("contact_stiffness_converged", 0) == 1);
  }
  const Attributes sunk = attributes(sphere + "--approach 12um --add contact_stiffness");
  CHECK(relative_error(sunk.number("contact_stiffness", 0), 2 * 208e9 / 1.82 * std::sqrt(12e-6 * 25e-3)) <=
        0.01);
  require(sphere + "--sweep 10N,100N --each stiff-%d.nc -o stiff.tsv");
  CHECK(read_dataset("stiff-2.nc").attributes.number("contact_stiffness", 0) > 0);
}

TEST_CASE("a stiffness is not kept from a former contact", "[contact][contract]") {
  const std::string press = "asperity-contact --radius 50mm" + elastic;
  require(surface + " --seed 1 | " + press + "--load 50N --add contact_stiffness -o stiff.nc");
  require(press + "--load 5N stiff.nc -o less.nc");
  for (const char* name :
       {"contact_stiffness", "contact_stiffness_residual", "contact_stiffness_converged"}) {
    CHECK(read_dataset("stiff.nc").attributes.find(name) != nullptr);
    CHECK(read_dataset("less.nc").attributes.find(name) == nullptr);
  }
}

TEST_CASE("a stiffness that does not converge is no number, one line and exit 3", "[contact][contract]") {
  const Outcome run =
      shell(surface +
            " --model gaussian --seed 1 | asperity-contact --radius 50mm --load 5kN --add contact_stiffness" +
            " --tolerance 0.1 --max-convolutions 6 -o cut.nc" + elastic);
  CHECK(run.exit == 3);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring("the stiffness is not converged: residual"));
  const Attributes a = read_dataset("cut.nc").attributes;
  CHECK(a.number("contact_converged", 0) == 1);
  CHECK(a.number("contact_stiffness_converged", 1) == 0);
  CHECK(std::isnan(a.number("contact_stiffness", 0)));
}

TEST_CASE("what makes a contact doubtful is told even with --quiet, in a sweep by each load",
          "[contact][contract]") {
  const Outcome run = shell(smooth + "--radius 50mm --sweep 5kN,50kN,500kN --quiet --json");
  CHECK(run.exit == 0);
  CHECK(lines(run.error) == 3);
  CHECK(nlohmann::json::parse(run.out)["load"]["values"].size() == 3);
  CHECK_THAT(run.error, ContainsSubstring("warning: 50kN: the contact touches the edge") &&
                            ContainsSubstring("make it 0.00605 x 0.00605 m") &&
                            ContainsSubstring("warning: 500kN: the maximum pressure, ") &&
                            ContainsSubstring("above the composite modulus, 1.14e+11 Pa"));
  // Each kind once, however many loads have it, and none hidden behind another: 31 lines on small contacts
  // once.
  const Outcome many = shell(smooth + "--radius 50mm --sweep 0.01N:50kN:30 -q");
  CHECK(lines(many.error) == 4);
  CHECK_THAT(many.error, ContainsSubstring("10mN: the contact has") &&
                             ContainsSubstring("the contact has few cells under ") &&
                             ContainsSubstring("kN: the contact touches the edge") &&
                             ContainsSubstring("to 50kN"));
  CHECK_THAT(shell(smooth + "--load 5N -q -o flat.nc").error,
             ContainsSubstring("periodic, or give a radius"));
  const Outcome ball = shell(smooth + "--radius 1mm --sweep 5kN,6kN -q");
  CHECK_THAT(ball.error, ContainsSubstring(
                             "warning: the domain ends at x = 0.0015 m, beyond a body's radius of 0.001 m"));
  CHECK(lines(ball.error) == 1);
}

TEST_CASE("a sweep goes up and down, presses its turning point once and writes each contact",
          "[contact][law]") {
  const std::string rough = surface + " --seed 1 | asperity-contact --radius 50mm --yield 700MPa" + elastic;
  const std::vector<Row> table =
      rows(require(rough + "--sweep 50N:5kN:5,5kN:50N:5 --each way-%d.nc --add heights_residual "
                           "--tolerance 1e-9")
               .out);
  REQUIRE(table.size() == 9);
  for (std::size_t k = 0; k < 4; ++k) {
    const Row &up = table[k], &down = table[8 - k];
    CHECK(relative_error(up.load, down.load) <= 1e-12);
    CHECK(down.approach > up.approach);
    CHECK(down.max_pressure < up.max_pressure * (1 + 1e-9));
    CHECK(down.converged == 1);
  }
  const Dataset turn = read_dataset("way-5.nc"), back = read_dataset("way-8.nc");
  CHECK(turn.attributes.find("contact_flattening_load") == nullptr);
  CHECK(relative_error(back.attributes.number("contact_flattening_load", 0), 5000) <= 1e-12);
  for (const char* name : {"displacement_plastic", "heights_residual"})
    CHECK((field_of(turn, name) - field_of(back, name)).abs().maxCoeff() <= 1e-7 * 0.4e-6);
  // What the load left, pressed alone.
  require(
      "asperity-contact way-5.nc --variable heights_residual --radius 50mm --load 158.11388300841898N "
      "--tolerance 1e-9 -o again.nc" +
      elastic);
  const Field again = field_of(read_dataset("again.nc"), "pressure");
  CHECK((again - field_of(back, "pressure")).abs().maxCoeff() <= 1e-7 * again.maxCoeff());
}

TEST_CASE("ranges of a sweep fall and join as they are typed", "[contact][contract]") {
  auto loads = [](const std::string& sweep) {
    std::vector<double> out;
    for (const Row& r : rows(require(smooth + "--radius 50mm --sweep " + sweep).out)) out.push_back(r.load);
    return out;
  };
  auto are = [](const std::vector<double>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) CHECK(relative_error(found[k], expected[k]) <= 1e-12);
  };
  are(loads("1kN:3kN:3:uniform,3kN:1kN:3:uniform"), {1000, 2000, 3000, 2000, 1000});
  are(loads("4kN:1kN:3"), {4000, 2000, 1000});
  are(loads("1kN,2kN:4kN:2,500N"), {1000, 2000, 4000, 500});
  for (const char* wrong : {"1kN,1kN", "1kN:1kN:3", "1kN:2kN", "5kN:1kN:x", "5kN:1kN:3:cubic", "1kN,,2kN",
                            "0N:1kN:3", "1kN:0N:3:uniform", "1kN,inf"}) {
    const Outcome run = shell(smooth + "--radius 50mm --sweep " + wrong);
    CAPTURE(wrong, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
  }
}
