// asperity-acf and asperity-psd on several surfaces.
#include <functional>
#include <numbers>

#include "dataset/layout.hpp"
#include "ensemble_files.hpp"
#include "stats/measure/spectra.hpp"

using namespace asperity;
using namespace asperity::test;

using namespace asperity::test::eight;

// Means of eight values by two sums. A spread by differences of sums has lost ε (rms/spread)² of its digits:
// 1e-16 × 1e4 at the most here, where each spread is above a hundredth of its mean; at lag 0 both are exactly 0.
TEST_CASE("of several surfaces asperity-acf and asperity-psd print each row with its spread",
          "[acf-tool][psd-tool][law]") {
  draw();
  for (const auto& [command, value] :
       {std::pair{std::string("asperity-acf --result profiles "), std::string("acf")},
        {"asperity-acf --result profiles --absolute ", "acf"},
        {"asperity-psd --result profiles ", "psd"},
        {"asperity-psd --result radial ", "psd"}}) {
    const Json all = json_of(command + "'f_?.nc'");
    std::vector<Sums> sums(column(all, value).size());
    for (unsigned m = 0; m < members; ++m) {
      const Json one = json_of(command + "f_" + std::to_string(m) + ".nc");
      REQUIRE(column(one, value).size() == sums.size());
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i].add(column(one, value)[i], column(one, "standard_error")[i]);
    }
    const auto means = column(all, value), errors = column(all, "standard_error"),
               spreads = column(all, "spread"), expected = column(all, "expected_spread");
    for (std::size_t i = 0; i < sums.size(); ++i) {
      CAPTURE(command, i);
      CHECK(std::abs(spreads[i] - sums[i].spread()) <= 1e-9 * sums[i].spread());
      CHECK(std::isnan(expected[i]) == (sums[i].known == 0));
      if (sums[i].known > 0) CHECK(std::abs(expected[i] - sums[i].expected()) <= 1e-9 * sums[i].expected());
      CHECK(column(all, "surfaces")[i] == members);
      if (value == "acf") continue;
      CHECK(std::abs(means[i] - sums[i].mean()) <= 20 * epsilon * sums[i].rms());
      // More than a tenth of eight is one.
      CHECK(std::isnan(errors[i]) == (all["no_error"]["values"][i] != "-"));
      if (sums[i].known == members) CHECK(all["no_error"]["values"][i] == "-");
      if (!std::isnan(errors[i]))
        CHECK(std::abs(errors[i] - sums[i].spread() / std::sqrt(members)) <= 1e-9 * sums[i].spread());
    }
  }
}

// X = R + B of each from the single datasets. The mean of B is the pooled variance less the mean of R(0,0); B
// of each, w R(0,0)/(1 - w), differs from it by a part that leaves ρ, and moves its errors by B/R(0,0) at most.
TEST_CASE("the pooled ACF is a ratio of means", "[acf-tool][law]") {
  draw();
  require("asperity-acf 'f_?.nc' --max-lag 12x9 -o pooled.nc");
  const Dataset pooled = read_dataset("pooled.nc");
  Field sum = Field::Zero(13, 19);
  std::vector<Field> all;
  double variance = 0;
  for (unsigned m = 0; m < members; ++m) {
    require("asperity-acf --absolute f_" + std::to_string(m) + ".nc --max-lag 12x9 -o one.nc");
    all.push_back(table_of(read_dataset("one.nc"), "acf"));
    sum += all.back() / members, variance += all.back()(0, 9) / members;
  }
  const double took = pooled.attributes.number("acf_variance", 0) - variance;
  CHECK((took > 0 && took < 0.02 * variance));
  const Field rho = (sum + took) / (variance + took), given = table_of(pooled, "acf");
  CHECK((given - rho).abs().maxCoeff() <= 1e-3 * took / variance);
  Field squares = Field::Zero(13, 19);
  for (const Field& one : all) squares += (one + took - rho * (one(0, 9) + took)).square();
  const Field errors = (squares / (members * (members - 1.0))).sqrt() / (variance + took);
  CHECK((table_of(pooled, "acf_error") - errors).abs().maxCoeff() <= took / variance * errors.maxCoeff());
}

