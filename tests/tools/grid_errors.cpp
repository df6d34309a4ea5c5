// What the grid leaves of a contact, as it is typed.
#include <nlohmann/json.hpp>

#include "tools/contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string band_limited =
    "asperity-generate --shape 64x64 --size 3mm --rq 0.4um --model gaussian --length 12px";
const std::string press = " | asperity-contact --radius 50mm --load 5000N" + elastic;

}  // namespace

TEST_CASE("errors of areas are free, the others come when asked for, and not those of a former run",
          "[contact][contract]") {
  const Attributes plain = attributes(band_limited + press);
  CHECK(plain.number("contact_slope_growth", 9) < 0.8);
  CHECK(plain.number("contact_area_corrected", 0) < plain.number("contact_area", 0));
  CHECK(plain.number("contact_area_error", 0) > 0);
  CHECK(plain.number("contact_area_corrected_error", 0) > 0);
  CHECK(plain.find("contact_max_pressure_error") == nullptr);
  require(band_limited + press + "--add grid_errors,contact_stiffness -o asked.nc");
  const Attributes asked = read_dataset("asked.nc").attributes;
  for (const char* name : {"approach", "max_pressure", "plastic_area", "mean_gap", "stiffness"}) {
    CAPTURE(name);
    const double error = asked.number(std::string("contact_") + name + "_error", -1);
    CHECK(error >= 0);
    CHECK(error <= 0.2 * asked.number(std::string("contact_") + name, 0));
  }
  CHECK(asked.find("contact_load_error") == nullptr);
  const Attributes again = attributes("asperity-contact --radius 50mm --load 4000N" + elastic + "asked.nc");
  CHECK(again.find("contact_max_pressure_error") == nullptr);
}

TEST_CASE("a surface that the grid does not resolve gets no errors, and one line says so",
          "[contact][contract]") {
  const Outcome rough = shell(surface + press + "--add grid_errors -o rough.nc");
  CHECK(rough.exit == 0);
  // γ is a ratio of two increments, and was told as a growth of the slope.
  CHECK_THAT(rough.error,
             ContainsSubstring("the grid does not resolve the surface: the last halving of the "
                               "cells, to these, adds ") &&
                 ContainsSubstring(" times as much to its mean square slope as the halving before"));
  const Attributes a = read_dataset("rough.nc").attributes;
  CHECK(a.number("contact_slope_growth", 0) > 2);
  for (const char* name : {"area", "area_corrected", "max_pressure", "approach"})
    CHECK(a.find(std::string("contact_") + name + "_error") == nullptr);
  CHECK(shell(smooth + "--radius 50mm --load 5kN --add grid_errors -o smooth.nc").error.empty());
}

TEST_CASE("a sweep has a column of errors beside each figure", "[contact][contract]") {
  const std::string line = smooth + "--radius 50mm --sweep 1kN,5kN --json ";
  const auto columns = nlohmann::json::parse(require(line + "--add grid_errors").out);
  for (const char* name :
       {"approach", "area", "area_corrected", "plastic_area", "mean_gap", "stiffness", "max_pressure"}) {
    CAPTURE(name);
    REQUIRE(columns.contains(std::string(name) + "_error"));
    CHECK(columns[std::string(name) + "_error"]["unit"] == columns[name]["unit"]);
    CHECK(columns[std::string(name) + "_error"]["values"][1].get<double>() >= 0);
  }
  CHECK(!nlohmann::json::parse(require(line).out).contains("area_error"));
  require(band_limited + " --periodic -o flat.nc -q");
  const auto flats = nlohmann::json::parse(require("asperity-contact flat.nc --sweep 10N,100N --json --add "
                                                   "grid_errors,contact_ratios,elastic_energy" +
                                                   elastic)
                                               .out);
  for (const char* name : {"area_share", "reduced_pressure", "kappa", "reduced_gap", "elastic_energy"}) {
    CAPTURE(name);
    const double error = flats[std::string(name) + "_error"]["values"][1];
    CHECK(error >= 0);
    CHECK(error <= 0.2 * flats[name]["values"][1].get<double>());
  }
  // Each load has its own errors: those of a run under it alone, up to the tolerance of both.
  const Attributes alone = attributes(smooth + "--radius 50mm --load 5kN --add grid_errors");
  CHECK(columns["approach_error"]["values"][1].get<double>() ==
        Approx(alone.number("contact_approach_error", 0)).epsilon(1e-2));
}

