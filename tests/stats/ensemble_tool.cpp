// asperity-stats on several surfaces, and its tests of Gaussianity.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <nlohmann/json.hpp>

#include "dataset/layout.hpp"
#include "fields.hpp"
#include "tools/files.hpp"
#include "tools/shell.hpp"

using namespace asperity;
using namespace asperity::test;
using Json = nlohmann::json;

namespace {

const Shape window{5, 3};

// g_0.nc … : 0.4 µm of moving average over 5 × 3 points of 20 µm, with its target; cubed where asked for.
void write_surfaces(unsigned count, bool cubed = false) {
  const Grid grid{{80, 72}, 20e-6, 20e-6, false};
  const LagField rho = triangular_correlation(window);
  const Field target =
      Field::NullaryExpr(7, 9, [&](Index p, Index column) { return 0.16e-12 * rho(p, column - 4); });
  for (unsigned m = 0; m < count; ++m) {
    Dataset data;
    set_grid(data, grid);
    const Field z = moving_average(grid.shape, window, 70 + m);
    set_field(data, "heights", 0.4e-6 * (cubed ? z.cube().eval() : z), {"m", "heights"});
    set_table(data, "acf_target", target, {"p", 0, 20e-6, "m"}, {"q", -4, 20e-6, "m"},
              {"m2", "autocorrelation asked for"});
    write_dataset(data, "g_" + std::to_string(m) + ".nc");
  }
}

Json json_of(const std::string& command) {
  const Outcome run = shell(command + " --json -q");
  INFO(run.error);
  REQUIRE(run.exit == 0);
  return Json::parse(run.out);
}

double value_in(const Json& table, const std::string& quantity, const std::string& column) {
  const Json& names = table["quantity"]["values"];
  const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), quantity) - names.begin());
  return table[column]["values"].at(row);
}

}  // namespace

// Ssk and Sku of all heights by their moments, left out one by one; Sq as the theory of its triangular
// correlation has it: of 15 points, so that the field's own mean takes w = 15/5760 of the variance. The spread
// of eight is known to 1/√14 of it, four of which are 1.07.
TEST_CASE("of several surfaces asperity-stats pools moments, with errors by the jackknife",
          "[stats-tool][law]") {
  write_surfaces(8);
  const Json all = json_of("asperity-stats g_?.nc");
  std::vector<std::array<double, 3>> powers;
  double sum = 0, squares = 0, error = 0;
  for (int m = 0; m < 8; ++m) {
    const Json one = json_of("asperity-stats g_" + std::to_string(m) + ".nc");
    const double sq = one["Sq"]["value"];
    powers.push_back({sq * sq, one["Ssk"]["value"].get<double>() * std::pow(sq, 3),
                      one["Sku"]["value"].get<double>() * std::pow(sq, 4)});
    sum += sq, squares += sq * sq, error = one["Sq"]["standard_error"];
  }
  auto pooled = [&](std::size_t k, int without) {
    double square = 0, power = 0, n = 0;
    for (int m = 0; m < 8; ++m)
      if (m != without) square += powers[m][0], power += powers[m][k], ++n;
    return power / n / std::pow(square / n, k == 1 ? 1.5 : 2);
  };
  for (const auto& [k, name] : {std::pair{1U, "Ssk"}, {2U, "Sku"}}) {
    double left = 0, left_squares = 0;
    for (int m = 0; m < 8; ++m) left += pooled(k, m), left_squares += std::pow(pooled(k, m), 2);
    CHECK(std::abs(value_in(all, name, "mean") - pooled(k, -1)) <= 1e-12);
    CHECK(std::abs(value_in(all, name, "standard_error") -
                   std::sqrt(7.0 / 8 * (left_squares - left * left / 8))) <= 1e-7);
  }
  const double spread = std::sqrt((squares - sum * sum / 8) / 7);
  CHECK(value_in(all, "Sq", "mean") > std::sqrt(squares / 8));
  CHECK(relative_error(value_in(all, "Sq", "mean"), std::sqrt(squares / 8 / (1 - 15.0 / 5760))) <= 1e-3);
  CHECK(relative_error(value_in(all, "Sq", "spread"), spread) <= 1e-10);
  CHECK(relative_error(value_in(all, "Sq", "expected_spread"), error) <= 0.1);
  CHECK(std::abs(spread / error - 1) <= 1.07);
  CHECK(value_in(all, "Sq", "surfaces") == 8);
}

