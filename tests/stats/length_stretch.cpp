// The factors of lengths, stats/uncertainty/length_stretch.hpp.
#include "stats/uncertainty/length_stretch.hpp"

#include <numbers>

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/length_interval.hpp"

using namespace asperity;
using namespace asperity::test;

using Names = std::vector<std::string>;

namespace {

LagField gaussian_correlation(double lx, double ly, Shape max_lag) {
  return LagField::of(max_lag, [=](Index p, Index q) {
    return std::exp(-std::pow(static_cast<double>(p) / lx, 2) - std::pow(static_cast<double>(q) / ly, 2));
  });
}

// m(i, j) = f(lag from point j to point i), over the points of a periodic field.
Eigen::MatrixXd circulant(Shape shape, const LagField& f) {
  auto folded = [](Index lag, Index n) { return lag > n / 2 ? lag - n : lag < -(n / 2) ? lag + n : lag; };
  return Eigen::MatrixXd::NullaryExpr(shape.cells(), shape.cells(), [&](Index a, Index b) {
    return f(folded(a / shape.ny - b / shape.ny, shape.nx), folded(a % shape.ny - b % shape.ny, shape.ny));
  });
}

Eigen::ArrayXd estimates(const std::vector<LagField>& weights, const LagField& acf) {
  return Eigen::ArrayXd::NullaryExpr(static_cast<Index>(weights.size()), [&](Index i) {
    return LengthStretch::estimate(weights[static_cast<std::size_t>(i)], acf);
  });
}

}  // namespace

// T = zᵀ W z/N with W(a,b) = w(a-b) has the variance 2 tr (WC)²/N². Round-off of 117 terms twice.
TEST_CASE("the variance of a stretch is that of its quadratic form", "[stretch][exact]") {
  const Grid g = grid(13, 9, true);
  const LagField rho = gaussian_correlation(1.7, 1.2, {6, 4});
  const LengthStretch stretch(rho, g, {3, 2});
  REQUIRE(stretch.names() == Names{"length_x", "length_y", "length", "length_x/length_y"});
  const Eigen::MatrixXd c = circulant(g.shape, rho);
  const Eigen::ArrayXd variances = stretch.variances(g);
  for (Index i = 0; const LagField& w : stretch.weights(g)) {
    const Eigen::MatrixXd form = circulant(g.shape, w) * c / static_cast<double>(g.shape.cells());
    CHECK(std::abs(variances(i++) - 2 * (form * form).trace()) <= 1e-12 * variances.maxCoeff());
  }
}

// The slopes of a Gaussian are exact; what is left is of second order, s² by a factor that W decides.
TEST_CASE("a stretch of either axis, of both and of their ratio is found where it is", "[stretch][order]") {
  const Grid g = grid(128, 128);
  const double lx = 4, ly = 5;
  const std::vector<LagField> w =
      LengthStretch(gaussian_correlation(lx, ly, {24, 24}), g, {24, 24}).weights(g);
  auto found = [&](double x, double y) -> Eigen::ArrayXd {
    return estimates(w, gaussian_correlation(lx * std::exp(x), ly * std::exp(y), {24, 24}));
  };
  CHECK(found(0, 0).abs().maxCoeff() <= 1e-12);
  const double s = 0.002, error = 5 * s * s;
  for (const auto& [x, y] : {std::pair{s, 0.0}, {0.0, s}, {s, s}, {s, -s}}) {
    const Eigen::Array4d expected(x, y, (x + y) / 2, x - y);
    CAPTURE(x, y, found(x, y).transpose());
    CHECK((found(x, y) - expected).abs().maxCoeff() <= error);
  }
}

// cos(2πp/12) passes zero at p = 3, where its logarithm once gave a length within 1e-4. A wave of 12 samples
// that decays over 8.7 is broad by 12/(2π 8.7) = 22 % of its number: of some 100 such waves in the field the
// mean is right to 2 %.
TEST_CASE("the length of a lay that passes zero has the error of its waves", "[stretch][statistics]") {
  const LagField rho = LagField::of({60, 60}, [](Index p, Index q) {
    const auto x = static_cast<double>(p), y = static_cast<double>(q);
    return std::exp(-std::hypot(x, y) / 8.7) * std::cos(2 * std::numbers::pi * x / 12);
  });
  const Grid g = grid(128, 128);
  const double error = std::sqrt(LengthStretch(rho, g, {32, 32}).variances(g)(0));
  CHECK((error >= 0.01 && error <= 0.04));
}

// ρ(1) = exp(-16) tells no length of 64² points.
TEST_CASE("an axis without a length has no stretch", "[stretch][contract]") {
  auto names = [](const LagField& rho) { return LengthStretch(rho, grid(64, 64), {8, 8}).names(); };
  CHECK(names(triangular_correlation({1, 1})).empty());
  CHECK(names(triangular_correlation({1, 4})) == Names{"length_y"});
  CHECK(names(triangular_correlation({4, 1})) == Names{"length_x"});
  CHECK(names(gaussian_correlation(0.25, 4, {8, 8})) == Names{"length_y"});
  CHECK(names(gaussian_correlation(4, 4, {8, 8})).size() == 4);
}

// 200 fields: the spread is right within 4/√400 = 20 %.
TEST_CASE("stretches of fields as prescribed spread as their variance says", "[stretch][statistics]") {
  for (const bool periodic : {true, false}) {
    const Grid g = grid(64, 64, periodic);
    const double length = 5;
    const LagField rho = gaussian_correlation(length, length, {32, 32});
    const LengthStretch stretch(rho, g, {16, 16});
    const std::vector<LagField> w = stretch.weights(g);
    const Eigen::ArrayXd errors = stretch.variances(g).sqrt();
    std::array<Spread, 4> of;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Field z = periodic ? gaussian_acf_field({64, 64}, length, seed)
                               : Field(gaussian_acf_field({128, 96}, length, seed).topLeftCorner(64, 64));
      const LagField acf = estimate_autocorrelation(z, g, {.max_lag = {16, 16}});
      const Eigen::ArrayXd t = estimates(w, acf) / acf(0, 0);
      for (std::size_t i = 0; i < 4; ++i) of[i].add(t(static_cast<Index>(i)));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = errors(static_cast<Index>(i));
      CAPTURE(periodic, i, error, of[i].deviation());
      CHECK(std::abs(of[i].deviation() / error - 1) <= 0.2);
    }
  }
}

// ---- length interval ----

namespace {

LagField exponential_lags(Index reach, double length) {
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
  const Interval i = intervals_of(exponential_lags(60, length), error, b).along(0, level);
  auto at = [&](double end) { return (std::exp(-end / length) + b) / (1 + b); };
  CHECK(at(i.low) - t * error == Approx(level).margin(1e-3));
  CHECK(at(i.high) + t * error == Approx(level).margin(1e-3));
}

TEST_CASE(
    "an interval is open where the correlation does not fall that far, and none where no side of it does",
    "[length-interval][contract]") {
  const LagField rho = exponential_lags(12, 6);
  const LengthIntervals of = intervals_of(rho, 0.05), sharp = intervals_of(rho, 1e-4);
  CHECK(of.along(0, 0.15).low > 0);
  CHECK(std::isinf(of.along(0, 0.15).high));
  CHECK(std::isinf(of.r_min(0.15).high));
  CHECK(of.along(0, 0.05).low > 0);
  CHECK(std::isinf(of.along(0, 0.05).high));
  CHECK_FALSE(sharp.along(0, 0.05).known());
}

// ---- acf deviations ----

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
