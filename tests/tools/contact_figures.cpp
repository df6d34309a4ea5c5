// What --add tells of a contact beyond its solution: ratios, patches, energies, and what the grid leaves.
#include "tools/harness.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// 64 x 48 cells that are not square.
void draw_flat() {
  require(
      "asperity-generate -q --shape 64x48 --size 1mm,0.6mm --rq 0.4um --length 8px --model gaussian "
      "--periodic "
      "--seed 3 -o flat.nc");
}

const std::string flats = "asperity-contact flat.nc" + steel;
const std::string further = " --add contact_ratios,elastic_energy,patches ";
const std::string band_limited =
    "asperity-generate --shape 64x64 --size 3mm --rq 0.4um --model gaussian --length 12px";
const std::string ball = " | asperity-contact --radius 50mm --load 5000N" + steel;

bool holds(const Attributes& a, const std::string& name) { return a.find("contact_" + name) != nullptr; }

// Of a stress, "" where there is none.
double stress_error(const std::string& file = "stress.nc") {
  return attribute(file, "stress_max_von_mises_error");
}

}  // namespace

TEST_CASE(
    "the ratios of flats follow from the attributes of their contact and the statistics of their heights",
    "[contact][law]") {
  draw_flat();
  const Attributes a = attributes_of(flats + "--load 20N --yield 700MPa" + further);
  auto of = [&](const char* name) { return a.number(std::string("contact_") + name, NAN); };
  const Printed heights = printed("asperity-stats flat.nc --parameters height,hybrid");
  const double nominal = 0.6e-6, sdq = heights.at("Sdq"), sq = heights.at("Sq"), slope = of("rms_slope");
  // That of the waves, in which Sdq lacks (qh)²/24 of each: 5 % of ten points in a wave at the most.
  CHECK(slope > sdq);
  CHECK(slope <= 1.05 * sdq);
  CHECK(of("rms_slope_error") == 0);
  const double summits = heights.at("summit_deviation") * heights.at("summit_curvature");
  for (const auto& [name, value] :
       {std::pair{"rms_height", sq},
        {"nayak_alpha", std::sqrt(heights.at("alpha_x") * heights.at("alpha_y"))},
        {"area_share", of("area_corrected") / nominal},
        {"reduced_pressure", 20 / nominal / (of("composite_modulus") * slope)},
        {"kappa", of("area_share") / of("reduced_pressure")},
        {"kappa_error", of("kappa") * of("area_corrected_error") / of("area_corrected")},
        {"reduced_gap", of("mean_gap") / sq},
        {"plasticity_index", of("composite_modulus") / 2.1e9 * std::sqrt(summits)}}) {
    CAPTURE(name);
    CHECK(relative_error(of(name), value) <= 1e-12);
  }
}

TEST_CASE("two bodies have the ratios of the sum of their heights", "[contact][law]") {
  draw_flat();
  const Attributes one = attributes_of(flats + "--load 20N --add contact_ratios"),
                   pair = attributes_of(flats + "--load 20N --add contact_ratios --counter flat.nc");
  for (const char* name : {"contact_rms_slope", "contact_rms_height"})
    CHECK(relative_error(pair.number(name, 0), 2 * one.number(name, 0)) <= 1e-12);
}

TEST_CASE("only what is requested and defined in a scene is told", "[contact][contract]") {
  draw_flat();
  const Attributes plain = attributes_of(flats + "--load 20N --yield 700MPa"),
                   flat = attributes_of(flats + "--load 20N" + further),
                   round = attributes_of(flats + "--load 5N --boundary free --radius 50mm" + further);
  for (const char* name : {"kappa", "rms_slope", "elastic_energy", "plastic_work", "patches", "percolates_x"})
    CHECK_FALSE(holds(plain, name));
  CHECK(holds(flat, "kappa"));
  for (const char* name : {"sphere_roughness", "plasticity_index", "plastic_work"})
    CHECK_FALSE(holds(flat, name));
  CHECK(relative_error(round.number("contact_sphere_roughness", 0),
                       round.number("contact_rms_height", 0) / round.number("contact_hertz_approach", 1)) <=
        1e-12);
  for (const char* name : {"area_share", "reduced_pressure", "kappa", "reduced_gap"})
    CHECK_FALSE(holds(round, name));
}

