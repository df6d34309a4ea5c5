// What statistics tools say of surfaces of which little or nothing can be told.
#include "drawn_surface.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Dataset surface(const Grid& grid, const Field& z) {
  Dataset data;
  set_grid(data, grid);
  set_field(data, "heights", z, {"m", "heights"});
  return data;
}

const Grid square{{64, 64}, 1e-5, 1e-5, false};

// Drawn with a Gaussian correlation of so many samples, as it says.
Dataset drawn(double length) {
  const Grid g{{48, 48}, 1e-5, 1e-5, true};
  Dataset data = surface(g, 1e-6 * gaussian_acf_field(g.shape, length, 2));
  set_table(data, "acf_target",
            Field::NullaryExpr(25, 49,
                               [=](Index p, Index column) {
                                 const double r =
                                     std::hypot(static_cast<double>(p), static_cast<double>(column - 24));
                                 return 1e-12 * std::exp(-r * r / (length * length));
                               }),
            {"p", 0, g.dx, "m"}, {"q", -24, g.dy, "m"}, {"m2", "autocorrelation asked for"});
  return data;
}

Outcome refused(const std::string& command, int exit, const std::string& part) {
  const Outcome run = run_on_surface(command);
  CAPTURE(command, run.error);
  CHECK(run.exit == exit);
  CHECK(lines(run.error) == 1);
  CHECK_THAT(run.error, ContainsSubstring(part));
  return run;
}

void check_quantities(const std::string& command) {
  const Outcome run = shell(command + " --json"), text = shell(command);
  CAPTURE(command, run.error);
  REQUIRE((run.exit == 0 && text.exit == 0));
  CHECK(text.out.find("-nan") == std::string::npos);
  const Json rows = Json::parse(run.out);
  for (const auto& [name, row] : rows.items()) {
    CAPTURE(name, row.dump());
    if (row.contains("interval_95")) {
      const Json &low = row["interval_95"][0], &high = row["interval_95"][1];
      CHECK((low.is_null() || low <= row["value"]));
      CHECK((high.is_null() || row["value"] <= high));
    } else if (row.contains("standard_error")) {
      CHECK(row.contains("note"));
    }
  }
}

}  // namespace

TEST_CASE("the tools' tables hold no interval without its value, and no sign of what is no number",
          "[stats-tool][acf-tool][law][slow]") {
  const Grid small{{32, 32}, 1e-5, 1e-5, false}, periodic{small.shape, 1e-5, 1e-5, true};
  const Field bimodal = (white_noise(small.shape, 9) > 0).select(Field::Constant(32, 32, 1e-6), 0.0);
  Field spike = Field::Zero(32, 32);
  spike(20, 30) = 1e-5;
  const std::vector<Dataset> surfaces{
      surface(small, bimodal),
      surface(small, 1e-6 * white_noise(small.shape, 3)),
      surface(periodic, spike),
      surface(periodic, sine(small.shape, 1e-6, 4)),
      surface({{48, 20}, 1e-7, 3e-6, false}, 1e-6 * moving_average({48, 20}, {3, 3}, 5)),
      surface({{1, 80}, 1e-5, 1e-5, false}, 1e-6 * moving_average({1, 80}, {1, 5}, 5)),
      surface({{3, 50}, 1e-5, 1e-5, false}, 1e-6 * white_noise({3, 50}, 6))};
  for (const Dataset& data : surfaces) {
    write_dataset(data, "any.nc");
    const std::string along = data.length("x") > 1 ? "x" : "y";  // across a row there is no profile: refused
    for (const std::string& command :
         {std::string("asperity-stats --parameters all --quantiles 0,0.5,1 any.nc"),
          "asperity-stats --profile " + along + " any.nc",
          std::string("asperity-acf --result lengths --direction 30deg any.nc")})
      check_quantities(command);
  }
}