namespace {

// Of several maps of areas a, their mean square, third or fourth power over that of the square; and its error by the
// jackknife, as (3) of pooled_maps.hpp words it.
struct PowersByArea {
  std::vector<std::array<double, 3>> powers = {};
  std::vector<double> areas = {};

  double without(std::size_t k, int left_out) const {
    double square = 0, power = 0, area = 0;
    for (std::size_t m = 0; m < areas.size(); ++m)
      if (static_cast<int>(m) != left_out)
        square += areas[m] * powers[m][0], power += areas[m] * powers[m][k], area += areas[m];
    return power / area / std::pow(square / area, k == 1 ? 1.5 : 2);
  }
  double error(std::size_t k) const {
    const double whole = std::accumulate(areas.begin(), areas.end(), 0.0), all = without(k, -1);
    std::vector<double> pseudo;
    double mean = 0, sum = 0;
    for (std::size_t m = 0; m < areas.size(); ++m) {
      const double a = areas[m] / whole;
      pseudo.push_back(all / a - (1 / a - 1) * without(k, static_cast<int>(m)));
      mean += a * pseudo.back();
    }
    for (std::size_t m = 0; m < areas.size(); ++m) sum += areas[m] / whole * std::pow(pseudo[m] - mean, 2);
    return std::sqrt(sum / static_cast<double>(areas.size() - 1));
  }
};

}  // namespace

// Holes too. The third surface has twice the spacing, of which heights do not depend, and derivatives do.
TEST_CASE("maps of unequal areas and spacings are pooled by their measured areas, and have no common slopes",
          "[stats-tool][law]") {
  PowersByArea pool;
  for (const auto& [name, shape, spacing] : {std::tuple{"unequal_0.nc", Shape{40, 36}, 20e-6},
                                             {"unequal_1.nc", Shape{80, 72}, 20e-6},
                                             {"unequal_2.nc", Shape{45, 30}, 40e-6},
                                             {"unequal_3.nc", Shape{96, 20}, 20e-6}}) {
    Dataset data;
    const Grid grid{shape, spacing, spacing, false};
    set_grid(data, grid);
    Field z = 0.4e-6 * moving_average(shape, window, 80 + static_cast<unsigned>(pool.areas.size()));
    set_field(data, "heights", z, {"m", "heights"});
    if (pool.areas.empty()) z.block(5, 6, 12, 9).setConstant(NAN);
    data.find("heights")->values = std::vector<double>(z.data(), z.data() + z.size());
    write_dataset(data, name);
    pool.areas.push_back(static_cast<double>(z.isFinite().count()) * grid.cell_area());
    const Json one = json_of(std::string("asperity-stats ") + name);
    const double sq = one["Sq"]["value"];
    pool.powers.push_back({sq * sq, one["Ssk"]["value"].get<double>() * std::pow(sq, 3),
                           one["Sku"]["value"].get<double>() * std::pow(sq, 4)});
  }
  const Json all = json_of("asperity-stats --parameters height,material,hybrid,spatial,feature unequal_?.nc");
  for (const auto& [k, name] : {std::pair{1U, "Ssk"}, {2U, "Sku"}}) {
    CHECK(std::abs(value_in(all, name, "mean") - pool.without(k, -1)) <= 1e-12);
    CHECK(std::abs(value_in(all, name, "standard_error") / pool.error(k) - 1) <= 1e-9);
  }
  const auto has_value = [&](const std::string& name) {
    const Json& names = all["quantity"]["values"];
    const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    REQUIRE(row < names.size());
    return all["mean"]["values"].at(row).is_number();
  };
  for (const char* name : {"mean", "Sa", "Sq", "N", "N_eff", "Sk", "Spk", "Smr1", "Vvv", "Sal", "m0"})
    CHECK(has_value(name));
  for (const char* name : {"Sz", "Sdq", "m2_x", "alpha_y", "summit_density", "nayak_radius", "Spd", "Sha"})
    CHECK(!has_value(name));
  CHECK(shell("asperity-stats -q --parameters hybrid unequal_?.nc").exit == 4);
}