TEST_CASE("labels, their areas and their number are those of one set of patches", "[contact][law]") {
  draw_flat();
  require(flats + "--load 50N --add patches -o patches.nc");
  const std::vector<double> labels = values_in("patches.nc", "label"),
                            areas = values_in("patches.nc", "patch_area"),
                            state = values_in("patches.nc", "contact");
  CHECK(static_cast<double>(areas.size()) == attribute("patches.nc", "contact_patches"));
  CHECK(areas.front() == attribute("patches.nc", "contact_largest_patch"));
  CHECK(std::ranges::is_sorted(areas, std::greater<>()));
  const double cell = 1e-3 / 64 * 0.6e-3 / 48;
  double total = 0;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    const auto cells = std::ranges::count(labels, static_cast<double>(k + 1));
    CHECK(relative_error(areas[k], cell * static_cast<double>(cells)) <= 1e-12);
    total += areas[k];
  }
  CHECK(relative_error(total, attribute("patches.nc", "contact_area")) <= 1e-12);
  for (std::size_t i = 0; i < state.size(); ++i) REQUIRE((labels[i] > 0) == (state[i] > 0));
  require("asperity-contact patches.nc --load 5N -o fewer.nc" + steel);
  const Dataset again = read_dataset("fewer.nc");
  CHECK_FALSE((again.has("label") || again.has("patch_area") || holds(again.attributes, "patches")));
  CHECK(again.length("patch") == -1);
}

// Q grows with δ: its work between two rows lies between those of either load.
TEST_CASE("the energies of a sweep grow by the work of its loads", "[contact][law]") {
  draw_flat();
  const Printed table =
      printed(flats + "--sweep 2N:200N:40 --yield 700MPa --add elastic_energy --tolerance 1e-9");
  const auto &load = table["load"], &approach = table["approach"], &stored = table["elastic_energy"],
             &lost = table["plastic_work"];
  double mean_work = 0;
  for (std::size_t k = 1; k < load.size(); ++k) {
    const double work = stored[k] + lost[k] - stored[k - 1] - lost[k - 1],
                 step = approach[k] - approach[k - 1];
    CHECK(work >= load[k - 1] * step);
    CHECK(work <= load[k] * step);
    mean_work += (load[k] + load[k - 1]) / 2 * step;
  }
  CHECK(lost.back() > 0);
  CHECK(relative_error(mean_work, stored.back() + lost.back() - stored.front() - lost.front()) <= 5e-3);
}

TEST_CASE("a sweep has the figures of its loads as columns, those of its datasets", "[contact][contract]") {
  draw_flat();
  const Printed table = printed(flats + "--sweep 5N,50N --each figures-%d.nc" + further);
  for (const char* name : {"area_share", "reduced_pressure", "kappa", "reduced_gap", "elastic_energy",
                           "patches", "largest_patch", "percolates_x", "percolates_y"}) {
    CAPTURE(name);
    CHECK(table[name][1] == attribute("figures-2.nc", std::string("contact_") + name));
  }
  CHECK_FALSE((table.has("rms_slope") || table.has("kappa_error")));
  CHECK(attribute("figures-2.nc", "contact_rms_slope") > 0);
  CHECK_FALSE(printed(flats + "--sweep 5N,50N").has("kappa"));
}

TEST_CASE("a field of one row has the figures that it has", "[contact][contract]") {
  require("asperity-generate --shape 1x64 --size 1um,1mm --rq 0.4um --length 1px,8px --seed 3 -o row.nc");
  const Attributes a = attributes_of("asperity-contact row.nc -q --load 0.01N" + steel + further);
  CHECK(a.number("contact_area_share", 0) > 0);
  CHECK(a.number("contact_patches", 0) > 0);
  CHECK(a.number("contact_percolates_x", 0) == 1);
  CHECK_FALSE(holds(a, "nayak_alpha"));
}

// ---- errors of the grid ----

TEST_CASE("errors of areas are free, the others come when asked for, and not those of a former run",
          "[contact][contract]") {
  const Attributes plain = attributes_of(band_limited + ball);
  CHECK(plain.number("contact_slope_growth", 9) < 0.8);
  CHECK(plain.number("contact_area_corrected", 0) < plain.number("contact_area", 0));
  CHECK(plain.number("contact_area_error", 0) > 0);
  CHECK(plain.number("contact_area_corrected_error", 0) > 0);
  CHECK_FALSE(holds(plain, "max_pressure_error"));
  // Four cells in contact: no error of their area either.
  const Attributes few = attributes_of(
      "asperity-contact --smooth --shape 32x32 --size 1mm --radius 20mm --young 210GPa --poisson 0.3 --load "
      "0.1N ");
  CHECK(few.number("contact_area", 0) > 0);
  CHECK_FALSE(holds(few, "area_error"));
  CHECK_FALSE(holds(few, "area_corrected_error"));
  require(band_limited + ball + "--add grid_errors,contact_stiffness -o asked.nc");
  const Attributes asked = attributes_in("asked.nc");
  for (const std::string name : {"approach", "max_pressure", "plastic_area", "mean_gap", "stiffness"}) {
    CAPTURE(name);
    const double error = asked.number("contact_" + name + "_error", -1);
    CHECK(error >= 0);
    CHECK(error <= 0.2 * asked.number("contact_" + name, 0));
  }
  CHECK_FALSE(holds(asked, "load_error"));
  CHECK_FALSE(holds(attributes_of("asperity-contact --radius 50mm --load 4000N" + steel + "asked.nc"),
                    "max_pressure_error"));
}

