// asperity-pdf on several surfaces.
#include <functional>
#include <numbers>

#include "dataset/layout.hpp"
#include "ensemble_files.hpp"

using namespace asperity;
using namespace asperity::test;
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

TEST_CASE("asperity-pdf prints quantiles whose interval is open on one side", "[pdf-tool][contract]") {
  require("asperity-generate --shape 40x30 --size 400um,300um --rq 1um --length 30um --seed 3 -o small.nc");
  const std::string quantiles = "asperity-pdf --correlation estimate --estimate quantiles --rows 99 small.nc";
  CHECK_THAT(require(quantiles).out, ContainsSubstring("\t-inf\t"));
  const Json table = json_of(quantiles + " --json");
  CHECK(table["low_95"]["values"][0].is_null());
  CHECK(table["high_95"]["values"][0].is_number());
  CHECK(table["high_95"]["values"][98].is_null());
}