// Of the pool they would be those of all maps.
TEST_CASE("the quantiles 0 and 1 of several surfaces are the means of their extremes", "[stats-tool][law]") {
  write_surfaces(3);
  const Json all = json_of("asperity-stats --quantiles 0,0.003,0.5,1 g_?.nc");
  CHECK(value_in(all, "quantile_0", "mean") == -value_in(all, "Sv", "mean"));
  CHECK(value_in(all, "quantile_1", "mean") == value_in(all, "Sp", "mean"));
  CHECK(value_in(all, "quantile_0.003", "mean") > value_in(all, "quantile_0", "mean"));
}

// The mean of the single estimates is 3.8 % low, five of its errors. |t| of 24 degrees exceeds 4 once in 2000.
TEST_CASE("pooled maps keep the height and the lengths that a removed form took from each",
          "[stats-tool][acf-tool][statistics]") {
  REQUIRE(
      shell("asperity-generate -q --shape 48x48 --size 48um --rq 1um --model gaussian --length 6um --seed 9 "
            "--count 25 -o small_%02d.nc")
          .exit == 0);
  const std::string maps = " --remove-form 2 --correlation estimate 'small_*.nc'";
  const Json all = json_of("asperity-stats --parameters height,material,hybrid,spatial" + maps),
             lengths = json_of("asperity-acf --result lengths" + maps);
  auto t = [](const Json& table, const std::string& name, double truth) {
    return (value_in(table, name, "mean") - truth) / value_in(table, name, "standard_error");
  };
  CHECK(std::abs(t(all, "Sq", 1e-6)) <= 4);
  CHECK(std::abs(t(all, "Smc_p", 1.2815516e-6)) <= 4);
  CHECK(std::abs(t(all, "Sxp", 1.9599640e-6)) <= 4);
  // Of one curve, that of 500 heights a map: c(p) in six decimals passes one of them at most.
  const std::string c = std::to_string(1e6 * value_in(all, "Smc_p", "mean")) + "um";
  const Json ratio = json_of("asperity-stats --parameters material --material-height " + c + maps);
  CHECK(std::abs(value_in(ratio, "Smr_" + c, "mean") - 0.1) <= 1 / 12499.0);
  CHECK(std::abs(t(all, "m0", 1e-12)) <= 4);
  const double at_e = 6e-6 / std::sqrt(std::log(10));
  CHECK(std::abs(t(lengths, "length_e_x", at_e)) <= 4);
  CHECK(std::abs(t(lengths, "length_e_y", at_e)) <= 4);
  // An extreme of a noisy contour: no error that pretends, and no direction of a circle.
  for (const char* name : {"Sal", "slowest_decay", "Str", "Sal_direction"}) {
    const Json& names = all["quantity"]["values"];
    const auto row = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    CHECK(all["standard_error"]["values"].at(row).is_null());
    CHECK(all["mean"]["values"].at(row).is_number() == (name != std::string("Sal_direction")));
  }
}

// z by its definition; of two by theory, of more by the larger of spread and expected spread. Twice the height is 40 errors, and nothing else.
TEST_CASE("asperity-stats --compare marks what differs, by errors of both", "[stats-tool][compare][law]") {
  write_surfaces(8);
  auto z_of = [](const Json& t, const std::string& quantity) {
    auto at = [&](const char* column) { return value_in(t, quantity, column); };
    return (at("others") - at("first")) / std::hypot(at("first_error"), at("others_error"));
  };
  const Json one = json_of("asperity-stats g_0.nc"), other = json_of("asperity-stats g_1.nc");
  const Json two = json_of("asperity-stats g_0.nc g_1.nc --compare");
  const Json mean = json_of("asperity-stats g_[1-7].nc"), all = json_of("asperity-stats g_?.nc --compare");
  for (const std::string quantity : {"Sq", "Ssk"}) {
    CHECK(value_in(two, quantity, "first_error") == one[quantity]["standard_error"]);
    CHECK(value_in(two, quantity, "others_error") == other[quantity]["standard_error"]);
    CHECK(relative_error(
              value_in(all, quantity, "others_error"),
              std::max(value_in(mean, quantity, "spread"), value_in(mean, quantity, "expected_spread")) /
                  std::sqrt(7)) <= 1e-12);
    for (const Json& table : {two, all})
      CHECK(std::abs(value_in(table, quantity, "z") - z_of(table, quantity)) <= 1e-12);
  }
  CHECK(two["verdict"]["values"].dump().find("differs") == std::string::npos);
  CHECK(all["verdict"]["values"].dump().find("differs") == std::string::npos);

  REQUIRE(shell("asperity-filter g_1.nc --scale 2 -q -o twice.nc").exit == 0);
  const Json marked = json_of("asperity-stats g_0.nc twice.nc --compare");
  for (std::size_t row = 0; row < marked["quantity"]["values"].size(); ++row) {
    const std::string name = marked["quantity"]["values"][row], verdict = marked["verdict"]["values"][row];
    CAPTURE(name);
    CHECK(verdict == (name == "Sa" || name == "Sq"           ? "differs"
                      : marked["z"]["values"][row].is_null() ? "unknown"
                                                             : "agrees"));
  }
}

