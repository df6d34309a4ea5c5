// Errors of figures of an autocorrelation from the modes of its deviation.
#include "stats/uncertainty/acf_deviations.hpp"

#include <numbers>

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"

using namespace asperity;
using namespace asperity::test;

// Modes a and b of one lag: its error √(a² + b²), and that of e^ρ relative to it, without a bias of ln e^ρ.
TEST_CASE("a figure of the autocorrelation has the error of the deviations of its lags",
          "[acf-deviations][law]") {
  auto mode = [](double there, double beside) {
    Field values = Field::Zero(2, 3);
    values(1, 1) = there, values(0, 2) = beside;
    return LagField(values);
  };
  const AcfDeviations of({mode(0.03, 0), mode(0.04, 0.02)}, 5);
  Field rho = Field::Ones(2, 3);
  rho(1, 1) = 0.5;
  CHECK(of.errors()(1, 0) == Approx(0.05).epsilon(1e-14));
  CHECK(of.errors()(0, 1) == Approx(0.02).epsilon(1e-14));
  CHECK(of.correlation({{1, 0}, {0, 1}})(0, 1) == Approx(0.8).epsilon(1e-14));
  CHECK(of.quantile(0.025) == Approx(2.5706).epsilon(1e-4));
  const auto exponential = of.relative(
      LagField(rho), [](const LagField& r) { return std::optional(std::exp(r(1, 0))); }, 3);
  CHECK(exponential.error == Approx(0.05).epsilon(1e-12));
  CHECK(std::abs(exponential.bias) <= 1e-14);
  const Eigen::ArrayXd several = of.relative_errors(
      LagField(rho),
      [](const LagField& r) { return Eigen::Array2d(std::exp(r(1, 0)), std::exp(2 * r(0, 1))); }, 2);
  CHECK(several(0) == Approx(0.05).epsilon(1e-12));
  CHECK(several(1) == Approx(0.04).epsilon(1e-12));
  // Of a convex function the logarithm is biased: (3) of 10 u times the modes.
  const auto cosh = of.relative(
      LagField(rho), [](const LagField& r) { return std::optional(std::cosh(10 * (r(1, 0) - 0.5))); });
  const double u = 2.5;  // the most: Student's quantile is 2.57
  CHECK(cosh.bias ==
        Approx((std::log(std::cosh(0.3 * u)) + std::log(std::cosh(0.4 * u))) / (u * u)).epsilon(1e-12));
  // Beyond the lags on one side: the difference on the other.
  const auto rising = of.relative(LagField(rho), [](const LagField& r) {
    return std::optional(r(1, 0) > 0.5 ? AcfDeviations::beyond : std::exp(r(1, 0)));
  });
  CHECK(rising.error == Approx(0.05).epsilon(1e-12));
  CHECK(rising.rises);
  CHECK_FALSE(rising.falls);
  CHECK_FALSE(exponential.rises);
  CHECK_FALSE(exponential.falls);
  const AcfDeviations::Figure axis = [](const LagField& r) {
    return std::optional(std::numbers::pi / 2 + r(1, 0) - 0.5);
  };
  CHECK(of.of_axis(LagField(rho), axis) == Approx(0.05).epsilon(1e-12));
  const AcfDeviations::Figure wild = [](const LagField& r) { return std::optional(50 * r(1, 0)); };
  CHECK(std::isnan(of.of_axis(LagField(rho), wild)));
  const AcfDeviations::Figure rare = [](const LagField& r) {
    return r(1, 0) > 0.5 ? std::optional(r(1, 0)) : std::nullopt;
  };
  CHECK(std::isnan(of.relative(LagField(rho), rare).error));
}

// Of 1.6 degrees of freedom Student's quantile is 5.4. A length that cannot fall below a half has the slope of
// its first 2.5 deviations, ln 2/2.5; once it was ln 2/5.4, and errors on islands a half of the true ones.
TEST_CASE("of few degrees of freedom a figure that saturates keeps its slope", "[acf-deviations][law]") {
  Field values = Field::Zero(2, 3);
  values(1, 1) = 1;
  const AcfDeviations of({LagField(values)}, 1.6);
  const auto law = of.relative(LagField(Field::Ones(2, 3)),
                               [](const LagField& r) { return std::optional(std::max(0.5, r(1, 0))); });
  const double above = std::log(3.5), below = std::log(2);
  CHECK(law.error == Approx((above + below) / 2 / 2.5).epsilon(1e-12));
}

// The logarithm of exp(10 x + 100 x²), x the deviation of one lag, of error σ, is biased by 100 σ², and the
// interval lower by that than about x of ρ' = (ρ + b)/(1 + b).
TEST_CASE("the interval of a ratio allows for its bias and for the field's own mean",
          "[acf-deviations][law]") {
  const Grid g = grid(96, 96);
  const Field d = remove_form(moving_average(g.shape, {5, 4}, 22));
  const AcfEstimate estimate = AcfEstimate::of({.grid = g, .heights = d}, {.max_lag = {48, 48}});
  const LengthErrors errors(estimate, d, 0.2);
  const double here = estimate.rho(3, 0),
               sigma = LagWaves(d, g, {8, 8}, estimate.basis.extent()).of_ratio(estimate.rho).errors()(3, 0);
  const Estimate ratio = errors.ratio(
      1,
      [here](const LagField& rho) {
        const double x = rho(3, 0) - here;
        return std::optional(std::exp(10 * x + 100 * x * x));
      },
      0, 100);
  REQUIRE(ratio.interval);
  const double shift = -0.5 * std::log(ratio.interval->low * ratio.interval->high),
               x = estimate.size.freed(estimate.rho)(3, 0) - here;
  CHECK(x > 0);
  CHECK(shift == Approx(100 * sigma * sigma - 10 * x - 100 * x * x).epsilon(1e-6));
}

// Where one side of a mode leads beyond the lags, no end of the interval can be stated on that side.
TEST_CASE("the interval of a ratio is open where a length may lie beyond the lags",
          "[acf-deviations][contract]") {
  const Grid g = grid(96, 96);
  const Field d = remove_form(moving_average(g.shape, {5, 4}, 22));
  const AcfEstimate estimate = AcfEstimate::of({.grid = g, .heights = d}, {.max_lag = {48, 48}});
  const LengthErrors errors(estimate, d, 0.2);
  const double freed = estimate.size.freed(estimate.rho)(3, 0);
  auto ratio = [&](double below, double above) {
    return errors.ratio(
        1,
        [=](const LagField& rho) {
          const double x = rho(3, 0) - freed, tiny = 1e-9;
          return std::optional(x < -tiny ? below : x > tiny ? above : 1);
        },
        0.1, 100);
  };
  const Estimate low = ratio(0, 1.1), high = ratio(0.9, AcfDeviations::beyond), closed = ratio(0.9, 1.1);
  CHECK(low.interval->low == 0.1);
  CHECK(low.interval->high < 100);
  CHECK(high.interval->low > 0.1);
  CHECK(high.interval->high == 100);
  CHECK(closed.interval->low > 0.1);
  CHECK(closed.interval->high < 100);
}
