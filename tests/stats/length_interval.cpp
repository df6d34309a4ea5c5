#include "stats/uncertainty/length_interval.hpp"

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

LagField exponential(Index reach, double length) {
  return LagField(Field::NullaryExpr(reach + 1, 2 * reach + 1, [=](Index p, Index column) {
    return std::exp(-std::hypot(static_cast<double>(p), static_cast<double>(column - reach)) / length);
  }));
}

// The error 0.02 at every lag, as a mode, and t of five degrees.
LengthIntervals intervals_of(const LagField& rho, double error, double bias = 0) {
  const auto& lags = rho.half_plane();
  const AcfDeviations deviations({LagField(Field::Constant(lags.rows(), lags.cols(), error))}, 5);
  return {rho, grid(512, 512), deviations, LagField((lags + bias) / (1 + bias))};
}

}  // namespace

// exp(-λ/6) is interpolated exactly, with the band between two lags to 3e-4.
TEST_CASE("the interval of a length ends where the correlation is t of its errors from the level",
          "[length-interval][exact]") {
  const double length = 6, level = 0.3, error = 0.02, b = 0.01, t = 2.570582;
  const Interval i = intervals_of(exponential(60, length), error, b).along(0, level);
  auto at = [&](double end) { return (std::exp(-end / length) + b) / (1 + b); };
  CHECK(at(i.low) - t * error == Approx(level).margin(1e-3));
  CHECK(at(i.high) + t * error == Approx(level).margin(1e-3));
}

TEST_CASE(
    "an interval is open where the correlation does not fall that far, and none where no side of it does",
    "[length-interval][contract]") {
  const LagField rho = exponential(12, 6);
  const LengthIntervals of = intervals_of(rho, 0.05), sharp = intervals_of(rho, 1e-4);
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
    const AcfEstimate estimate(acf, {acf, true, g});
    const LengthErrors errors(estimate, remove_form(z), 0.2);
    const CentralLobe found = central_lobe(estimate.rho, g);
    const auto crossing = first_crossing(estimate.rho, g, 0, 1 / std::numbers::e);
    of_e += holds(*errors.along(0, 1 / std::numbers::e, crossing->lag).interval, at_e) / 300.0;
    of_sal += holds(*errors.r_min(0.2, *found.r_min).interval, sal) / 300.0;
    of_slowest += holds(*errors.r_max(0.2, *found.r_max).interval, lobe.r_max->length) / 300.0;
  }
  const double bound = 3 * std::sqrt(0.05 * 0.95 / 300);
  for (const double of : {of_e, of_sal, of_slowest}) {
    CHECK(of >= 0.95 - bound);
    CHECK(of < 1);
  }
}

// Of 100 round fields of N_eff near 60: 95 % to within three errors √(0.05·0.95/100), 6.5 %. Where each direction had
// an error of its own, the least known one decided, and 82 held it.
TEST_CASE("the upper end of Sal holds the truth of round fields of few correlation lengths",
          "[length-interval][statistics][slow]") {
  const Grid g = grid(64, 64), large = grid(256, 256, true);
  const double length = 8, sal = length * std::sqrt(std::log(5.0));  // exp(-r²/length²) = 0.2
  double held = 0;
  for (unsigned f = 0; f < 100; ++f) {
    const Field z = remove_form(gaussian_acf_field(large.shape, length, 700 + f).topLeftCorner(64, 64));
    const AcfEstimate estimate = AcfEstimate::of({.grid = g, .heights = z}, {.max_lag = {32, 32}});
    const auto found = central_lobe(estimate.rho, g).r_min;
    REQUIRE(found);
    held += sal <= LengthErrors(estimate, z, 0.2).r_min(0.2, *found).interval->high;
  }
  CHECK(held >= 95 - 6.5);
}
