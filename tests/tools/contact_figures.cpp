// What --add tells of a contact beyond its solution.
#include <nlohmann/json.hpp>

#include "tools/contact_runs.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

const std::string flats = "asperity-contact flat.nc" + elastic;
const std::string further = " --add contact_ratios,elastic_energy,patches ";

// 64 x 48 cells that are not square.
void draw_flat() {
  require(
      "asperity-generate --shape 64x48 --size 1mm,0.6mm --rq 0.4um --length 8px --model gaussian "
      "--periodic --seed 3 -o flat.nc");
}

}  // namespace

TEST_CASE(
    "the ratios of flats follow from the attributes of their contact and the statistics of their heights",
    "[contact][law]") {
  draw_flat();
  const Attributes a = attributes(flats + "--load 20N --yield 700MPa" + further);
  auto of = [&](const char* name) { return a.number(std::string("contact_") + name, NAN); };
  const auto json =
      nlohmann::json::parse(require("asperity-stats flat.nc --parameters height,hybrid --json").out);
  const double nominal = 0.6e-6, sdq = json["Sdq"]["value"], sq = json["Sq"]["value"];
  // That of the waves, in which Sdq lacks (qh)²/24 of each: 5 % of ten points in a wave at the most.
  const double slope = of("rms_slope");
  CHECK(slope > sdq);
  CHECK(slope <= 1.05 * sdq);
  CHECK(of("rms_slope_error") == 0);
  CHECK(relative_error(of("rms_height"), sq) <= 1e-12);
  CHECK(relative_error(of("nayak_alpha"), std::sqrt(json["alpha_x"]["value"].get<double>() *
                                                    json["alpha_y"]["value"].get<double>())) <= 1e-12);
  CHECK(relative_error(of("area_share"), of("area_corrected") / nominal) <= 1e-12);
  CHECK(relative_error(of("reduced_pressure"), 20 / nominal / (of("composite_modulus") * slope)) <= 1e-12);
  CHECK(relative_error(of("kappa_error") / of("kappa"), of("area_corrected_error") / of("area_corrected")) <=
        1e-12);
  CHECK(relative_error(of("kappa"), of("area_share") / of("reduced_pressure")) <= 1e-12);
  CHECK(relative_error(of("reduced_gap"), of("mean_gap") / sq) <= 1e-12);
  const double summits =
      json["summit_deviation"]["value"].get<double>() * json["summit_curvature"]["value"].get<double>();
  CHECK(relative_error(of("plasticity_index"), of("composite_modulus") / 2.1e9 * std::sqrt(summits)) <=
        1e-12);
}

TEST_CASE("two bodies have the ratios of the sum of their heights", "[contact][law]") {
  draw_flat();
  const Attributes one = attributes(flats + "--load 20N --add contact_ratios");
  const Attributes pair = attributes(flats + "--load 20N --add contact_ratios --counter flat.nc");
  CHECK(relative_error(pair.number("contact_rms_slope", 0), 2 * one.number("contact_rms_slope", 0)) <= 1e-12);
  CHECK(relative_error(pair.number("contact_rms_height", 0), 2 * one.number("contact_rms_height", 0)) <=
        1e-12);
}

TEST_CASE("only what is requested and defined in a scene is told", "[contact][contract]") {
  draw_flat();
  auto told = [](const Attributes& a, const char* name) {
    return a.find(std::string("contact_") + name) != nullptr;
  };
  const Attributes plain = attributes(flats + "--load 20N --yield 700MPa");
  for (const char* name : {"kappa", "rms_slope", "elastic_energy", "plastic_work", "patches", "percolates_x"})
    CHECK_FALSE(told(plain, name));
  const Attributes flat = attributes(flats + "--load 20N" + further);
  CHECK(told(flat, "kappa"));
  for (const char* name : {"sphere_roughness", "plasticity_index", "plastic_work"})
    CHECK_FALSE(told(flat, name));
  const Attributes ball = attributes(flats + "--load 5N --boundary free --radius 50mm" + further);
  CHECK(relative_error(ball.number("contact_sphere_roughness", 0),
                       ball.number("contact_rms_height", 0) / ball.number("contact_hertz_approach", 1)) <=
        1e-12);
  for (const char* name : {"area_share", "reduced_pressure", "kappa", "reduced_gap"})
    CHECK_FALSE(told(ball, name));
  const Outcome smooth_one = shell(smooth + "--radius 50mm --load 5N --add contact_ratios");
  CHECK(smooth_one.exit == 2);
  CHECK_THAT(smooth_one.error, ContainsSubstring("--add") && ContainsSubstring("needs a rough surface"));
}

