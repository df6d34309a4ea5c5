// Histograms, densities and quantile plots.
#include "stats/height/distribution.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/height/material_ratio.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

EffectiveSampleSize independent(const Grid& g) {
  return EffectiveSampleSize(triangular_correlation({1, 1}), g);
}

std::vector<Bin> compared(const Field& z, const Moments& m, const EffectiveSampleSize& size, int bins) {
  std::vector<Bin> out = histogram(z, bins);
  compare_with_gaussian(out, m, size);
  return out;
}

double density(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }

}  // namespace

TEST_CASE("every height falls into one bin and the bins tile the range", "[distribution][law]") {
  const Grid g = grid(37, 41);
  const Field z = random_field(g.shape, 21);
  for (int bins : {1, 2, 7, 64}) {
    const auto histogram_of_z = histogram(z, bins);
    double total = 0;
    for (std::size_t b = 0; b < histogram_of_z.size(); ++b) {
      total += histogram_of_z[b].count;
      if (b > 0) CHECK(histogram_of_z[b].lower == histogram_of_z[b - 1].upper);
    }
    CHECK(total == 37 * 41);
    CHECK(histogram_of_z.size() == static_cast<std::size_t>(bins));
    CHECK(histogram_of_z.front().lower == z.minCoeff());
    CHECK(histogram_of_z.back().upper == Approx(z.maxCoeff()).epsilon(1e-14));
  }
  CHECK_THROWS_AS(histogram(z, 0), ParameterError);
}

// 512 terms of the series against its sum, f(1-f) - c_1² - c_2²/2.
// All S_k are 1, so that the series is exact whatever its length.
TEST_CASE("misfits of independent heights have binomial errors, less what a fitted mean and Sq explain",
          "[distribution][exact]") {
  const Grid g = grid(50, 50);
  const Field z = white_noise(g.shape, 22);
  const Moments m = moments(z);
  for (const Bin& bin : compared(z, m, independent(g), 15)) {
    const double a = (bin.lower - m.mean) / m.sq, b = (bin.upper - m.mean) / m.sq;
    const double f = gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a);
    const double c1 = density(a) - density(b), c2 = a * density(a) - b * density(b);
    CAPTURE(a, b);
    CHECK(relative_error(bin.expected, 2500 * f) <= 1e-10);
    CHECK(relative_error(bin.misfit_error, std::sqrt(2500 * (f * (1 - f) - c1 * c1 - c2 * c2 / 2))) <= 1e-10);
  }
}

// Two parameters are fitted and the total is given: χ² has bins - 3 degrees of freedom; its 99.9 % quantile.
// Bins of fewer than five expected heights are left out.
TEST_CASE("Gaussian white noise passes the chi-squared test against its Gaussian overlay",
          "[distribution][statistics]") {
  const Grid g = grid(100, 100);
  const Field z = white_noise(g.shape, 23);
  const Moments m = moments(z);
  double chi_squared = 0, bins = 0;
  for (const Bin& bin : compared(z, m, independent(g), scott_bins(m, 1e4)))
    if (bin.expected >= 5) {
      chi_squared += std::pow(bin.count - bin.expected, 2) / bin.expected;
      ++bins;
    }
  CHECK(bins >= 20);
  CHECK(chi_squared <= gsl_cdf_chisq_Pinv(0.999, bins - 3));
}

// Scott's width 3.49 Sq N^{-1/3}, over a range of 2A = 2√2 Sq.
TEST_CASE("Scott's rule makes the bins as narrow as N^(-1/3)", "[distribution][exact]") {
  const Moments m = moments(sine({50, 20}, 1, 5));
  CHECK(scott_bins(m, 1000) == static_cast<int>(std::ceil(2 * std::numbers::sqrt2 / 3.4908 * 10)));
  CHECK(scott_bins(m, 8e6) == Approx(20 * scott_bins(m, 1e3)).epsilon(0.1));
}

// ---- kernel density ----

namespace {

std::vector<DensityPoint> compared(const Field& z, const Moments& m, const EffectiveSampleSize& size,
                                   double h, int rows) {
  std::vector<DensityPoint> out = kernel_density(z, h, rows);
  compare_with_gaussian(out, m, size, h);
  return out;
}

double normal_density(double x, double s) {
  return std::exp(-x * x / (2 * s * s)) / (s * std::sqrt(2 * std::numbers::pi));
}

double direct_sum(const Field& z, double t, double h) {
  double sum = 0;
  for (const double height : z.reshaped())
    if (!std::isnan(height)) sum += normal_density(t - height, h);
  return sum / static_cast<double>((!z.isNaN()).count());
}

}  // namespace

// The series' remainder, 2e-14 of the largest value, and the roundings of 1517 summands and of heights on an
// offset, which the kernel's steepest slope of 0.6 per bandwidth passes on.
TEST_CASE("the density is the direct sum over all heights, narrow and wide, on an offset, points missing",
          "[kernel-density][exact]") {
  const Grid g = grid(37, 41);
  Field z = white_noise(g.shape, 31);
  z(3, 4) = z(20, 0) = std::nan("");
  for (double offset : {0.0, 1e4})
    for (double h : {0.002, 0.3, 20.0}) {
      const Field shifted = z + offset;
      const double bound = 4e-14 + 4 * offset * epsilon / h;
      const auto curve = kernel_density(shifted, h, 101);
      double largest = 0, error = 0;
      for (const DensityPoint& point : curve) {
        const double exact = direct_sum(shifted, point.height, h);
        largest = std::max(largest, exact);
        error = std::max(error, std::abs(point.density - exact));
      }
      CAPTURE(offset, h);
      CHECK(error <= bound * largest);
    }
}

