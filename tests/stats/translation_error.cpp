#include "stats/uncertainty/translation_error.hpp"

#include "fields.hpp"
#include "marginal/johnson.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/uncertainty/moment_interval.hpp"

using namespace asperity;
using namespace asperity::test;

// Both are the same sums; Sa's series is cut at 512 orders in both.
TEST_CASE("the errors of a translation that is none are those of a Gaussian field",
          "[translation-error][exact]") {
  const EffectiveSampleSize size(triangular_correlation({7, 4}), grid(100, 80));
  const Moments m{.mean = 7, .sa = 1.6, .sq = 2, .ssk = 0.1, .sku = 3.1};
  const MomentErrors gaussian = standard_errors(m, size),
                     translated = TranslationErrors(johnson_translation(0, 3), size).standard_errors(m.sq);
  CHECK(relative_error(translated.mean, gaussian.mean) <= 1e-10);
  CHECK(relative_error(translated.sq, gaussian.sq) <= 1e-10);
  CHECK(relative_error(translated.ssk, gaussian.ssk) <= 1e-10);
  CHECK(relative_error(translated.sku, gaussian.sku) <= 1e-10);
  const TranslationErrors errors(johnson_translation(0, 3), size);
  CHECK(std::abs(errors.ssk_bias()) <= 1e-15);
  CHECK(relative_error(errors.sku_bias(), -6 / size.effective(2)) <= 1e-10);
  // The corner of |g| at 0 costs the quadrature a step squared over 24.
  CHECK(relative_error(translated.sa, gaussian.sa) <= 2e-3);
}

// All S_k are 1, and (2) is E[f²]: for Sq (K - 1)/4, and σ² for the mean.
TEST_CASE("independent heights have the textbook's error of Sq, by their kurtosis",
          "[translation-error][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(50, 80));
  for (double kurtosis : {2.4, 5.0, 9.0}) {
    const MomentErrors error = TranslationErrors(johnson_translation(-1, kurtosis), size).standard_errors(3);
    CHECK(relative_error(error.mean, 3 / std::sqrt(4000)) <= 1e-9);
    CHECK(relative_error(error.sq, 1.5 * std::sqrt((kurtosis - 1) / 4000)) <= 1e-6);
  }
}

// 300 fields of N_eff = 1100 tell a spread to 4.1 % of it (more for Sku, whose own kurtosis is large: 8 %);
// the errors are of the first order in 1/N_eff, a few per cent here. The Gaussian's errors are wrong by
// factors.
TEST_CASE(
    "the spread of the moments of skewed fields is that predicted, which a Gaussian's errors miss by a "
    "factor",
    "[translation-error][statistics]") {
  const Shape shape{160, 160}, window{5, 5};
  const Translation g = johnson_translation(-1.3, 6);
  const CorrelationMap map(g);
  Ensemble figures;
  for (unsigned f = 0; f < 300; ++f) {
    Field z = moving_average(shape, window, f);
    g.apply({z.data(), static_cast<std::size_t>(z.size())});
    const Moments m = moments(z);
    figures.add(Eigen::ArrayXd{{m.mean, m.sa, m.sq, m.ssk, m.sku}});
  }
  const EffectiveSampleSize below(triangular_correlation(window), grid(160, 160));
  const Moments truth{.mean = 0, .sa = 1, .sq = 1, .ssk = -1.3, .sku = 6};
  const TranslationErrors errors(g, below);
  const MomentErrors error = errors.standard_errors(1);
  const Eigen::ArrayXd spread = figures.spread();
  CHECK(relative_error(error.mean, spread(0)) <= 0.13);
  CHECK(relative_error(error.sa, spread(1)) <= 0.13);
  CHECK(relative_error(error.sq, spread(2)) <= 0.13);
  CHECK(relative_error(error.ssk, spread(3)) <= 0.2);
  CHECK(relative_error(error.sku, spread(4)) <= 0.3);
  // The mean over the fields strays by the bias, within four of its own errors.
  const Eigen::ArrayXd mean = figures.mean(), own = figures.standard_error();
  CHECK(errors.ssk_bias() > 0);
  CHECK(errors.sku_bias() < -5 * 6 / below.effective(2));
  CHECK(std::abs(mean(3) - errors.ssk_bias() + 1.3) <= 4 * own(3));
  CHECK(std::abs(mean(4) - errors.sku_bias() - 6) <= 4 * own(4));
  const MomentErrors naive = standard_errors(truth, below);
  CHECK(naive.sku < 0.4 * spread(4));
  CHECK(naive.sq < 0.8 * spread(2));
  // The correlation of the heights gives back that of the field below.
  const LagField rho = triangular_correlation(window);
  const LagField heights(rho.half_plane().unaryExpr([&](double r) { return map(r); }));
  CHECK((underlying_correlation(heights, map).half_plane() - rho.half_plane()).abs().maxCoeff() <= 1e-10);
}

TEST_CASE("heights are taken for Gaussian until four standard errors speak against it",
          "[translation-error][contract]") {
  const MomentErrors gaussian{.ssk = 0.05, .sku = 0.1};
  CHECK_FALSE(evident_translation({.ssk = 0.19, .sku = 3.39}, gaussian));
  const auto skewed = evident_translation({.ssk = -0.5, .sku = 3.5}, gaussian);
  REQUIRE(skewed);
  CHECK(std::abs(height_moments(*skewed).skewness + 0.5) <= 1e-9);
  CHECK(std::abs(height_moments(*skewed).kurtosis - 3.5) <= 1e-9);
  // Two values, which no distribution of the system has exactly.
  const auto steps = evident_translation({.ssk = 0, .sku = 1}, gaussian);
  REQUIRE(steps);
  CHECK(height_moments(*steps).kurtosis <= 1.05);
  CHECK(evident_translation({.ssk = 200, .sku = 5e4}, gaussian));
}

// Of the Gaussian law the intervals differ in what Fisher's variances add in the second order, 10/N of the
// width. N is not 10⁴, where the quantiles of χ² pass from one formula to another, 2e-8 apart.
TEST_CASE("an interval of a translation that is none is that of a Gaussian field",
          "[translation-error][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(110, 100));
  const Moments m{.mean = 7, .sa = 1.5, .sq = 2, .ssk = 0.3, .sku = 2.5};
  const MomentIntervals a = confidence_intervals(m, TranslationErrors(johnson_translation(0, 3), size), size),
                        b = confidence_intervals(m, size);
  CHECK(relative_error(a.mean.high, b.mean.high) <= 1e-10);
  CHECK(relative_error(a.sq.low, b.sq.low) <= 1e-10);
  CHECK(std::abs(a.ssk.low - b.ssk.low) <= 1e-3 * (b.ssk.high - b.ssk.low));
  CHECK(std::abs(a.sku.high - b.sku.high) <= 1e-3 * (b.sku.high - b.sku.low));
}