TEST_CASE("on the way down a sweep's errors are those of the flattened surface", "[contact][contract]") {
  const auto columns = nlohmann::json::parse(
      require(smooth + "--radius 50mm --yield 600MPa --sweep 5kN,2kN --json --add grid_errors").out);
  const double error = columns["approach_error"]["values"][1], approach = columns["approach"]["values"][1];
  CHECK(error > 0);
  CHECK(error <= 0.01 * approach);
}

TEST_CASE("a grid without coarser ones says so once", "[contact][contract]") {
  const Outcome odd = shell("asperity-contact --smooth --shape 50x50 --size 3mm --radius 50mm" + elastic +
                            "--sweep 1kN:5kN:3 --add grid_errors");
  CHECK(odd.exit == 0);
  CHECK(odd.error.find("multiples of 4") != std::string::npos);
  CHECK(odd.error.find("under 2 more loads") != std::string::npos);
  CHECK(odd.error.find("multiples of 4") == odd.error.rfind("multiples of 4"));
}

TEST_CASE("the largest stress has errors when asked for, by the contact solved again", "[stress][contract]") {
  require(band_limited + press + "--yield 3GPa -o pressed.nc");
  const std::string line = "asperity-stress --maximum pressed.nc -o stress.nc ";
  require(line + "--add grid_errors");
  const Attributes a = read_dataset("stress.nc").attributes;
  const double value = a.number("stress_max_von_mises", 0),
               error = a.number("stress_max_von_mises_error", -1);
  CHECK(error > 0);
  CHECK(error < 0.3 * value);
  CHECK(a.number("stress_max_depth_error", -1) > 0);
  require(line + "--add grid_errors --of max_shear");
  CHECK(read_dataset("stress.nc").attributes.number("stress_max_shear_error", -1) > 0);
  require(line);
  CHECK(read_dataset("stress.nc").attributes.find("stress_max_von_mises_error") == nullptr);
  CHECK_THAT(shell("asperity-stress --depths 10um --add grid_errors pressed.nc -o no.nc").error,
             ContainsSubstring("needs --maximum"));
  // A pressure without its contact, and one of a surface that the grid does not resolve.
  Dataset bare = read_dataset("pressed.nc");
  bare.erase("gap");
  write_dataset(bare, "bare.nc");
  const Outcome refused = shell("asperity-stress --maximum --add grid_errors bare.nc -o no.nc");
  CHECK(refused.exit == 2);
  CHECK_THAT(refused.error, ContainsSubstring("the dataset has no gap"));
  // A pressure that was changed by another program since.
  Dataset edited = read_dataset("pressed.nc");
  const Field twice = 2 * field_of(edited, "pressure");
  set_field(edited, "pressure", twice, {"Pa", "contact pressure"});
  write_dataset(edited, "edited.nc");
  const Outcome changed = shell("asperity-stress --maximum --add grid_errors edited.nc -o no.nc");
  CHECK(changed.exit == 2);
  CHECK_THAT(changed.error,
             ContainsSubstring(
                 "by its fields contact_load is 10000 N, not 5000 N; it was cropped or changed since"));
  require(surface + press + "-o rough.nc");
  const Outcome rough = shell("asperity-stress --maximum --add grid_errors rough.nc -o stress.nc");
  CHECK(rough.exit == 0);
  CHECK_THAT(rough.error, ContainsSubstring("does not resolve the surface"));
  CHECK(read_dataset("stress.nc").attributes.find("stress_max_von_mises_error") == nullptr);
}

// The pressure of a contact at its limit does not fall to 0 as a root, and no bound of its edge is known.
TEST_CASE("at a limit pressure a sliding edge has no error, and one line says so", "[stress][contract]") {
  const std::string at = smooth + "--radius 50mm --load 5000N --yield 800MPa -o capped.nc",
                    run = "asperity-stress capped.nc -q -o stress.nc --maximum --friction 0.4 ";
  require(at);
  for (const std::string more : {"", "--add grid_errors"}) {
    CAPTURE(more);
    const Outcome sliding = shell(run + more);
    CHECK(sliding.exit == 0);
    CHECK_THAT(
        sliding.error,
        ContainsSubstring("at an edge of a contact at its limit pressure it may be larger, by how much "
                          "is not known"));
    CHECK(sliding.error.find("limit pressure it") == sliding.error.rfind("limit pressure it"));
    const Attributes a = read_dataset("stress.nc").attributes;
    CHECK(a.find("stress_max_von_mises_error") == nullptr);
    CHECK(a.find("stress_max_depth_error") == nullptr);
  }
  // Below the edge it has one, and so has an elastic contact whose limit is not reached.
  CHECK_THAT(shell(run + "--below 2px --add grid_errors").error, !ContainsSubstring("not known"));
  CHECK(read_dataset("stress.nc").attributes.number("stress_max_von_mises_error", 0) > 0);
  require(smooth + "--radius 50mm --load 5000N --yield 2GPa -o capped.nc");
  CHECK_THAT(shell(run).error, ContainsSubstring("at an edge of a smooth contact"));
  CHECK(read_dataset("stress.nc").attributes.number("stress_max_von_mises_error", 0) > 0);
}