TEST_CASE("a surface that the grid does not resolve gets no errors, and one line says so",
          "[contact][contract]") {
  const Outcome run = shell(rough + ball + "--add grid_errors -o rough.nc");
  CHECK(run.exit == 0);
  // γ is a ratio of two increments, and was told as a growth of the slope.
  CHECK_THAT(
      run.error,
      ContainsSubstring("the grid does not resolve the surface: the last halving of the cells, to these, "
                        "adds ") &&
          ContainsSubstring(" times as much to its mean square slope as the halving before"));
  const Attributes a = attributes_in("rough.nc");
  CHECK(a.number("contact_slope_growth", 0) > 2);
  for (const char* name : {"area_error", "area_corrected_error", "max_pressure_error", "approach_error"})
    CHECK_FALSE(holds(a, name));
  CHECK(shell(sphere + "--load 5kN --add grid_errors -o smooth.nc").error.empty());
}

TEST_CASE("a sweep has a column of errors beside each figure", "[contact][contract]") {
  const Printed table = printed(sphere + "--sweep 1kN,5kN --add grid_errors");
  for (const std::string name :
       {"approach", "area", "area_corrected", "plastic_area", "mean_gap", "stiffness", "max_pressure"}) {
    CAPTURE(name);
    CHECK(table[name + "_error"][1] >= 0);
  }
  CHECK_FALSE(printed(sphere + "--sweep 1kN,5kN").has("area_error"));
  require(band_limited + " --periodic -o flat.nc -q");
  const Printed many = printed(flats + "--sweep 10N,100N --add grid_errors,contact_ratios,elastic_energy");
  for (const std::string name :
       {"area_share", "reduced_pressure", "kappa", "reduced_gap", "elastic_energy"}) {
    CAPTURE(name);
    CHECK(many[name + "_error"][1] >= 0);
    CHECK(many[name + "_error"][1] <= 0.2 * many[name][1]);
  }
  // Each load has its own errors: those of a run under it alone, up to the tolerance of both.
  const Attributes alone = attributes_of(sphere + "--load 5kN --add grid_errors");
  CHECK(table["approach_error"][1] == Approx(alone.number("contact_approach_error", 0)).epsilon(1e-2));
}

TEST_CASE("on the way down a sweep's errors are those of the flattened surface", "[contact][contract]") {
  const Printed back = printed(sphere + "--yield 600MPa --sweep 5kN,2kN --add grid_errors");
  CHECK(back["approach_error"][1] > 0);
  CHECK(back["approach_error"][1] <= 0.01 * back["approach"][1]);
}

TEST_CASE("the largest stress has errors when asked for, by the contact solved again", "[stress][contract]") {
  require(band_limited + ball + "--yield 3GPa -o pressed.nc");
  const auto stress = [](const std::string& file, const std::string& more) {
    return shell("asperity-stress --maximum " + file + " -o stress.nc " + more);
  };
  REQUIRE(stress("pressed.nc", "--add grid_errors").exit == 0);
  CHECK(stress_error() > 0);
  CHECK(stress_error() < 0.3 * attribute("stress.nc", "stress_max_von_mises"));
  CHECK(attribute("stress.nc", "stress_max_depth_error") > 0);
  stress("pressed.nc", "--add grid_errors --of max_shear");
  CHECK(attribute("stress.nc", "stress_max_shear_error") > 0);
  stress("pressed.nc", "");
  CHECK(std::isnan(stress_error()));
  // A pressure without its contact, one that another program has changed since, one that the grid does not resolve.
  Dataset bare = read_dataset("pressed.nc"), edited = bare;
  bare.erase("gap");
  write_dataset(bare, "bare.nc");
  const Field twice = 2 * field_of(edited, "pressure");
  set_field(edited, "pressure", twice, {"Pa", "contact pressure"});
  write_dataset(edited, "edited.nc");
  for (const auto& [file, words] :
       {std::pair{"bare.nc", "the dataset has no gap"},
        {"edited.nc",
         "by its fields contact_load is 10000 N, not 5000 N; it was cropped or changed since"}}) {
    const Outcome refused = stress(file, "--add grid_errors");
    CHECK(refused.exit == 2);
    CHECK_THAT(refused.error, ContainsSubstring(words));
  }
  require(rough + ball + "-o rough.nc");
  const Outcome unresolved = stress("rough.nc", "--add grid_errors");
  CHECK(unresolved.exit == 0);
  CHECK_THAT(unresolved.error, ContainsSubstring("does not resolve the surface"));
  CHECK(std::isnan(stress_error()));
}

