#include "marginal/measured.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// N quantiles of the distribution with this quantile function, in another order than by size.
template <class Quantile>
std::vector<double> sample(int count, Quantile quantile) {
  std::vector<double> out(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    out[static_cast<std::size_t>((i * 7919LL) % count)] = quantile((i + 0.5) / count);
  return out;
}

double exponential_quantile(double p) { return -std::log1p(-p); }

}  // namespace

// Between nodes h = 4.27/4096 apart g is a chord, h²/8 max|g''| below it; beyond the extremes, of probability
// 1e-5 each, it is constant, which takes some 1e-4 of the variance.
TEST_CASE("quantiles of a Gaussian sample translate a normal value into itself", "[measured][exact]") {
  const Translation g = MeasuredHeights::of(sample(50000, [](double p) {
                          return 5 + 3e-7 * gsl_cdf_ugaussian_Pinv(p);
                        })).translation();
  for (double y : {-3.0, -1.0, -0.3, 0.0, 0.7, 2.5}) {
    CAPTURE(y);
    CHECK(std::abs(g(y) - y) <= 1e-3);
  }
  CHECK(g(5) == g(9));
  CHECK(g(9) < 4.3);
}

// The exponential distribution has skewness 2 and kurtosis 9, of which the part beyond p = 1 - 1/(2N), at ln
// 2N = 12.2, holds 2N⁻¹ (12.2³ + …) = 0.02 and 2N⁻¹ (12.2⁴ + …) = 0.3.
TEST_CASE("quantiles of an exponential sample keep its mean, variance, skewness and kurtosis",
          "[measured][exact]") {
  const MeasuredHeights heights = MeasuredHeights::of(sample(100000, exponential_quantile));
  const HeightMoments moments = height_moments(heights.translation());
  CHECK(std::abs(moments.mean) <= 1e-12);
  CHECK(std::abs(moments.variance - 1) <= 1e-12);
  CHECK(std::abs(moments.skewness - 2) <= 0.02);
  CHECK(std::abs(moments.kurtosis - 9) <= 0.3);
}

TEST_CASE("a translation by quantiles is increasing and ends at the extremes of the sample",
          "[measured][law]") {
  const std::vector<double> heights = sample(1000, exponential_quantile);
  const Translation g = MeasuredHeights::of(heights).translation();
  double before = g(-6);
  for (double y = -6; y <= 6; y += 0.01) {
    CHECK(g(y) >= before);
    before = g(y);
  }
  // Ratios of differences do not depend on mean and rms.
  const double median = exponential_quantile(0.5);
  CHECK(std::abs((g(20) - g(0)) / (g(0) - g(-20)) -
                 (exponential_quantile(0.9995) - median) / (median - exponential_quantile(0.0005))) <= 1e-3);
}

TEST_CASE("heights of two values stay two values", "[measured][contract]") {
  const Translation g =
      MeasuredHeights::of(sample(1000, [](double p) { return p < 0.25 ? -1.0 : 2.0; })).translation();
  const double low = g(-3), high = g(3);
  CHECK(g(gsl_cdf_ugaussian_Pinv(0.24)) == low);
  CHECK(g(gsl_cdf_ugaussian_Pinv(0.26)) == high);
  // Mean 0 and variance 1 of shares 1/4 and 3/4; the step lies within a node's distance of its place.
  CHECK(std::abs(high - std::sqrt(1.0 / 3)) <= 1e-3);
  CHECK(std::abs(low + std::sqrt(3.0)) <= 1e-3);
}

TEST_CASE("a sample that determines no distribution is refused in one line", "[measured][contract]") {
  CHECK_THROWS_AS(MeasuredHeights::of({1, 2, 3}), DataError);
  CHECK_THROWS_AS(MeasuredHeights::of(std::vector<double>(200, 3.0)), DataError);
  std::vector<double> heights = sample(200, exponential_quantile);
  heights[17] = NAN;
  CHECK_THROWS_AS(MeasuredHeights::of(heights), DataError);
  heights[17] = INFINITY;
  CHECK_THROWS_AS(MeasuredHeights::of(heights), DataError);
}
