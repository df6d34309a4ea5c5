#include "stats/uncertainty/moment_interval.hpp"

#include <gsl/gsl_cdf.h>

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

bool holds(const Interval& i, double truth) { return i.low <= truth && truth <= i.high; }

// Shares of fields whose 95 % intervals, from the correlation estimated from each, hold the truth.
struct Coverage {
  double mean = 0, sa = 0, sq = 0, ssk = 0, sku = 0;

  Coverage(Shape shape, Shape window, int fields) {
    const Grid g = grid(shape.nx, shape.ny);
    for (int f = 0; f < fields; ++f) {
      const Field z = moving_average(shape, window, static_cast<unsigned>(f));
      const LagField acf = estimate_autocorrelation(z, g, {.max_lag = default_max_lag(g)});
      const MomentIntervals i = confidence_intervals(moments(z), EffectiveSampleSize::of_estimate(acf, g));
      mean += holds(i.mean, 0);
      sa += holds(i.sa, std::sqrt(2 / std::numbers::pi));
      sq += holds(i.sq, 1);
      ssk += holds(i.ssk, 0);
      sku += holds(i.sku, 3);
    }
    for (double* share : {&mean, &sa, &sq, &ssk, &sku}) *share /= fields;
  }
};

void check_coverage(const Coverage& c) {
  CAPTURE(c.mean, c.sa, c.sq, c.ssk, c.sku);
  for (double share : {c.mean, c.sa, c.sq, c.ssk, c.sku}) {
    CHECK(share >= 0.93);
    CHECK(share <= 0.97);
  }
}

}  // namespace

// All S_k are 1.
TEST_CASE("independent heights have Fisher's intervals", "[moment-interval][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(5, 8));
  const Moments m{.mean = 7, .sa = 1.5, .sq = 2, .ssk = 0.3, .sku = 2.5};
  const MomentIntervals i = confidence_intervals(m, size);
  const double left = std::sqrt(39.0 / 40), t = gsl_cdf_tdist_Qinv(0.025, 39);
  CHECK(relative_error(i.mean.high - 7, t * 2 / std::sqrt(39)) <= 1e-12);
  CHECK(relative_error(7 - i.mean.low, t * 2 / std::sqrt(39)) <= 1e-12);
  CHECK(relative_error(i.sq.low, 2 / left * std::sqrt(40 / gsl_cdf_chisq_Pinv(0.975, 40))) <= 1e-12);
  CHECK(relative_error(i.sq.high, 2 / left * std::sqrt(40 / gsl_cdf_chisq_Pinv(0.025, 40))) <= 1e-12);
  CHECK(relative_error(i.ssk.high - i.ssk.low, 2 * 1.959964 * std::sqrt(6 * 38 / (41.0 * 43))) <= 1e-6);
  CHECK(relative_error(i.sku.high + i.sku.low, 2 * (2.5 + 6 / 40.0)) <= 1e-12);
  CHECK(relative_error(i.sku.high - i.sku.low,
                       2 * 1.959964 * std::sqrt(24 * 40.0 * 38 * 37 / (41.0 * 41 * 43 * 45))) <= 1e-6);
}

// 1500 fields of 4 × 4 correlation lengths know their deviation to 1/√3000 = 1.8 %, four of which are
// allowed, and 4 % for the third order. To first order, and as of independent heights, the variance would be
// 6/ν_3 and 0.92 of that: the deviation too large by 22 and 17 %.
TEST_CASE("the skewness of few patches varies as the second order says, not the first",
          "[moment-interval][statistics]") {
  const EffectiveSampleSize size(triangular_correlation({16, 16}), grid(64, 64));
  Spread ssk;
  for (unsigned seed = 0; seed < 1500; ++seed) ssk.add(moments(moving_average({64, 64}, {16, 16}, seed)).ssk);
  const Interval i = confidence_intervals({.mean = 0, .sa = 0.8, .sq = 1, .ssk = 0, .sku = 3}, size).ssk;
  CHECK(std::abs(i.high / 1.959964 / ssk.deviation() - 1) <= 4 * 0.018 + 0.04);
}