// The pressure of a contact at its limit does not fall to 0 as a root, and no bound of its edge is known.
TEST_CASE("at a limit pressure a sliding edge has no error, and one line says so", "[stress][contract]") {
  const std::string run = "asperity-stress capped.nc -q -o stress.nc --maximum --friction 0.4 ";
  require(sphere + "--load 5000N --yield 800MPa -o capped.nc");
  for (const std::string more : {"", "--add grid_errors"}) {
    CAPTURE(more);
    const Outcome sliding = shell(run + more);
    CHECK(sliding.exit == 0);
    CHECK_THAT(sliding.error, ContainsSubstring("at an edge of a contact at its limit pressure it may be "
                                                "larger, by how much is not known"));
    CHECK(sliding.error.find("limit pressure it") == sliding.error.rfind("limit pressure it"));
    CHECK((std::isnan(stress_error()) && std::isnan(attribute("stress.nc", "stress_max_depth_error"))));
  }
  // Below the edge it has one, and so has an elastic contact whose limit is not reached.
  CHECK_THAT(shell(run + "--below 2px --add grid_errors").error, !ContainsSubstring("not known"));
  CHECK(stress_error() > 0);
  require(sphere + "--load 5000N --yield 2GPa -o capped.nc");
  CHECK_THAT(shell(run).error, ContainsSubstring("at an edge of a smooth contact"));
  CHECK(stress_error() > 0);
}

TEST_CASE("an accuracy is reached on a finer grid of the same surface, or said not to be",
          "[contact][contract]") {
  require(band_limited + " --seed 7 --add kernel -o given.nc");
  Dataset given = read_dataset("given.nc");
  given.put({"note", {}, std::vector<float>{2.5F}, {}});
  write_dataset(given, "given.nc");
  const std::string line =
      "asperity-contact -q --radius 50mm --load 5000N --tolerance 1e-8" + steel + "given.nc ";
  require(line + "--add grid_errors -o coarse.nc; " + line + "--accuracy 0.5% -o fine.nc");
  auto coarse = [](const std::string& name) { return attribute("coarse.nc", "contact_" + name); };
  auto fine = [](const std::string& name) { return attribute("fine.nc", "contact_" + name); };
  for (const std::string name : {"max_pressure", "area_corrected", "approach"}) {
    CAPTURE(name);
    CHECK(fine(name + "_error") <= 0.005 * fine(name));
    // What the coarse grid stated holds, up to what the fine one has left.
    CHECK(std::abs(coarse(name) - fine(name)) <= coarse(name + "_error") + fine(name + "_error"));
  }
  const Dataset data = read_dataset("fine.nc");
  const Index times = static_cast<Index>(fine("refinement"));
  CHECK(times >= 2);
  CHECK(grid_of(data).shape == Shape{64 * times, 64 * times});
  CHECK(grid_of(data).size_x() == Approx(3e-3).epsilon(1e-12));
  CHECK(fine("accuracy") == 0.005);
  CHECK(fine("slope_growth") < coarse("slope_growth"));
  // What belongs to the user stays; a kernel, whose lengths count in samples of the given grid, does not.
  CHECK(data.has("note"));
  CHECK_FALSE((data.has("kernel") || data.attributes.find("kernel_length")));
  // A smooth body is not interpolated: the same as on that grid at once.
  require(sphere + "--load 5kN --accuracy 1% -o round.nc");
  const std::string n = std::to_string(grid_of(read_dataset("round.nc")).shape.nx);
  require("asperity-contact --smooth --shape " + n + "x" + n +
          " --size 3mm --radius 50mm --load 5kN -o direct.nc" + steel);
  CHECK(same_bits(field_in("round.nc", "pressure"), field_in("direct.nc", "pressure")));
}