// The kernel's tails beyond three bandwidths hold 2.7e-3 of the outermost heights only; the trapezoidal rule
// of a sum of Gaussians at steps below a bandwidth errs by exp(-2π²).
TEST_CASE("the density adds up to one", "[kernel-density][law]") {
  const Grid g = grid(60, 50);
  const auto curve = kernel_density(white_noise(g.shape, 32), 0.2, 200);
  double sum = 0;
  for (const DensityPoint& point : curve) sum += point.density * (curve[1].height - curve[0].height);
  CHECK(std::abs(sum - 1) <= 2 * 2.7e-3 / 3000 + 1e-6);
}

// All S_k are 1: the series is exact whatever its length, 512 terms of it down to (1 + h²)^-512.
TEST_CASE(
    "misfits of independent heights have the kernel's own variance, less what a fitted mean and Sq explain",
    "[kernel-density][exact]") {
  const Grid g = grid(50, 50);
  const Field z = 3 * white_noise(g.shape, 33);
  const double h = 0.4 * 3, n = 2500;
  for (const DensityPoint& point : compared(z, {.mean = 0, .sq = 3}, independent(g), h, 9)) {
    const double s = std::hypot(3, h), mean = normal_density(point.height, s);
    const double square =
        normal_density(point.height, std::sqrt(9 + h * h / 2)) / (2 * h * std::sqrt(std::numbers::pi));
    const double x = point.height / s, c1 = x * 3 / s * mean, c2 = (x * x - 1) * std::pow(3 / s, 2) * mean;
    CAPTURE(point.height);
    CHECK(relative_error(point.gaussian, mean) <= 1e-12);
    CHECK(relative_error(point.misfit_error, std::sqrt((square - mean * mean - c1 * c1 - c2 * c2 / 2) / n)) <=
          1e-8);
  }
}

// Silverman's 1.06 Sq N^{-1/5}.
TEST_CASE("the bandwidth falls with the fifth root of the points", "[kernel-density][exact]") {
  CHECK(silverman_bandwidth({.sq = 2}, 1e5) == Approx(2 * 1.05922 / 10).epsilon(1e-5));
}

TEST_CASE("a density of less than two points, or of a bandwidth lost in the range, is refused",
          "[kernel-density][contract]") {
  const Grid g = grid(9, 9);
  const Field z = white_noise(g.shape, 34);
  CHECK_THROWS_AS(kernel_density(z, 0.1, 1), ParameterError);
  for (double h : {0.0, -1.0, 1e-9, std::nan(""), HUGE_VAL})
    CHECK_THROWS_AS(kernel_density(z, h, 50), ParameterError);
}

// ---- quantile plot ----

// The heights are the quantiles at k/(N-1), between which the curve is straight; so is Φ⁻¹ to second order.
TEST_CASE("heights that are a Gaussian's quantiles lie on the line", "[quantile-plot][exact]") {
  const Index n = 10001;
  const Field z = Field::NullaryExpr(1, n, [&](Index, Index i) {
    return 5 +
           2 * gsl_cdf_ugaussian_Pinv((static_cast<double>(i) + 1e-9) / (static_cast<double>(n) - 1 + 2e-9));
  });
  const auto points = quantile_plot(MaterialRatioCurve(z), {.mean = 5, .sq = 2}, independent(grid(1, n)), 20);
  CHECK(points.size() == 20);
  CHECK(points[0].share == 0.025);
  for (const QuantilePoint& point : points) {
    CHECK(std::abs(point.gaussian - (5 + 2 * point.normal)) <= 1e-14);
    CHECK(std::abs(point.height - point.gaussian) <= 1e-6);
  }
}

// All S_k are 1: p(1-p)/φ² - 1 about the mean, and x²/2 less about the line.
TEST_CASE("independent heights stray by Bahadur's error, less what a fitted mean and Sq explain",
          "[quantile-plot][exact]") {
  const Field z = white_noise({20, 20}, 41);
  for (const QuantilePoint& q :
       quantile_plot(MaterialRatioCurve(z), {.sq = 2}, independent(grid(20, 20)), 10)) {
    const double density = std::exp(-q.normal * q.normal / 2) / std::sqrt(2 * std::numbers::pi);
    const double all = q.share * (1 - q.share) / (density * density) - 1;
    CHECK(relative_error(q.height_error, 2 * std::sqrt(all / 400)) <= 1e-10);
    CHECK(relative_error(q.misfit_error, 2 * std::sqrt((all - q.normal * q.normal / 2) / 400)) <= 1e-9);
  }
}

TEST_CASE("a plot of no quantile is refused", "[quantile-plot][contract]") {
  const Field z = white_noise({9, 9}, 42);
  CHECK_THROWS_AS(quantile_plot(MaterialRatioCurve(z), moments(z), independent(grid(9, 9)), 0),
                  ParameterError);
}