// A line over the wave number is its own mean over any class that it covers; classes of a finer spectrum lie
// below those of a coarser, to its first, and above its last.
TEST_CASE("spectra of several steps have means on the classes of the coarsest, and lose no line",
          "[psd-tool][exact]") {
  const auto line = [](double step, int number) {
    std::vector<SpectrumPoint> out;
    for (int k = 1; k <= number; ++k)
      out.push_back({.wave_number = k * step, .density = 3 + k * step, .standard_error = 1, .count = 4});
    return out;
  };
  const CommonWaveNumbers common({{1, 20}, {2.5, 12.5}});
  const std::vector<double> centres{0.875, 2.5, 5, 7.5, 10, 12.5, 14.125, 15, 16, 17, 18, 19, 20};
  const auto fine = common.means(line(1, 20), {1, 20}), coarse = common.means(line(2.5, 5), {2.5, 12.5});
  REQUIRE(fine.size() == centres.size());
  for (std::size_t k = 0; k < centres.size(); ++k) {
    CAPTURE(k);
    CHECK(fine[k].wave_number == Approx(centres[k]).epsilon(1e-14));
    CHECK(std::isnan(coarse[k].density) == (k == 0 || k > 5));
    if (k > 0 && k <= 5) CHECK(coarse[k].density == Approx(3 + centres[k]).epsilon(1e-14));
    if (k > 0 && k <= 5) CHECK(coarse[k].standard_error == 1);
    if (k > 0 && k != 6) CHECK(fine[k].density == Approx(3 + centres[k]).epsilon(1e-12));
    CHECK(std::isnan(fine[k].standard_error) == (k > 0 && k <= 5));
  }
  auto biased = line(1, 20);
  biased[4].no_error = NoError::leakage;
  const auto left = common.means(biased, {1, 20});
  for (std::size_t k = 0; k < left.size(); ++k) CHECK(std::isnan(left[k].density) == (k == 2));
}

// Of exp(-r/l) the density is 2π l² σ²/(1 + (ql)²)^{3/2}. To a third of the shortest wave of the finer maps
// what is folded back adds less than 4 % to it. Of t of eleven degrees |t| exceeds 5 once in 2500.
TEST_CASE("rings of maps of unequal sizes and spacings are pooled to the density that all have",
          "[psd-tool][statistics]") {
  for (int k = 0; k < 12; ++k) {
    const int n = 40 + 8 * (k % 4);
    const std::string shape = std::to_string(n), side = std::to_string(n * (1 + k % 2));
    require("asperity-generate -q --shape " + shape + "x" + shape + " --size " + side +
            "um --rq 1um --length 12um --seed " + std::to_string(60 + k) + " -o w_" + std::to_string(k) +
            ".nc");
  }
  const Json all = json_of("asperity-psd --result radial 'w_*.nc'");
  const auto q = column(all, "wave_number"), psd = column(all, "psd"), error = column(all, "standard_error"),
             surfaces = column(all, "surfaces");
  const double length = 12e-6 / std::log(10.0), square = length * length;
  int rows = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (surfaces[i] < 2 || q[i] > std::numbers::pi / 1e-6 / 3) continue;
    const double exact = 2 * std::numbers::pi * square * 1e-12 / std::pow(1 + q[i] * q[i] * square, 1.5);
    CAPTURE(i, q[i], psd[i], exact, error[i]);
    CHECK(std::abs(psd[i] - exact) <= 5 * error[i] + 0.04 * exact);
    ++rows;
  }
  CHECK(rows >= 6);
}

// The target is R(p,q) of (p, q) without the surfaces' own mean, whose variance lowers every lag alike, by
// less than 2 % of R(0,0) here (Sq² Σρ/N, Σρ below 50 samples). Errors of neighbouring lags go together:
// none of them is beyond five standard errors of seven degrees of freedom more than once in 1300 (Student).
TEST_CASE("the mean ACF of drawn surfaces is their target within its errors", "[acf-tool][statistics]") {
  draw();
  const Json all = json_of("asperity-acf --result profiles 'f_?.nc' --max-lag 8x8");
  const auto acf = column(all, "acf"), target = column(all, "target"), error = column(all, "standard_error");
  REQUIRE(acf.size() == 18);
  for (std::size_t i = 0; i < acf.size(); ++i) {
    CAPTURE(i, acf[i], target[i], error[i]);
    CHECK(std::abs(acf[i] - target[i]) <= 5 * error[i] + 0.02);
  }
}