// exp(-r²/L²) sums to S_2 = π L²/2: of 48² points 1466.8/L² independent ones, 1.6 for 30 samples (the sum is
// cut at half the period), 9.9 for 12.2 and 58 for 5.
TEST_CASE("few independent heights are warned of once, and too few for errors have none",
          "[stats-tool][contract]") {
  write_dataset(drawn(30), "one.nc");
  const Outcome one = shell("asperity-stats one.nc --json --quantiles 0.5");
  CHECK((one.exit == 0 && lines(one.error) == 1));
  CHECK_THAT(one.error, ContainsSubstring("N_eff = ") && ContainsSubstring("cannot be given"));
  const Json untold = Json::parse(one.out);
  CHECK(untold["N_eff"]["value"].get<double>() < 5);
  for (const char* name : {"mean", "Sa", "Sq", "Ssk", "Sku", "quantile_0.5"}) {
    CHECK_FALSE(untold[name].contains("standard_error"));
    CHECK_FALSE(untold[name].contains("interval_95"));
    CHECK_THAT(untold[name]["note"].get<std::string>(), ContainsSubstring("is below 5"));
  }
  write_dataset(drawn(12.2), "few.nc");
  const Outcome few = shell("asperity-stats few.nc --json");
  CHECK_THAT(few.error, ContainsSubstring("N_eff = 9.9") && ContainsSubstring("rough"));
  CHECK(Json::parse(few.out)["Sq"].contains("interval_95"));
  write_dataset(drawn(5), "enough.nc");
  CHECK(shell("asperity-stats enough.nc --json").error.empty());

  for (const char* command :
       {"asperity-acf --result lengths", "asperity-acf --result profiles", "asperity-pdf"}) {
    const Outcome run = shell(std::string(command) + " one.nc --json");
    CAPTURE(command, run.error);
    CHECK_THAT(run.error, ContainsSubstring("N_eff = "));
    CHECK_THAT(run.out, !ContainsSubstring("interval_95"));
  }
  const Json profiles = Json::parse(shell("asperity-acf --result profiles one.nc --json").out);
  CHECK((profiles["standard_error"]["values"][3].is_null() && profiles["low_95"]["values"][3].is_null()));
  const Outcome page = shell("asperity-report one.nc");
  CHECK_THAT(page.out, ContainsSubstring("is below 5"));
  CHECK_THAT(shell("cp one.nc two.nc; asperity-stats one.nc two.nc few.nc").error,
             ContainsSubstring("N_eff = "));
  CHECK(lines(shell("asperity-stats -q one.nc two.nc few.nc").error) == 1);
  CHECK_THAT(shell("asperity-validate one.nc").error, ContainsSubstring("N_eff = "));
}

// All of --parameters was refused, exit status 4, for a surface without slopes in one direction, or too small
// for them.
TEST_CASE("a group that cannot be had leaves the others, and is refused where it alone was asked for",
          "[stats-tool][contract]") {
  write_dataset(surface(square, moving_average({64, 1}, {4, 1}, 4).replicate(1, 64) * 1e-6), "grooves.nc");
  const Outcome grooves = shell("asperity-stats grooves.nc --parameters all --json");
  CHECK(grooves.exit == 0);
  const Json all = Json::parse(grooves.out);
  CHECK((all["Sdq"].contains("standard_error") && all["m2_x"].contains("standard_error")));
  CHECK((all["m2_y"]["value"] == 0 && !all["m2_y"].contains("standard_error")));

  Dataset narrow = surface({{2, 90}, 1e-5, 1e-5, false}, 1e-6 * moving_average({2, 90}, {1, 3}, 4));
  std::vector<std::int8_t> mask(180, 0);
  std::fill(mask.begin() + 90, mask.end(), std::int8_t{1});
  set_flags(narrow, "mask", mask, "missing points", "present missing");
  write_dataset(narrow, "row.nc");
  const Outcome row = shell("asperity-stats row.nc --parameters all --json");
  CHECK(row.exit == 0);
  CHECK_THAT(row.error, ContainsSubstring("no hybrid parameters") && ContainsSubstring("2 x 2"));
  const Json of_row = Json::parse(row.out);
  CHECK(of_row["Sq"]["value"].get<double>() > 0);
  CHECK(of_row["Sdq"]["value"].is_null());
  CHECK_THAT(of_row["Sdq"]["note"].get<std::string>(), ContainsSubstring("2 x 2"));
  CHECK(of_row["Std"]["value"].is_null());
  const Outcome twice = shell("cp row.nc like.nc; asperity-stats -q row.nc like.nc --parameters height,hybrid");
  CHECK((twice.exit == 0 && twice.error == shell("asperity-stats row.nc --parameters height,hybrid").error));
  const Outcome alone = shell("asperity-stats row.nc --parameters hybrid");
  CHECK((alone.exit == 4 && lines(alone.error) == 1));
  CHECK(shell("asperity-report row.nc -o row.html").exit == 0);
}

