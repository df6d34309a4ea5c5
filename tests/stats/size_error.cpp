#include "stats/uncertainty/size_error.hpp"

#include <vector>

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "marginal/johnson.hpp"
#include "named.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure.hpp"
#include "stats/uncertainty/lag_waves.hpp"
#include "stats/uncertainty/moment_interval.hpp"
#include "stats/uncertainty/translation_error.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Sample sample_of(const Field& z, bool periodic = false) {
  return Sample({.grid = grid(z.rows(), z.cols(), periodic), .heights = remove_form(z)});
}

Parameters heights_of(const Sample& sample) { return measure(sample, Group::height, {}); }

}  // namespace

// S_k does not know the unit, and a wave is a sum of products: a power of two is exact.
TEST_CASE("errors of effective sample sizes do not depend on the unit of the heights", "[size-error][law]") {
  const Field z = moving_average({64, 48}, {4, 3}, 71);
  const auto one = sample_of(z).size_errors(), other = sample_of(0x1p-20 * z).size_errors();
  for (int k = 2; k <= 4; ++k) CHECK((*one)(k) == (*other)(k));
}

TEST_CASE("the interval of an effective sample size is Student's about the value", "[size-error][exact]") {
  const Sample sample = sample_of(moving_average({80, 80}, {4, 4}, 72));
  const auto errors = sample.size_errors();
  const double degrees = LagWaves(sample.surface().heights, sample.grid(), {1, 1}, sample.extent()).degrees();
  const double value = sample.size().effective(2), half = gsl_cdf_tdist_Pinv(0.975, degrees) * (*errors)(2);
  CHECK(errors->interval(2).high == Approx(value + half).epsilon(1e-9));
  CHECK(errors->interval(2).low == Approx(value - half).epsilon(1e-9));
}

// Errors are as large as the sizes here, and most intervals would begin below zero.
TEST_CASE("of a field of few lengths the intervals of effective sample sizes begin at 1 at least",
          "[size-error][law]") {
  for (const bool periodic : {false, true})
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Sample sample = sample_of(moving_average({40, 40}, {9, 9}, 80 + seed), periodic);
      const auto errors = sample.size_errors();
      CHECK(errors.has_value() == sample.size().gives_errors());
      if (!errors) continue;
      for (int k = 2; k <= 4; ++k) {
        const double value = sample.size().effective(k);
        const Interval ends = errors->interval(k);
        CHECK((1 <= ends.low && ends.low <= value && value <= ends.high));
      }
    }
}

// What the rows say: errors for Sq, Ssk and Sku where the correlation is estimated, else a reason or, where it is
// known, neither.
TEST_CASE("effective sample sizes have an error, a reason why not, or are exact", "[size-error][contract]") {
  const Field z = moving_average({96, 96}, {5, 4}, 73);
  const Parameters estimated = heights_of(sample_of(z));
  for (const char* name : {"N_eff", "N_eff_Ssk", "N_eff_Sku"}) {
    CHECK(named(estimated, name).standard_error > 0);
    CHECK(named(estimated, name).interval_95().known());
  }
  CHECK(std::isnan(named(estimated, "N_eff_mean").standard_error));
  CHECK(named(estimated, "N_eff_mean").why.starts_with("no standard error: "));

  Surface drawn{.grid = grid(96, 96), .heights = remove_form(z)};
  drawn.correlation = triangular_correlation({5, 4});
  const Parameters known = heights_of(Sample(std::move(drawn)));
  for (const char* name : {"N_eff_mean", "N_eff", "N_eff_Ssk", "N_eff_Sku"}) {
    CHECK(std::isnan(named(known, name).standard_error));
    CHECK(named(known, name).why.empty());
  }

  const Parameters few = heights_of(sample_of(moving_average({24, 24}, {20, 20}, 74)));
  REQUIRE(named(few, "N_eff").value < 10);
  CHECK(named(few, "N_eff_Sku").why.find("N_eff = ") != std::string::npos);

  // A lay: waves of eight points across, ten times as long along it.
  const Field lay = Field::NullaryExpr(96, 96,
                                       [&, w = moving_average({96, 96}, {40, 6}, 75),
                                        v = moving_average({96, 96}, {40, 6}, 76)](Index i, Index j) {
                                         const double phase =
                                             2 * std::numbers::pi * static_cast<double>(j) / 8;
                                         return w(i, j) * std::cos(phase) + v(i, j) * std::sin(phase);
                                       });
  const Parameters of_lay = heights_of(sample_of(lay));
  CHECK(named(of_lay, "N_eff").why == "no standard error: the correlation is negative at many lags");
  CHECK(named(of_lay, "N_eff_Ssk").standard_error > 0);
}

// Hardly any lag is admitted, none of them twice, and N/S_k would not vary.
TEST_CASE("sizes of white noise have no error, and say why", "[size-error][contract]") {
  for (const Parameter& p : heights_of(sample_of(white_noise({64, 48}, 5)))) {
    if (!p.name.starts_with("N_eff") || p.name == "N_eff_mean") continue;
    CAPTURE(p.name, p.value, p.standard_error);
    CHECK(std::isnan(p.standard_error));
    CHECK(p.why == "no standard error: neighbours are hardly correlated");
  }
}

// ---- translation error ----

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

TEST_CASE("the correlation of translated heights gives back that of the field below",
          "[translation-error][exact]") {
  const CorrelationMap map(johnson_translation(-1.3, 6));
  const LagField rho = triangular_correlation({5, 5}), heights = rho.mapped([&](double r) { return map(r); });
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
