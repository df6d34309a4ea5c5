// asperity-stats on a dataset whose correlation is known, and what all statistics tools have in common.
#include <algorithm>

#include "drawn_surface.hpp"

using namespace asperity;
using namespace asperity::test;

// 4 standard errors; S_2 is a product of Σ (1 - |p|/n)(1 - |p|/w)² = (2w² + 1)/3w - (w² - 1)/6n along the axes.
TEST_CASE("asperity-stats finds the Sq that was drawn, and N_eff from the carried correlation",
          "[stats-tool][statistics]") {
  const Json carried = json_of("asperity-stats drawn.nc --json");
  const double sq = carried["Sq"]["value"], error = carried["Sq"]["standard_error"];
  CHECK(std::abs(sq - 0.4e-6) <= 4 * error);
  CHECK(std::abs(carried["Sku"]["value"].get<double>() - 3) <=
        4 * carried["Sku"]["standard_error"].get<double>());
  const double sum = (129 / 24.0 - 63 / 576.0) * (51 / 15.0 - 24 / 480.0), n_eff = carried["N_eff"]["value"];
  CHECK(n_eff == Approx(7680 / sum).epsilon(1e-12));
  CHECK(error == Approx(sq / std::sqrt(2 * n_eff)).epsilon(1e-12));
}

TEST_CASE("asperity-stats estimates the correlation as if none were carried, which comes near the drawn one",
          "[stats-tool][contract]") {
  const Json known = json_of("asperity-stats drawn.nc --json");
  const Json estimated = json_of("asperity-stats drawn.nc --json --correlation estimate");
  CHECK(known["Sq"]["value"] == estimated["Sq"]["value"]);
  const double ratio =
      estimated["Sq"]["standard_error"].get<double>() / known["Sq"]["standard_error"].get<double>();
  CHECK(std::abs(ratio - 1) <= 0.3);
  Dataset bare = drawn_surface();
  bare.erase("acf_target");
  write_dataset(bare, "bare.nc");
  CHECK(Json::parse(shell("asperity-stats bare.nc --json").out) == estimated);
}

TEST_CASE("asperity-stats prints the groups asked for, one beside the other or all",
          "[stats-tool][contract]") {
  const Json height = json_of("asperity-stats drawn.nc --json");
  CHECK_FALSE(height.contains("Sk"));
  CHECK_FALSE(height.contains("Sdq"));
  const Json two = json_of("asperity-stats drawn.nc --json --parameters material,hybrid --direction 30deg");
  for (const char* name : {"Sk",          "Spk",  "Svk", "Smr1", "Smr2",    "Spkx",         "Svkx",
                           "Sak1",        "Sak2", "Sdc", "Sxp",  "Vmp",     "Vmc",          "Vvc",
                           "Vvv",         "Sdq",  "Sdr", "m2_x", "alpha_y", "m4_direction", "summit_density",
                           "nayak_radius"})
    CHECK(two.contains(name));
  CHECK_FALSE(two.contains("Sq"));
  const Json all = json_of("asperity-stats drawn.nc --json --parameters all --quantiles 0.5,0.95");
  for (const char* name : {"Sq", "Sk", "Sal", "Str", "Std", "gamma", "Sdr", "quantile_0.5", "quantile_0.95"})
    CHECK(all.contains(name));
  CHECK(all["Sk"] == two["Sk"]);
  CHECK(relative_error(all["m0"]["value"], std::pow(all["Sq"]["value"].get<double>(), 2)) <= 100 * epsilon);
}