TEST_CASE("the dataset of an ensemble holds means with errors, which asperity-kernel reads",
          "[acf-tool][psd-tool][contract]") {
  draw();
  require("asperity-acf 'f_?.nc' --biased --max-lag 12x9 --add structure_function -o mean.nc");
  const Dataset acf = read_dataset("mean.nc");
  CHECK(!acf.has("heights"));
  CHECK(acf.attributes.number("acf_surfaces", 0) == members);
  CHECK(table_of(acf, "acf")(0, 9) == 1);
  CHECK(table_of(acf, "acf_error")(0, 9) == 0);
  CHECK(std::abs(table_of(acf, "structure_function")(0, 9)) <=
        1e-12 * acf.attributes.number("acf_variance", 0));
  CHECK(shell("asperity-kernel -q --acf mean.nc | asperity-generate -q --seed 2 --shape 64x48 | "
              "asperity-stats -q")
            .exit == 0);

  require("asperity-psd 'f_?.nc' -o psd.nc");
  const Dataset psd = read_dataset("psd.nc");
  CHECK(psd.attributes.number("psd_surfaces", 0) == members);
  CHECK(psd.at("psd_error").dimensions == psd.at("psd").dimensions);
  CHECK(table_of(psd, "psd").minCoeff() > 0);
}

TEST_CASE("one surface is the same by name, pattern, list and standard input",
          "[acf-tool][psd-tool][contract]") {
  draw();
  for (const std::string tool :
       {"asperity-acf --no-history", "asperity-acf --result profiles", "asperity-acf --result lengths",
        "asperity-psd --no-history", "asperity-psd --result radial"}) {
    const std::string named = require(tool + " f_3.nc").out;
    CAPTURE(tool);
    for (const char* other : {" 'f_3*.nc'", " < f_3.nc", " - < f_3.nc", " --files-from - <<< f_3.nc"}) {
      const bool same = require(tool + other).out == named;
      CHECK(same);
    }
    CHECK(named.find("surfaces") == named.npos);
  }
  require("cp f_3.nc own.nc; asperity-acf own.nc -o own.nc");  // as ever, in its own place
  CHECK(read_dataset("own.nc").has("acf"));
}

TEST_CASE("what makes no ensemble is refused before the work, in one line", "[ensemble][contract]") {
  draw();
  require(
      "asperity-generate -q --shape 64x32 --size 1mm,0.333333333333mm --rq 0.4um --length 60um,40um --seed 1 "
      "-o short.nc");
  require("head -c 20000 f_1.nc > cut.nc; mkdir -p folder; ln -sf f_1.nc link.nc");
  for (const auto& [inputs, code, words] :
       {std::tuple{"f_0.nc f_0.nc", 2, "INPUT: 'f_0.nc' is given twice"},
        {"'f_?.nc' ./f_1.nc", 2, "INPUT: './f_1.nc' is given twice, as 'f_1.nc' too"},
        {"f_1.nc link.nc", 2, "'link.nc' is given twice"},
        {"f_0.nc - f_2.nc < f_2.nc", 2, "is given twice"},
        {"f_0.nc absent.nc", 1, "absent.nc: No such file"},
        {"'absent_*.nc'", 2, "INPUT: no file matches 'absent_*.nc'"},
        {"f_0.nc folder", 1, "folder: Is a directory"},
        {"f_0.nc cut.nc f_2.nc", 4, "cut.nc: "},
        {"f_0.nc short.nc", 4, "short.nc: its grid, 64x32 cells"},
        {"f_0.nc f_1.nc -o f_1.nc", 2, "is an input of this run"}})
    for (const char* tool : {"asperity-acf ", "asperity-psd "}) {
      const Outcome run = shell(tool + std::string(inputs));
      CAPTURE(tool, inputs, run.error);
      CHECK(run.exit == code);
      CHECK((run.out.empty() && lines(run.error) == 1));
      CHECK_THAT(run.error, ContainsSubstring(words));
    }
  CHECK(shell("asperity-acf f_0.nc short.nc --result lengths").exit ==
        0);  // with a warning, as asperity-stats
  CHECK_THAT(shell("asperity-acf f_0.nc f_1.nc --add acf_quantiles").error,
             ContainsSubstring("--add: acf_quantiles"));
}