// Sv is compared with that of one twin more: z = Δ/(s √(1 + 1/9)), s the larger of their spread and its expected
// value. A scratch of 12 Sq is far below all valleys of twins, which are of 4; Sp has none. Its own error, which
// the scratch makes large, would excuse it.
TEST_CASE("a surface is compared with several others as one of them, a scratch too",
          "[stats-tool][compare][statistics]") {
  write_surfaces(10);
  Dataset data = read_dataset("g_0.nc");
  Field scratched = field_of(data, "heights");
  scratched.block(20, 10, 1, 3).setConstant(-5e-6);
  data.find("heights")->values = std::vector<double>(scratched.data(), scratched.data() + scratched.size());
  write_dataset(data, "scratched.nc");
  const Json twins = json_of("asperity-stats g_[1-9].nc");
  const Json table = json_of("asperity-stats scratched.nc g_[1-9].nc --compare");
  const double apart = value_in(table, "Sv", "others") - value_in(table, "Sv", "first"),
               spread = std::max(value_in(twins, "Sv", "spread"), value_in(twins, "Sv", "expected_spread"));
  CHECK(std::abs(value_in(table, "Sv", "z") * spread * std::sqrt(1 + 1 / 9.0) / apart - 1) <= 1e-10);
  const auto verdict = [](const Json& of, const std::string& quantity) {
    const Json& names = of["quantity"]["values"];
    const auto row =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), quantity) - names.begin());
    return of["verdict"]["values"].at(row).get<std::string>();
  };
  CHECK(verdict(table, "Sv") == "differs");
  CHECK(verdict(table, "Sp") == "agrees");
  CHECK(verdict(table, "N") == "unknown");
}

// Two lays, at 89° and at -89°, which are 2° apart, and one at 45°.
TEST_CASE("directions are compared as axes", "[stats-tool][compare][statistics]") {
  const std::string draw = "asperity-generate -q --shape 96x96 --size 1mm --rq 0.4um --length 120um,12um ";
  REQUIRE(shell(draw + "--angle 89deg --seed 1 -o a.nc && " + draw + "--angle -89deg --seed 2 -o b.nc && " +
                draw + "--angle 45deg --seed 3 -o c.nc")
              .exit == 0);
  CHECK(std::abs(value_in(json_of("asperity-stats a.nc b.nc --compare --parameters spatial"),
                          "gamma_direction", "z")) <= 4);
  const Json turned = json_of("asperity-stats a.nc c.nc --compare --parameters spatial");
  CHECK(value_in(turned, "gamma_direction", "p") <= 1e-4);
}

// Directions on either side of 90°, which is -90°, averaged to -22°.
TEST_CASE("the mean of directions over an ensemble is that of axes, the same after half a turn",
          "[ensemble][statistics]") {
  REQUIRE(shell("asperity-generate -q --shape 64x64 --size 1mm --rq 0.4um --length 120um,12um --angle 90deg "
                "--seed 1 "
                "--count 6 -o lay_%d.nc")
              .exit == 0);
  const Json mean = json_of("asperity-stats --parameters spatial lay_*.nc");
  const double angle = value_in(mean, "gamma_direction", "mean");
  CHECK(std::abs(std::remainder(angle - std::numbers::pi / 2, std::numbers::pi)) <= 0.05);
  CHECK(value_in(mean, "gamma_direction", "spread") <= 0.05);
}

