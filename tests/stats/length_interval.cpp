#include "stats/uncertainty/length_interval.hpp"

#include "fields.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/acf_length.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

LagField exponential(Index reach, double length) {
  return LagField(Field::NullaryExpr(reach + 1, 2 * reach + 1, [=](Index p, Index column) {
    return std::exp(-std::hypot(static_cast<double>(p), static_cast<double>(column - reach)) / length);
  }));
}

}  // namespace

// At the ends λ, ρ'(λ) ± 1.96 SE(λ) is the level, SE there between those of the lags beside λ, which at 6
// samples differ by 5 %; and as the field is large, the lags' weights change SE by less: 0.05 · 1.96 · 0.012
// = 0.0012 of the level.
TEST_CASE("the interval of a length ends where the correlation is 1.96 of its errors there from the level",
          "[length-interval][exact]") {
  const double length = 6, level = 0.3;
  const LagField rho = exponential(60, length);
  const Grid g = grid(512, 512);
  const double share = EffectiveSampleSize(rho, g).sum(1) / (512 * 512), b = share / (1 - share);
  const AcfError error(rho, g);
  auto strays = [&](double end) {
    return ((std::exp(-end / length) + b) / (1 + b) - level) / error.normalised(std::lround(end), 0);
  };
  const Interval i = LengthIntervals(rho, g, rho).along(0, level);
  CAPTURE(i.low, i.high);
  CHECK(std::abs(strays(i.low) - 1.959964) <= 0.1);
  CHECK(std::abs(strays(i.high) + 1.959964) <= 0.1);
}

TEST_CASE(
    "an interval is open where the correlation does not fall that far, and none where no side of it does",
    "[length-interval][contract]") {
  const LagField rho = exponential(12, 6);
  const LengthIntervals of(rho, grid(80, 80), rho), sharp(rho, grid(8000, 8000), rho);
  CHECK(of.along(0, 0.15).low > 0);
  CHECK(std::isinf(of.along(0, 0.15).high));
  CHECK(std::isinf(of.r_min(0.15).high));
  CHECK(of.along(0, 0.05).low > 0);
  CHECK(std::isinf(of.along(0, 0.05).high));
  CHECK_FALSE(sharp.along(0, 0.05).known());
}

// N/S_2 = 600. 300 fields: 95 % to within three of their errors √(0.05·0.95/300), 1.3 %.
TEST_CASE(
    "intervals of Sal, of the slowest decay and of the length at 1/e hold the truth in 95 % of the fields",
    "[length-interval][statistics][slow]") {
  const Shape window{4, 4};
  const Grid g = grid(64, 64);
  const LagField rho = triangular_correlation(window);
  const CentralLobe lobe = central_lobe(
      LagField(Field::NullaryExpr(6, 11, [&](Index p, Index column) { return rho(p, column - 5); })), g);
  const double at_e = first_crossing(rho, g, 0, 1 / std::numbers::e)->lag, sal = lobe.r_min->length;
  auto holds = [](const Interval& i, double truth) { return i.low <= truth && truth <= i.high; };
  double of_e = 0, of_sal = 0, of_slowest = 0;
  for (unsigned f = 0; f < 300; ++f) {
    const Field z = moving_average(g.shape, window, 4000 + f);
    const LagField acf = estimate_autocorrelation(z, g, {.max_lag = default_max_lag(g)});
    const LengthIntervals intervals(acf, g, std::nullopt);
    of_e += holds(intervals.along(0, 1 / std::numbers::e), at_e) / 300.0;
    of_sal += holds(intervals.r_min(0.2), sal) / 300.0;
    of_slowest += holds(intervals.r_max(0.2), lobe.r_max->length) / 300.0;
  }
  const double bound = 3 * std::sqrt(0.05 * 0.95 / 300);
  CHECK(std::abs(of_e - 0.95) <= bound);
  CHECK(std::abs(of_sal - 0.95) <= bound);
  CHECK(std::abs(of_slowest - 0.95) <= bound);
}