// Heights are lengths and the contact pressure is none: a mean over both is nothing.
TEST_CASE("fields of different units are not averaged", "[ensemble][contract]") {
  draw();
  Dataset data = read_dataset("f_0.nc");
  set_field(data, "found", field_of(data, "heights"), {"m", "heights"});
  write_dataset(data, "metres.nc");
  set_field(data, "found", 1e12 * field_of(data, "heights"), {"Pa", "pressure"});
  write_dataset(data, "pascals.nc");
  for (const char* tool : {"asperity-acf", "asperity-psd", "asperity-pdf", "asperity-stats"}) {
    const Outcome run = shell(tool + std::string(" --variable found metres.nc pascals.nc"));
    CAPTURE(run.error);
    CHECK((run.exit == 4 && lines(run.error) == 1));
    CHECK_THAT(run.error, ContainsSubstring("pascals.nc: its unit, Pa, differs from that of metres.nc, m"));
  }
}

TEST_CASE("more surfaces than files may be open are averaged", "[ensemble][contract]") {
  require(
      "asperity-generate -q --shape 8x8 --size 1mm --rq 0.4um --length 2px --seed 1 --count 60 -o "
      "many_%d.nc");
  const Outcome run = shell("ulimit -n 24; asperity-psd --result profiles 'many_*.nc'");
  CAPTURE(run.error);
  CHECK(run.exit == 0);
  CHECK_THAT(run.out, ContainsSubstring("\t60\t"));
}

// ---- ensemble distribution ----

using namespace asperity::test::eight;

TEST_CASE("of several surfaces asperity-pdf prints the mean of each quantile and its error",
          "[ensemble][statistics]") {
  draw();
  const Json mean = json_of("asperity-pdf --estimate quantiles --rows 9 f_?.nc");
  const std::vector<double> value = column(mean, "height"), error = column(mean, "standard_error");
  REQUIRE(value.size() == 9);
  std::vector<double> sum(9), squares(9);
  for (unsigned k = 0; k < members; ++k) {
    const std::vector<double> one = column(
        json_of("asperity-pdf --estimate quantiles --rows 9 f_" + std::to_string(k) + ".nc"), "height");
    for (std::size_t r = 0; r < 9; ++r) sum[r] += one[r], squares[r] += one[r] * one[r];
  }
  for (std::size_t r = 0; r < 9; ++r) {
    const double of = sum[r] / members, variance = (squares[r] - members * of * of) / (members - 1);
    CHECK(std::abs(value[r] - of) <= 1e-12 * 0.4e-6);
    CHECK(error[r] == Approx(std::sqrt(variance / members)).epsilon(1e-6));
  }
  CHECK(column(mean, "surfaces")[4] == members);
  // A part of the cells: those in contact.
  require("asperity-contact -q --young 200GPa --poisson 0.3 --radius 20mm --load 5N --each p_%d.nc 'f_?.nc'");
  const Json pressed = json_of("asperity-pdf --variable pressure --estimate quantiles --rows 3 p_*.nc");
  CHECK(column(pressed, "pressure")[1] > 0);
  CHECK(column(pressed, "standard_error")[1] > 0);
}

namespace {

// The heights of all, about their own means, and what they have in common.
struct All {
  std::vector<Field> heights;
  double lowest = INFINITY, highest = -INFINITY, squares = 0;
  All() {
    for (unsigned k = 0; k < members; ++k) {
      const Field z = field_of(read_dataset("f_" + std::to_string(k) + ".nc"), "heights");
      heights.push_back(z - z.mean());
      lowest = std::min(lowest, heights.back().minCoeff());
      highest = std::max(highest, heights.back().maxCoeff());
      squares += heights.back().square().mean() / members;
    }
  }
  void check(const Json& table, std::size_t row, const std::function<double(const Field&)>& density,
             const char* error) const {
    Sums sums;
    for (const Field& z : heights) sums.add(density(z), 0);
    const double own = column(table, "density")[row];
    CAPTURE(row, own);
    CHECK(std::abs(own - sums.mean()) <= 1e-12 * sums.rms());
    CHECK(std::abs(column(table, error)[row] - sums.spread() / std::sqrt(members)) <= 1e-9 * sums.rms());
    CHECK(column(table, "surfaces")[row] == members);
  }
};

}  // namespace