TEST_CASE("a pattern, a list of files and names are one ensemble, a single file a single surface",
          "[stats-tool][contract]") {
  write_surfaces(3);
  const std::string named = shell("asperity-stats g_0.nc g_1.nc g_2.nc").out;
  CHECK(lines(named) == 14);
  CHECK(shell("asperity-stats 'g_[0-2].nc'").out == named);
  CHECK(shell("ls g_0.nc g_1.nc g_2.nc | asperity-stats --files-from -").out == named);
  CHECK(shell("ls g_0.nc g_1.nc g_2.nc | sed 's/$/\\r/' > list; asperity-stats --files-from list").out ==
        named);
  const std::string one = shell("asperity-stats g_1.nc").out;
  CHECK(one.starts_with("# quantity\tvalue [SI]\tstandard_error"));
  CHECK(shell("asperity-stats < g_1.nc").out == one);
  CHECK(shell("asperity-stats 'g_1*.nc'").out == one);
  for (const auto& [line, words] :
       {std::pair{"asperity-stats 'absent_*.nc'", "INPUT: no file matches"},
        {"echo | asperity-stats --files-from -", "--files-from: '-' lists no file"},
        {"echo - | asperity-stats --files-from -", "--files-from: '-' lists '-', but"},
        {"asperity-stats --files-from g_0.nc", "--files-from: 'g_0.nc' is not a list of files"},
        {"asperity-stats --files-from list g_0.nc", "INPUT cannot be combined with --files-from"},
        {"cat list g_0.nc | asperity-stats --files-from /dev/stdin", "is not a list of files"},
        {"echo g_0.nc g_0.nc | tr ' ' '\\n' | asperity-stats --files-from -", "'g_0.nc' is given twice"}}) {
    const Outcome run = shell(line);
    CAPTURE(line, run.error);
    CHECK((run.exit == 2 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring(words));
  }
}

// A line of /etc/shadow was printed, and the parameters of a file that nobody had named.
TEST_CASE("bytes name no files: names on standard input are refused, with the option that takes them",
          "[stats-tool][contract]") {
  write_surfaces(1);
  for (const char* tool : {"stats", "acf", "psd", "pdf", "validate", "filter --scale 2",
                           "contact --load 1N --young 1GPa --poisson 0.3", "stress --maximum"}) {
    const Outcome run =
        shell("echo 'secret 0815 token' > secret.txt; ls secret.txt g_0.nc | asperity-" + std::string(tool));
    CAPTURE(tool, run.error);
    CHECK((run.exit == 4 && lines(run.error) == 1));
    CHECK_THAT(run.error, !ContainsSubstring("0815") && ContainsSubstring("--files-from -"));
  }
  CHECK(shell("printf '1 2\\n3 word\\n' | asperity-stats").error.find("files-from") == std::string::npos);
}

// A Gaussian field's p-values are uniform: below 1e-3 once in a thousand each. The cube of one has
// Sku = 10395/225 = 46.2, far out whatever the correlation.
TEST_CASE("the tests of Gaussianity pass a Gaussian field and refuse its cube, naive p beside the true one",
          "[stats-tool][statistics]") {
  write_surfaces(1);
  const Json gaussian = json_of("asperity-stats g_0.nc --parameters gaussianity");
  write_surfaces(1, true);
  const Json cubed = json_of("asperity-stats g_0.nc --parameters gaussianity");
  for (const std::string test : {"JB", "KS", "A2", "chi2"}) {
    CAPTURE(test);
    CHECK(gaussian[test + "_p"]["value"] >= 1e-3);
    CHECK(cubed[test + "_p"]["value"] <= 1e-3);
    CHECK(gaussian[test + "_naive_p"]["value"] != gaussian[test + "_p"]["value"]);
  }
  CHECK(json_of("asperity-stats g_0.nc --parameters all").contains("KS_p"));

  Dataset data = read_dataset("g_0.nc");
  Field holes = field_of(data, "heights");
  holes.block(20, 30, 9, 12).setConstant(std::nan(""));
  data.find("heights")->values = std::vector<double>(holes.data(), holes.data() + holes.size());
  write_dataset(data, "holes.nc");
  CHECK(json_of("asperity-stats holes.nc --parameters gaussianity")["KS_p"]["value"] <= 1e-3);
}