// Wilson and Hilferty's cube root against the chi-squared's own quantiles: 0.05 ν^{-3/2} of them, half of it
// of a root.
TEST_CASE("at ten thousand independent heights the interval of Sq goes on as it was",
          "[moment-interval][exact]") {
  const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(100, 100));
  const Interval sq = confidence_intervals({.sa = 0.8, .sq = 1, .sku = 3}, size).sq;
  const double left = std::sqrt(1 - 1e-4), bound = 0.025 * std::pow(1e4, -1.5);
  CHECK(relative_error(sq.low, std::sqrt(1e4 / gsl_cdf_chisq_Pinv(0.975, 1e4)) / left) <= bound);
  CHECK(relative_error(sq.high, std::sqrt(1e4 / gsl_cdf_chisq_Pinv(0.025, 1e4)) / left) <= bound);
}

// Of 4e6 to 4e8 heights the intervals are 1.96 standard errors to first order; the second is their square.
TEST_CASE("of millions of independent heights the intervals are 1.96 standard errors",
          "[moment-interval][law]") {
  for (Index n : {2000, 6000, 20000}) {
    const EffectiveSampleSize size(triangular_correlation({1, 1}), grid(n, n));
    const Moments m{.mean = 0, .sa = 0.7978845608, .sq = 1, .ssk = 0, .sku = 3};
    const MomentErrors error = standard_errors(m, size);
    const MomentIntervals i = confidence_intervals(m, size);
    auto halves = [&](const Interval& interval, double value, double of) {
      CHECK(std::abs((interval.high - value) / (1.959964 * of) - 1) <= 6 * of / value + 1e-6);
      CHECK(std::abs((value - interval.low) / (1.959964 * of) - 1) <= 6 * of / value + 1e-6);
    };
    CAPTURE(n);
    halves(i.sq, 1, error.sq);
    halves(i.sa, m.sa, error.sa);
    halves(i.sku, 3, error.sku);
    CHECK(relative_error(i.mean.high, 1.959964 * error.mean) <= 1e-5);
    CHECK(relative_error(i.ssk.high, 1.959964 * error.ssk) <= 1e-5);
  }
}

TEST_CASE("an interval of half the confidence is narrower, and about the same scale",
          "[moment-interval][law]") {
  const Field z = moving_average({40, 40}, {3, 3}, 5);
  const EffectiveSampleSize size(triangular_correlation({3, 3}), grid(40, 40));
  const MomentIntervals wide = confidence_intervals(moments(z), size),
                        narrow = confidence_intervals(moments(z), size, 0.5);
  for (auto part : {&MomentIntervals::mean, &MomentIntervals::sa, &MomentIntervals::sq, &MomentIntervals::ssk,
                    &MomentIntervals::sku}) {
    CHECK((wide.*part).low < (narrow.*part).low);
    CHECK((narrow.*part).high < (wide.*part).high);
  }
}

// 2000 fields each, of N/S_2 = 1100 and 150: the counts' own error is 0.5 %.
TEST_CASE("95 % intervals from the field's own correlation cover 93 to 97 % where it is short",
          "[moment-interval][statistics]") {
  check_coverage({{64, 64}, {3, 3}, 2000});
}

TEST_CASE("95 % intervals from the field's own correlation cover 93 to 97 % where it is long",
          "[moment-interval][statistics][slow]") {
  check_coverage({{64, 64}, {8, 8}, 2000});
}

TEST_CASE("a confidence that is none is refused, and so few patches have no interval",
          "[moment-interval][contract]") {
  const EffectiveSampleSize few(triangular_correlation({9, 9}), grid(3, 3));
  const Moments m{.mean = 0, .sa = 0.8, .sq = 1, .ssk = 0, .sku = 3};
  for (double level : {0.0, 1.0, -2.0, std::nan("")})
    CHECK_THROWS_AS(confidence_intervals(m, few, level), ParameterError);
  CHECK(std::isnan(confidence_intervals(m, few).sku.low));
}
