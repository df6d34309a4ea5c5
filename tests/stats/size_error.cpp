#include "stats/uncertainty/size_error.hpp"

#include <vector>

#include <gsl/gsl_cdf.h>

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Sample sample_of(const Field& z, bool periodic = false) {
  return Sample({.grid = grid(z.rows(), z.cols(), periodic), .heights = remove_form(z)});
}

Parameter named(const Parameters& all, const std::string& name) {
  for (const Parameter& p : all)
    if (p.name == name) return p;
  throw std::runtime_error(name);
}

Parameters heights_of(const Sample& sample) { return measure(sample, Group::height, {}); }

}  // namespace

// 200 fields of N/S_2 = 410 and their exponentials: a spread is known to 1/√400 = 5 %, of skewed sums to 10 %; the
// rms error, of K = 7 squares each, to 4 %. Waves lose up to a tenth, and what (1) adds for it is empirical.
TEST_CASE("errors of effective sample sizes are those of simulated fields, Gaussian or not",
          "[size-error][statistics][slow]") {
  const Shape window{6, 5};
  for (const bool lognormal : {false, true}) {
    Spread found[3];
    double squares[3] = {}, covered[3] = {}, mean[3] = {};
    std::vector<std::array<Interval, 3>> intervals;
    for (unsigned f = 0; f < 200; ++f) {
      Field z = moving_average({96, 80}, window, 4000 + f);
      if (lognormal) z = (0.4 * z).exp();
      const Sample sample = sample_of(z);
      const auto errors = sample.size_errors();
      REQUIRE(errors);
      auto& of = intervals.emplace_back();
      for (int k = 2; k <= 4; ++k) {
        const auto i = static_cast<std::size_t>(k - 2);
        found[i].add(sample.size().effective(k));
        mean[i] += sample.size().effective(k) / 200;
        squares[i] += std::pow((*errors)(k), 2) / 200;
        of[i] = errors->interval(k);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (const auto& of : intervals) covered[i] += (of[i].low <= mean[i] && mean[i] <= of[i].high) / 200.0;
      CAPTURE(lognormal, i + 2, covered[i], mean[i]);
      CHECK(std::sqrt(squares[i]) == Approx(found[i].deviation()).epsilon(0.25));
      CHECK(covered[i] >= 0.95 - 4 * std::sqrt(0.05 * 0.95 / 200));
    }
  }
}

// S_k does not know the unit, and a wave is a sum of products: a power of two is exact.
TEST_CASE("errors of effective sample sizes do not depend on the unit of the heights", "[size-error][law]") {
  const Field z = moving_average({64, 48}, {4, 3}, 71);
  const auto one = sample_of(z).size_errors(), other = sample_of(0x1p-20 * z).size_errors();
  for (int k = 2; k <= 4; ++k) CHECK((*one)(k) == (*other)(k));
}

TEST_CASE("the interval of an effective sample size is Student's about the value", "[size-error][exact]") {
  const Sample sample = sample_of(moving_average({80, 80}, {4, 4}, 72));
  const auto errors = sample.size_errors();
  const LongWaves waves(sample.grid(), sample.extent(), {.least = 5});
  const double degrees = waves.degrees(static_cast<Index>(waves.all().size()), 40);
  const double value = sample.size().effective(2), half = gsl_cdf_tdist_Pinv(0.975, degrees) * (*errors)(2);
  CHECK(errors->interval(2).high == Approx(value + half).epsilon(1e-12));
  CHECK(errors->interval(2).low == Approx(value - half).epsilon(1e-12));
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