// The triangle's contour at 0.2 is nearest along y: 0.8 · 5 samples of 30 µm, and 0.8 · 8 of 20 µm along x,
// or a little more between the axes, where (1-a)(1-b) = 0.2 lies inside: (1 - √0.2)(8·20, 5·30) µm.
TEST_CASE("asperity-stats finds Sal and quantiles within four of their standard errors",
          "[stats-tool][statistics]") {
  const Json all = json_of("asperity-stats drawn.nc --json --parameters spatial --quantiles 0.1,0.9");
  const double sal = all["Sal"]["value"], error = all["Sal"]["standard_error"];
  const double nearest = (1 - std::sqrt(0.2)) * std::hypot(160e-6, 150e-6);
  CHECK(std::abs(sal - std::min(nearest, 120e-6)) <= 4 * error);
  for (const auto& [name, exact] : {std::pair{"quantile_0.1", -1.2816}, {"quantile_0.9", 1.2816}}) {
    const double value = all[name]["value"], standard_error = all[name]["standard_error"];
    CHECK(std::abs(value - 0.4e-6 * exact) <= 4 * standard_error);
  }
}

TEST_CASE("asperity-stats refuses groups and shares it does not know, and slopes of a pressure",
          "[stats-tool][contract]") {
  for (const char* wrong :
       {"--parameters heights", "--parameters height,,material", "--quantiles 1.5", "--quantiles x",
        "--parameters material --material-ratio 0.8,0.1", "--direction 30deg", "--sal-level 0.5",
        "--material-ratio 0.2,0.7", "--parameters spatial --sal-level 2"}) {
    const Outcome run = run_on_surface(std::string("asperity-stats drawn.nc ") + wrong);
    CAPTURE(wrong, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
  }
  Dataset data = drawn_surface();
  set_field(data, "pressure", 1e15 * field_of(data, "heights"), {"Pa", "pressure"});
  write_dataset(data, "pressed.nc");
  CHECK(shell("asperity-stats pressed.nc --variable pressure --parameters hybrid").exit == 4);
  const Json all =
      Json::parse(shell("asperity-stats pressed.nc --variable pressure --parameters material --json").out);
  CHECK(all["Sk"]["unit"] == "Pa");
  CHECK(all["Sdc"]["unit"] == "Pa");
}

TEST_CASE("a plane is taken off with --remove-form plane and the mean is reported either way",
          "[stats-tool][law]") {
  Dataset data = drawn_surface();
  const Grid grid = grid_of(data);
  const Field tilt = sample(grid, [](double x, double y) { return 1e-3 + 2e-3 * x - 1e-3 * y; });
  set_field(data, "heights", field_of(data, "heights") + tilt, {"m", "heights"});
  write_dataset(data, "tilted.nc");
  const Json flat = json_of("asperity-stats drawn.nc --json --remove-form plane");
  const Json tilted = Json::parse(shell("asperity-stats tilted.nc --json --remove-form plane").out);
  // Heights of 1e-3 m are rounded to ε 1e-3.
  CHECK(relative_error(tilted["Sq"]["value"], flat["Sq"]["value"]) <= 10 * epsilon * 1e-3 / 0.4e-6);
  CHECK(std::abs(tilted["mean"]["value"].get<double>() - flat["mean"]["value"].get<double>() - 1e-3) <=
        1e-17);
}

// x² + y² over 3 mm and 16 periods of a wave: what the form and the filters leave has the wave's rms height
// alone.
TEST_CASE(
    "a form of --remove-form 2 takes a sphere's form away, --lambda-c longer waves and --lambda-s shorter "
    "ones",
    "[stats-tool][law]") {
  const Grid grid{{128, 64}, 1e-5, 1e-5, true};
  auto wave = [](double x, double length) { return std::sin(2 * std::numbers::pi * x / length); };
  Dataset data;
  set_grid(data, grid);
  set_field(data, "heights",
            sample(grid,
                   [&](double x, double) {
                     return wave(x, 0.64e-3) + 0.1 * wave(x, 0.08e-3) + 0.01 * wave(x, 0.04e-3);
                   }),
            {"m", "heights"});
  write_dataset(data, "waves.nc");
  auto sq = [](const std::string& options) {
    return Json::parse(shell("asperity-stats waves.nc --json " + options).out)["Sq"]["value"].get<double>();
  };
  auto passed = [](double cutoff, double length) { return std::exp2(-std::pow(cutoff / length, 2)); };
  auto rms = [](double a, double b, double c) { return std::sqrt((a * a + b * b + c * c) / 2); };
  CHECK(relative_error(sq(""), rms(1, 0.1, 0.01)) <= 1e-12);
  CHECK(relative_error(sq("--lambda-c 0.2mm"), rms(1 - passed(0.2, 0.64), 0.1 * (1 - passed(0.2, 0.08)),
                                                   0.01 * (1 - passed(0.2, 0.04)))) <= 1e-12);
  CHECK(relative_error(sq("--lambda-s 0.05mm"), rms(passed(0.05, 0.64), 0.1 * passed(0.05, 0.08),
                                                    0.01 * passed(0.05, 0.04))) <= 1e-12);
  set_field(data, "heights", sample(grid, [&](double x, double y) { return 1e3 * (x * x + y * y); }),
            {"m", "heights"});
  write_dataset(data, "waves.nc");
  CHECK_THAT(shell("asperity-stats waves.nc --remove-form 2").error, ContainsSubstring("zero to round-off"));
  CHECK(shell("asperity-stats waves.nc --remove-form 21").exit == 2);
  CHECK(shell("asperity-stats waves.nc --remove-form quadric").error.find("--remove-form") !=
        std::string::npos);
  CHECK(shell("asperity-stats waves.nc --lambda-c 10um").exit == 2);
  CHECK(run_on_surface("asperity-stats drawn.nc --lambda-c 1mm --correlation drawn").exit == 4);
}

TEST_CASE("a flat field is 0 or refused in one line, as are an absent variable and lags beyond it",
          "[stats-tool][contract]") {
  Dataset smooth = drawn_surface();
  set_field(smooth, "heights", Field::Constant(96, 80, 1e-6), {"m", "heights"});
  write_dataset(smooth, "smooth.nc");
  for (const auto& [tool, exit] :
       {std::pair{"asperity-stats", 0}, {"asperity-psd", 0}, {"asperity-acf", 4}, {"asperity-pdf", 4}}) {
    const Outcome flat = shell(std::string(tool) + " smooth.nc");
    const Outcome absent = run_on_surface(std::string(tool) + " drawn.nc --variable pressure");
    CAPTURE(tool, flat.error, absent.error);
    CHECK((flat.exit == exit && lines(flat.error) == 1));
    CHECK((absent.exit == 4 && absent.error.find("pressure") != std::string::npos));
  }
  const Outcome far = run_on_surface("asperity-acf drawn.nc --max-lag 96x3");
  CHECK((far.exit == 2 && far.error.find("--max-lag") != std::string::npos));
}

// A patch and single points masked: every tool counts what is there. Sq within four standard errors, as
// without.
TEST_CASE("the statistics tools leave masked points out, and a mask of nothing changes no byte",
          "[stats-tool][law][slow]") {
  Dataset data = drawn_surface();
  std::vector<std::int8_t> mask(96 * 80, 0);
  set_flags(data, "mask", mask, "missing points", "present missing");
  write_dataset(data, "unmasked.nc");
  for (std::size_t k = 0; k < 700; ++k) mask[k] = 1;
  for (std::size_t k = 700; k < mask.size(); k += 13) mask[k] = 1;
  set_flags(data, "mask", mask, "missing points", "present missing");
  write_dataset(data, "masked.nc");
  Dataset filled = drawn_surface();
  auto& heights = std::get<std::vector<double>>(filled.find("heights")->values);
  for (std::size_t k = 0; k < mask.size(); ++k)
    if (mask[k] != 0) heights[k] = -9999;
  filled.find("heights")->attributes.set("_FillValue", -9999.0);
  write_dataset(filled, "filled.nc");

  for (const char* command :
       {"asperity-stats --parameters all --quantiles 0.5 --json ",
        "asperity-acf --result profiles --add structure_function ", "asperity-acf --result lengths ",
        "asperity-psd --result radial ", "asperity-psd --result profiles ", "asperity-pdf ",
        "asperity-stats --remove-form 3 --lambda-s 80um --lambda-c 0.5mm --json "}) {
    CAPTURE(command);
    const std::string plain = run_on_surface(std::string(command) + "drawn.nc").out;
    CHECK(shell(std::string(command) + "unmasked.nc").out == plain);
    const Outcome masked = shell(std::string(command) + "masked.nc");
    CAPTURE(masked.error);
    CHECK(masked.exit == 0);
    CHECK(masked.out != plain);
    CHECK(shell(std::string(command) + "filled.nc").out == masked.out);
  }
  const Json stats = Json::parse(shell("asperity-stats masked.nc --json").out);
  const auto missing = static_cast<double>(std::ranges::count(mask, 1));
  CHECK(stats["N_missing"]["value"] == missing);
  CHECK(stats["N"]["value"] == 96 * 80 - missing);
  CHECK(std::abs(stats["Sq"]["value"].get<double>() - 0.4e-6) <=
        4 * stats["Sq"]["standard_error"].get<double>());
  const Json bins = Json::parse(shell("asperity-pdf masked.nc --json").out);
  double counts = 0;
  for (const Json& count : bins["count"]["values"]) counts += count.get<double>();
  CHECK(counts == 96 * 80 - missing);
}

// Profiles along x of a moving average over 8 × 5: as wide as Sq but for their own means, S_1 of the triangle
// over 96 points, 8 %. Some 16 of 80 profiles are independent.
TEST_CASE(
    "asperity-stats --profile prints P names, R names after --lambda-c, and refuses areal options beside",
    "[stats-tool][contract]") {
  const Json along = json_of("asperity-stats drawn.nc --profile x --json");
  const double pq = along["Pq"]["value"], error = along["Pq"]["standard_error"];
  CHECK(std::abs(pq / std::sqrt(1 - 8.0 / 96) - 0.4e-6) <= 4 * error + 0.02e-6);
  CHECK(along["Pz"]["value"] == along["Pt"]["value"]);
  CHECK(along["profiles"]["value"] == 80);
  CHECK(along["profiles_eff"]["value"].get<double>() <= 30);
  CHECK(along.contains("PSm_spread"));
  const Json ratios = json_of("asperity-stats drawn.nc --profile x --material-ratio 0.1,0.5 --json");
  CHECK(ratios["Pmc_p"] == along["Pmc_p"]);
  CHECK(ratios["Pdc"]["value"].get<double>() < along["Pdc"]["value"].get<double>());
  CHECK_FALSE(along.contains("Sq"));
  const Json across = json_of("asperity-stats drawn.nc --profile y --lambda-c 0.6mm --json");
  CHECK(across["profiles"]["value"] == 96);
  CHECK(across["Rz"]["value"].get<double>() < across["Rt"]["value"].get<double>());
  for (const char* wrong : {"--parameters all", "--quantiles 0.5", "--direction 30deg", "--lambda-c 5mm",
                            "--material-ratio 0.8,0.1"}) {
    const Outcome run = run_on_surface(std::string("asperity-stats drawn.nc --profile x ") + wrong);
    CAPTURE(wrong, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
  }
  CHECK(run_on_surface("asperity-stats drawn.nc --profile z").exit == 2);
}

// 700 × 640 heights take 3.6 MB, twice of it to be read and five times to be measured: 17.9 of the 16.8 MB that
// are always allowed.
TEST_CASE("a field whose measurement takes more than --memory is refused in one line with what to do",
          "[stats-tool][memory][contract]") {
  REQUIRE(shell("asperity-generate -q --shape 700x640 --size 1mm --rq 0.4um --length 4px --seed 1 -o l.nc")
              .exit == 0);
  for (const std::string tool : {"asperity-stats --parameters height", "asperity-acf --result lengths",
                                 "asperity-psd --result radial", "asperity-pdf"}) {
    const Outcome run = shell(tool + " --memory 1MB l.nc");
    CAPTURE(tool, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1 && run.out.empty()));
    CHECK_THAT(run.error,
               ContainsSubstring("--memory: measuring 700x640 points needs some 18MB, more than the "
                                 "17MB that --memory allows") &&
                   ContainsSubstring("asperity-filter --crop, --decimate"));
  }
  CHECK(shell("asperity-stats --parameters height --memory 18MB l.nc").exit == 0);
}
