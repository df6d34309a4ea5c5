#include "stats/length_interval.hpp"

#include "fields.hpp"
#include "stats/acf.hpp"
#include "stats/acf_length.hpp"
#include "stats/acf_lobe.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

LagField exponential(Index reach, double length) {
  return LagField(Field::NullaryExpr(reach + 1, 2 * reach + 1, [=](Index p, Index column) {
    return std::exp(-std::hypot(static_cast<double>(p), static_cast<double>(column - reach)) / length);
  }));
}

}  // namespace

// ln ρ' is not quite straight between lags: an error below h²/(8λ), 0.02 of 6 samples.
TEST_CASE("the interval of a length ends where the correlation falls to the level and 1.96 errors of it",
          "[length-interval][exact]") {
  const double length = 6, level = 0.3;
  const LagField rho = exponential(60, length);
  const Grid g = grid(512, 512);
  const double share = EffectiveSize(rho, g).sum(1) / (512 * 512), b = share / (1 - share);
  const auto p = std::lround(-length * std::log(level));
  const double strays = 1.959964 * AcfError(rho, g).normalised(p, 0);
  auto where = [&](double t) { return -length * std::log(t * (1 + b) - b); };
  const Interval interval = LengthIntervals(rho, g, rho).along(0, level);
  CHECK(std::abs(interval.low - where(level + strays)) <= 0.02);
  CHECK(std::abs(interval.high - where(level - strays)) <= 0.02);
}

TEST_CASE("an interval has no end where the correlation does not fall that far",
          "[length-interval][contract]") {
  const LagField rho = exponential(12, 6);
  const LengthIntervals of(rho, grid(80, 80), rho);
  CHECK(of.along(0, 0.15).low > 0);
  CHECK(std::isnan(of.along(0, 0.15).high));
  CHECK(std::isnan(of.fastest(0.15).high));
  CHECK(std::isnan(of.along(0, 0.05).low));
}

// N/S_2 = 600. 300 fields: 95 % to within three of their errors √(0.05·0.95/300), 1.3 %.
TEST_CASE("intervals of Sal and of the length at 1/e hold the truth in 95 % of the fields",
          "[length-interval][statistics]") {
  const Shape window{4, 4};
  const Grid g = grid(64, 64);
  const LagField rho = triangular_correlation(window);
  const double at_e = first_crossing(rho, g, 0, 1 / std::numbers::e)->lag,
               sal = central_lobe(LagField(Field::NullaryExpr(
                                      6, 11, [&](Index p, Index column) { return rho(p, column - 5); })),
                                  g)
                         .fastest->length;
  auto holds = [](const Interval& i, double truth) { return i.low <= truth && !(i.high < truth); };
  double of_e = 0, of_sal = 0;
  for (unsigned f = 0; f < 300; ++f) {
    const Field z = moving_average(g.shape, window, 4000 + f);
    const LagField acf = estimate_autocorrelation(z, g, {.max_lag = default_max_lag(g)});
    const LengthIntervals intervals(acf, g, std::nullopt);
    of_e += holds(intervals.along(0, 1 / std::numbers::e), at_e) / 300.0;
    of_sal += holds(intervals.fastest(0.2), sal) / 300.0;
  }
  const double bound = 3 * std::sqrt(0.05 * 0.95 / 300);
  CHECK(std::abs(of_e - 0.95) <= bound);
  CHECK(std::abs(of_sal - 0.95) <= bound);
}