// Under an approach the contact on coarser cells has the approach, and another load.
TEST_CASE("a contact tells whether its load or its approach was prescribed", "[contact][contract]") {
  CHECK(attributes(smooth + "--radius 50mm --load 5kN").text("contact_prescribed") == "load");
  CHECK(attributes(smooth + "--radius 50mm --approach 30um").text("contact_prescribed") == "approach");
}

TEST_CASE("an accuracy is reached on a finer grid of the same surface, or said not to be",
          "[contact][contract]") {
  require(band_limited + " --seed 7 --add kernel -o given.nc");
  Dataset given = read_dataset("given.nc");
  given.put({"note", {}, std::vector<float>{2.5F}, {}});
  write_dataset(given, "given.nc");
  const std::string line =
      "asperity-contact -q --radius 50mm --load 5000N --tolerance 1e-8" + elastic + "given.nc ";
  require(line + "--add grid_errors -o coarse.nc; " + line + "--accuracy 0.5% -o fine.nc");
  const Dataset coarse = read_dataset("coarse.nc"), fine = read_dataset("fine.nc");
  auto of = [](const Dataset& data, const std::string& name) {
    return data.attributes.number("contact_" + name, NAN);
  };
  for (const std::string name : {"max_pressure", "area_corrected", "approach"}) {
    CAPTURE(name);
    CHECK(of(fine, name + "_error") <= 0.005 * of(fine, name));
    // What the coarse grid stated holds, up to what the fine one has left.
    CHECK(std::abs(of(coarse, name) - of(fine, name)) <=
          of(coarse, name + "_error") + of(fine, name + "_error"));
  }
  const Index times = static_cast<Index>(of(fine, "refinement"));
  CHECK(times >= 2);
  CHECK(grid_of(fine).shape == Shape{64 * times, 64 * times});
  CHECK(grid_of(fine).size_x() == Approx(3e-3).epsilon(1e-12));
  CHECK(of(fine, "accuracy") == 0.005);
  // What belongs to the user stays; a kernel, whose lengths count in samples of the given grid, does not.
  CHECK(fine.has("note"));
  CHECK_FALSE(fine.has("kernel"));
  CHECK(fine.attributes.find("kernel_length") == nullptr);
  CHECK(of(fine, "slope_growth") < of(coarse, "slope_growth"));
  // A smooth body is not interpolated: the same as on that grid at once.
  require(
      "asperity-contact --smooth --shape 64x64 --size 3mm --radius 50mm --load 5kN --accuracy 1% -o "
      "round.nc" +
      elastic);
  const Dataset round = read_dataset("round.nc");
  const std::string cells = std::to_string(grid_of(round).shape.nx);
  require("asperity-contact --smooth --shape " + cells + "x" + cells +
          " --size 3mm --radius 50mm --load 5kN -o direct.nc" + elastic);
  CHECK((field_of(round, "pressure") == field_of(read_dataset("direct.nc"), "pressure")).all());
}

TEST_CASE("an accuracy that cannot be reached is exit 3 and one line why", "[contact][contract]") {
  const Outcome rough = shell(surface + press + "--accuracy 1% -o rough.nc");
  CHECK(rough.exit == 3);
  CHECK_THAT(rough.error, ContainsSubstring("the accuracy is not reached: the grid does not resolve"));
  CHECK(grid_of(read_dataset("rough.nc")).shape == Shape{64, 64});
  const Outcome odd = shell(
      "asperity-contact --smooth --shape 50x50 --size 3mm --radius 50mm --load 5kN "
      "--accuracy 1% -o odd.nc" +
      elastic);
  CHECK(odd.exit == 3);
  CHECK_THAT(odd.error, ContainsSubstring("multiples of 4"));
  for (const auto& [options, words] : {std::pair("-o no.nc --load 5kN --accuracy 0", "not between 0 and 1"),
                                       {"-o no.nc --load 5kN --accuracy 100%", "not between 0 and 1"},
                                       {"-o no.nc --load 5kN --accuracy 1mm", "--accuracy"},
                                       {"--sweep 1kN,5kN --accuracy 1%", "one surface under one load"}}) {
    const Outcome run = shell(smooth + "--radius 50mm " + options);
    CAPTURE(options, run.error);
    CHECK(run.exit == 2);
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
}