TEST_CASE("labels, their areas and their number are those of one set of patches", "[contact][law]") {
  draw_flat();
  require(flats + "--load 50N --add patches -o patches.nc");
  const Dataset data = read_dataset("patches.nc");
  const std::vector<double> labels = numbers(data.at("label").values),
                            areas = numbers(data.at("patch_area").values);
  const std::vector<double> state = numbers(data.at("contact").values);
  CHECK(static_cast<double>(areas.size()) == data.attributes.number("contact_patches", 0));
  CHECK(areas.front() == data.attributes.number("contact_largest_patch", 0));
  CHECK(std::ranges::is_sorted(areas, std::greater<>()));
  const double cell = 1e-3 / 64 * 0.6e-3 / 48;
  double total = 0;
  for (std::size_t k = 0; k < areas.size(); ++k) {
    CHECK(relative_error(areas[k], cell * static_cast<double>(std::ranges::count(
                                              labels, static_cast<double>(k + 1)))) <= 1e-12);
    total += areas[k];
  }
  CHECK(relative_error(total, data.attributes.number("contact_area", 0)) <= 1e-12);
  for (std::size_t i = 0; i < state.size(); ++i) REQUIRE((labels[i] > 0) == (state[i] > 0));
  require("asperity-contact patches.nc --load 5N -o fewer.nc" + elastic);
  const Dataset again = read_dataset("fewer.nc");
  CHECK_FALSE(again.has("label"));
  CHECK_FALSE(again.has("patch_area"));
  CHECK(again.length("patch") == -1);
  CHECK(again.attributes.find("contact_patches") == nullptr);
}

// Q grows with δ: its work between two rows lies between those of either load.
TEST_CASE("the energies of a sweep grow by the work of its loads", "[contact][law]") {
  draw_flat();
  const auto json = nlohmann::json::parse(
      require(flats + "--sweep 2N:200N:40 --yield 700MPa --add elastic_energy --tolerance 1e-9 --json").out);
  auto column = [&](const char* name) { return json[name]["values"].get<std::vector<double>>(); };
  const auto load = column("load"), approach = column("approach"), stored = column("elastic_energy"),
             lost = column("plastic_work");
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
  const auto json =
      nlohmann::json::parse(require(flats + "--sweep 5N,50N --each figures-%d.nc --json" + further).out);
  const Attributes second = read_dataset("figures-2.nc").attributes;
  for (const char* name : {"area_share", "reduced_pressure", "kappa", "reduced_gap", "elastic_energy",
                           "patches", "largest_patch", "percolates_x", "percolates_y"}) {
    CAPTURE(name);
    CHECK(json[name]["values"][1].get<double>() == second.number(std::string("contact_") + name, NAN));
  }
  CHECK_FALSE(json.contains("rms_slope"));
  CHECK_FALSE(json.contains("kappa_error"));
  CHECK(second.number("contact_rms_slope", 0) > 0);
  CHECK_FALSE(nlohmann::json::parse(require(flats + "--sweep 5N,50N --json").out).contains("kappa"));
}

TEST_CASE("a field of one row has the figures that it has", "[contact][contract]") {
  draw_flat();
  require("asperity-generate --shape 1x64 --size 1um,1mm --rq 0.4um --length 1px,8px --seed 3 -o row.nc");
  const Outcome run = shell("asperity-contact row.nc -q --load 0.01N -o out.nc" + elastic + further);
  CAPTURE(run.error);
  REQUIRE(run.exit == 0);
  const Attributes a = read_dataset("out.nc").attributes;
  CHECK(a.number("contact_area_share", 0) > 0);
  CHECK(a.number("contact_patches", 0) > 0);
  CHECK(a.number("contact_percolates_x", 0) == 1);
  CHECK(a.find("contact_nayak_alpha") == nullptr);
}