// Counts and kernel sums one by one, on the range of all. Rounded as in the first test; heights as read back
// differ by ε of the mean from those of the tool, which moves a kernel sum by 1e-15.
TEST_CASE("histograms and densities of several surfaces have one range", "[ensemble][pdf-tool][law]") {
  draw();
  const All all;
  const Json bins = json_of("asperity-pdf --bins 12 f_?.nc");
  REQUIRE(column(bins, "density").size() == 12);
  const double width = (all.highest - all.lowest) / 12;
  double total = 0;
  for (std::size_t b = 0; b < 12; ++b) {
    const double from = all.lowest + static_cast<double>(b) * width, to = b == 11 ? INFINITY : from + width;
    all.check(
        bins, b, [&](const Field& z) { return ((z >= from) && (z < to)).cast<double>().mean() / width; },
        "density_error");
    CHECK(column(bins, "height")[b] == Approx(from + width / 2).margin(1e-9 * width).epsilon(0));
    total += column(bins, "density")[b] * width;
  }
  CHECK(std::abs(total - 1) <= 1e-12);
  const double own_width = 3.4908 * std::sqrt(all.squares) / std::cbrt(members * 64 * 48);
  CHECK(std::abs(static_cast<double>(column(json_of("asperity-pdf f_?.nc"), "density").size()) -
                 (all.highest - all.lowest) / own_width) <= 1);

  const Json curve = json_of("asperity-pdf --estimate kernel --bandwidth 0.2 --rows 9 f_?.nc");
  REQUIRE(column(curve, "density").size() == 9);
  const double h = 0.2 * std::sqrt(all.squares);
  for (std::size_t row = 0; row < 9; ++row) {
    const double t = all.lowest - 3 * h + static_cast<double>(row) * (all.highest - all.lowest + 6 * h) / 8;
    CHECK(column(curve, "height")[row] == Approx(t).margin(1e-9 * h).epsilon(0));
    if (row == 0 || row == 8) continue;  // φ(3) and less of a few heights
    all.check(
        curve, row,
        [&](const Field& z) {
          return (-0.5 * ((t - z) / h).square()).exp().mean() / (h * std::sqrt(2 * std::numbers::pi));
        },
        "standard_error");
  }
}

TEST_CASE("surfaces by pattern, list and partly on standard input have the same distribution",
          "[ensemble][pdf-tool][contract]") {
  draw();
  for (const std::string estimate : {"histogram", "kernel", "quantiles"}) {
    const std::string tool = "asperity-pdf -q --estimate " + estimate,
                      named = require(tool + " f_[012].nc").out;
    CAPTURE(estimate);
    CHECK(require(tool + " f_0.nc - f_2.nc < f_1.nc").out == named);
    CHECK(require("ls f_[012].nc | " + tool + " --files-from -").out == named);
  }
  const Outcome one = shell("asperity-pdf f_0.nc f_1.nc --bins 7000");
  CHECK((one.exit == 2 && lines(one.error) == 1));
  CHECK_THAT(one.error, ContainsSubstring("above the number of points, 6144"));
  // A warning of the first pass, one a surface, is not repeated by the second.
  const Outcome warned = shell("asperity-pdf -q --lambda-c 0.8mm f_0.nc f_1.nc");
  CHECK(warned.exit == 0);
  CAPTURE(warned.error);
  CHECK(lines(warned.error) == 2);
  // Cells in contact and open ones, on a range from 0.
  require("asperity-contact -q --young 200GPa --poisson 0.3 --radius 20mm --load 5N --each p_%d.nc 'f_?.nc'");
  const Json pressed = json_of("asperity-pdf --variable pressure --bins 8 p_*.nc");
  const std::vector<double> pressure = column(pressed, "pressure"), density = column(pressed, "density");
  double total = 0;
  for (const double d : density) total += d * 2 * pressure[0];
  CHECK(std::abs(total - 1) <= 1e-12);
  CHECK(column(pressed, "density_error")[0] > 0);
}

TEST_CASE("asperity-pdf prints quantiles without an error where less than one independent height lies beyond",
          "[pdf-tool][contract]") {
  require("asperity-generate --shape 40x30 --size 400um,300um --rq 1um --length 30um --seed 3 -o small.nc");
  const std::string quantiles =
      "asperity-pdf --correlation estimate --estimate quantiles --rows 999 small.nc";
  CHECK_THAT(require(quantiles).out, ContainsSubstring("\tnan\t"));
  const Json table = json_of(quantiles + " --json");
  for (const char* name : {"standard_error", "low_95", "high_95"}) {
    CHECK(table[name]["values"][0].is_null());
    CHECK(table[name]["values"][499].is_number());
    CHECK(table[name]["values"][998].is_null());
  }
}
