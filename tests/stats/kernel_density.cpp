#include "stats/height/kernel_density.hpp"

#include "core/error.hpp"
#include "fields.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

EffectiveSampleSize independent(const Grid& g) {
  return EffectiveSampleSize(triangular_correlation({1, 1}), g);
}

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

// 300 fields: each mean square is 1 with a spread of √(2/300) = 8 %, four of them; terms of second order.
TEST_CASE("a correlated Gaussian field strays from its density by one error at each height",
          "[kernel-density][statistics]") {
  const Shape window{6, 5};
  const Grid g = grid(72, 60);
  const EffectiveSampleSize size(triangular_correlation(window), g);
  std::vector<Spread> fitted(5);
  for (unsigned seed = 0; seed < 300; ++seed) {
    Field z = moving_average(g.shape, window, seed);
    const Moments own = moments(z);
    z(0, 0) = -3;  // so that the heights of the curve are the same ones in each field
    z(0, 1) = 3;
    const auto to_own = compared(z.max(-3).min(3), own, size, 0.3, 9);
    for (std::size_t i = 2; i < 7; ++i) {
      const DensityPoint& f = to_own[i];
      fitted[i - 2].add(std::pow((f.density - f.gaussian) / f.misfit_error, 2));
    }
  }
  for (std::size_t i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(fitted[i].mean() == Approx(1).margin(0.35));
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