// A plane of 1 mm above --remove-form plane, and what --remove-form 2 leaves of a sphere, are rounding's 1e-19 m.
TEST_CASE("what rounding leaves above a form is not presented as a surface", "[stats-tool][contract]") {
  const Field plane = sample(square, [](double x, double y) { return 1e-3 + 0.1 * x - 0.2 * y; }),
              cap = sample(square, [](double x, double y) { return (x * x + y * y) / 0.02; });
  for (const auto& [z, form] : {std::pair{plane, "plane"}, {cap, "2"}, {plane, "3"}}) {
    write_dataset(surface(square, z), "form.nc");
    for (const char* tool : {"asperity-acf --result lengths", "asperity-pdf"}) {
      const Outcome run = shell(std::string(tool) + " form.nc --remove-form " + form);
      CAPTURE(tool, form, run.error);
      CHECK((run.exit == 4 && run.out.empty()));
      CHECK_THAT(run.error, ContainsSubstring("zero to round-off"));
    }
    const Outcome flat = shell(std::string("asperity-stats form.nc --remove-form ") + form);
    CHECK((flat.exit == 0 && flat.out.find("\nSq\t0\t") != flat.out.npos));
    CHECK_THAT(flat.error, ContainsSubstring("zero to round-off"));
    CHECK(shell("asperity-stats form.nc").exit == 0);
  }
}

// 1.9 mm × 2.4 mm of 20 µm × 30 µm.
TEST_CASE("cut-offs that separate nothing are refused, or told, by name and with both lengths",
          "[stats-tool][contract]") {
  refused("asperity-stats drawn.nc --lambda-s 0.5mm --lambda-c 0.1mm", 2,
          "--lambda-s 0.5mm: 500um is not below --lambda-c, 100um");
  refused("asperity-acf drawn.nc --lambda-s 0.5mm --lambda-c 0.5mm --result lengths", 2, "--lambda-s");
  refused("asperity-psd drawn.nc --lambda-c 3mm --result radial", 2,
          "--lambda-c: 3mm is longer than the field, 2.4mm");
  refused("asperity-pdf drawn.nc --lambda-s 3mm", 2, "--lambda-s: 3mm is longer than the field, 2.4mm");
  refused("asperity-stats drawn.nc --lambda-s 50um", 2, "below two samples");
  const Outcome oblong = run_on_surface("asperity-stats drawn.nc --lambda-c 2.2mm");
  CHECK(oblong.exit == 0);
  CHECK_THAT(oblong.error, ContainsSubstring("longer than the field in x, 1.92mm"));
  CHECK(run_on_surface("asperity-stats drawn.nc --lambda-c 1.9mm").error.find("longer") == std::string::npos);
}

TEST_CASE("angles beyond a turn, repeated words and more bins than points are refused by name",
          "[stats-tool][contract]") {
  refused("asperity-stats drawn.nc --parameters hybrid --direction 725deg", 2,
          "--direction: '725deg' is more than a full turn");
  refused("asperity-acf drawn.nc --result lengths --direction=-361deg", 2, "--direction");
  refused("asperity-stats drawn.nc --parameters height,height", 2, "given twice");
  refused("asperity-stats drawn.nc --quantiles 0.5,0.50", 2, "given twice");
  refused("asperity-acf drawn.nc --result lengths --levels 0.1,1/e,0.10", 2, "given twice");
  refused("asperity-pdf drawn.nc --bins 7681", 2, "above the number of points, 7680");
  refused("asperity-pdf drawn.nc --estimate kernel --rows 2000000000", 2, "--rows");
  refused("asperity-pdf drawn.nc --estimate kernel --bandwidth 1e9", 2, "the range of heights");
}

// White noise has a length of less than a sample, whatever it is, and a correlation of 30 of 40 samples none
// that a field could tell.
TEST_CASE("lengths below a sample and beyond half the field are said to be neither", "[acf-tool][contract]") {
  write_dataset(surface(square, 1e-6 * white_noise(square.shape, 3)), "noise.nc");
  for (const char* command :
       {"asperity-acf noise.nc --result lengths", "asperity-stats noise.nc --parameters spatial"}) {
    const Outcome run = shell(command);
    CAPTURE(run.error);
    CHECK((run.exit == 0 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring("is below a sample, 10um"));
  }
  const Field slope = sample(square, [](double x, double y) { return x + 0.1 * y; });
  write_dataset(surface(square, slope + 1e-6 * white_noise(square.shape, 3)), "slope.nc");
  const Outcome far =
      shell("asperity-acf slope.nc --result lengths --biased --max-lag 63x63 --direction 90deg");
  CAPTURE(far.error, far.out);
  CHECK(far.exit == 0);
  CHECK_THAT(far.error, ContainsSubstring("is beyond half the field, 320um"));
}
