#include "stats/height/distribution.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"

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

// 300 fields: each bin's mean square is 1 with a spread of √(2/300) = 8 %; four of them, over eight bins, and
// edges that follow the extremes of each field.
TEST_CASE("a correlated Gaussian field strays from its overlay by one error in each bin",
          "[distribution][statistics]") {
  const Shape window{6, 5};
  const Grid g = grid(72, 60);
  const EffectiveSampleSize size(triangular_correlation(window), g);
  std::vector<Spread> fitted(10);
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Field z = moving_average(g.shape, window, seed);
    const auto own = compared(z, moments(z), size, 10);
    for (std::size_t b = 1; b < 9; ++b)
      fitted[b].add(std::pow((own[b].count - own[b].expected) / own[b].misfit_error, 2));
  }
  for (std::size_t b = 1; b < 9; ++b) {
    CAPTURE(b);
    CHECK(fitted[b].mean() == Approx(1).margin(0.35));
  }
}

// Scott's width 3.49 Sq N^{-1/3}, over a range of 2A = 2√2 Sq.
TEST_CASE("Scott's rule makes the bins as narrow as N^(-1/3)", "[distribution][exact]") {
  const Moments m = moments(sine({50, 20}, 1, 5));
  CHECK(scott_bins(m, 1000) == static_cast<int>(std::ceil(2 * std::numbers::sqrt2 / 3.4908 * 10)));
  CHECK(scott_bins(m, 8e6) == Approx(20 * scott_bins(m, 1e3)).epsilon(0.1));
}
