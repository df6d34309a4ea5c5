// The factors of lengths, stats/uncertainty/length_stretch.hpp.
#include "stats/uncertainty/length_stretch.hpp"

#include <numbers>

#include "fields.hpp"
#include "stats/filter/form.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/effective_size.hpp"

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
  CHECK(of.quantile(0.025) == Approx(2.5706).epsilon(1e-4));
  const double inf = std::numeric_limits<double>::infinity();
  const FigureDeviations figures = of.of(
      LagField(rho),
      [&](const LagField& r) {
        const double x = r(1, 0) - 0.5;
        Eigen::ArrayXd out(6);
        // An exponential; a convex figure; one beyond the lags on one side; an axis; any axis; one found on
        // one side alone, and not of ρ.
        out << std::exp(x), std::cosh(10 * x), x > 1e-9 ? inf : std::exp(x), std::numbers::pi / 2 + x, 12.5 * x,
            x > 1e-9 ? 1 + x : NAN;
        return out;
      },
      3);
  const auto exponential = figures.relative(0), cosh = figures.relative(1), rising = figures.relative(2);
  CHECK(exponential.error == Approx(0.05).epsilon(1e-12));
  CHECK(std::abs(exponential.bias) <= 1e-14);
  CHECK_FALSE((exponential.rises || exponential.falls));
  // (3) is at most the half of the second derivative of ln cosh 10x times the variance.
  CHECK(cosh.bias > 0);
  CHECK(cosh.bias <= 50 * 0.05 * 0.05);
  CHECK(rising.error == Approx(0.05).epsilon(1e-12));
  CHECK((rising.rises && !rising.falls));
  CHECK(figures.of_axis(3) == Approx(0.05).epsilon(1e-12));
  CHECK(std::isnan(figures.of_axis(4)));
  CHECK(std::isnan(figures.relative(5).error));
  const Eigen::ArrayXd several = of.relative_errors(
      LagField(rho),
      [](const LagField& r) { return Eigen::Array2d(std::exp(r(1, 0)), std::exp(2 * r(0, 1))); }, 2);
  CHECK(several(0) == Approx(0.05).epsilon(1e-12));
  CHECK(several(1) == Approx(0.04).epsilon(1e-12));
}

// A period cut elsewhere turns sines into cosines. Errors of figures with a kink changed by a third so.
TEST_CASE("modes turned among themselves give a figure the same error", "[acf-deviations][law]") {
  std::vector<LagField> modes, turned;
  for (unsigned k = 0; k < 2; ++k) modes.emplace_back(0.1 * random_field({4, 7}, 60 + k));
  const double c = std::cos(0.7), s = std::sin(0.7);
  turned.emplace_back(c * modes[0].half_plane() + s * modes[1].half_plane());
  turned.emplace_back(c * modes[1].half_plane() - s * modes[0].half_plane());
  const auto figures = [](const LagField& rho) {
    return Eigen::ArrayXd::Constant(1, std::min(rho(1, 0), rho(0, 1))).eval();
  };
  const LagField rho(Field::Ones(4, 7));
  const auto law = AcfDeviations(modes, 8).of(rho, figures).relative(0),
             other = AcfDeviations(turned, 8).of(rho, figures).relative(0);
  CHECK(relative_error(other.error, law.error) <= 1e-12);
  CHECK(relative_error(other.bias, law.bias) <= 1e-10);
}

// Two figures of errors 0.03 and 0.04, independent, and 0.09 and 0.04 from zero: T² = 9 + 1. Beside them a
// variance of 0.0009 halves the first. Nothing is known of two that vary as one.
TEST_CASE("the chance of a pair of figures is that of F with 2 and nu degrees", "[acf-deviations][exact]") {
  auto mode = [](double there, double beside) {
    Field values = Field::Zero(2, 3);
    values(1, 1) = there, values(0, 2) = beside;
    return LagField(values);
  };
  Field rho = Field::Zero(2, 3);
  rho(1, 1) = 0.09, rho(0, 2) = 0.04;
  const auto pair = [](const LagField& r) { return Eigen::ArrayXd(Eigen::Array2d(r(1, 0), r(0, 1))); };
  const double nu = 5;
  auto chance = [&](double squared) { return std::pow(1 + squared / nu, -nu / 2); };
  const FigureDeviations of = AcfDeviations({mode(0.03, 0), mode(0, 0.04)}, nu).of(LagField(rho), pair);
  CHECK(of.chance_of_pair(0, 0) == Approx(chance(10)).epsilon(1e-12));
  CHECK(of.chance_of_pair(0, 0.0009) == Approx(chance(4.5 + 0.0016 / 0.0025)).epsilon(1e-12));
  CHECK(AcfDeviations({mode(0.03, 0.04)}, nu).of(LagField(rho), pair).chance_of_pair(0, 0) == 1);
}

// Of 1.6 degrees of freedom Student's quantile is 5.4. A length that cannot fall below a half has the slope of
// its first 2.5 deviations, ln 2/2.5; once it was ln 2/5.4, and errors on islands a half of the true ones.
TEST_CASE("of few degrees of freedom a figure that saturates keeps its slope", "[acf-deviations][law]") {
  Field values = Field::Zero(2, 3);
  values(1, 1) = 1;
  const AcfDeviations of({LagField(values)}, 1.6);
  const auto law = of.of(LagField(Field::Ones(2, 3)), [](const LagField& r) {
                       return Eigen::ArrayXd::Constant(1, std::max(0.5, r(1, 0))).eval();
                     }).relative(0);
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
  const Estimate ratio = errors.figure(
      1,
      [here](const LagField& rho) {
        const double x = rho(3, 0) - here;
        return std::exp(10 * x + 100 * x * x);
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
    return errors.figure(
        1,
        [=](const LagField& rho) {
          const double x = rho(3, 0) - freed, tiny = 1e-9;
          return x < -tiny ? below : x > tiny ? above : 1.0;
        },
        0.1, 100);
  };
  const Estimate low = ratio(0, 1.1), high = ratio(0.9, std::numeric_limits<double>::infinity()),
                 closed = ratio(0.9, 1.1);
  CHECK(low.interval->low == 0.1);
  CHECK(low.interval->high < 100);
  CHECK(high.interval->low > 0.1);
  CHECK(high.interval->high == 100);
  CHECK(closed.interval->low > 0.1);
  CHECK(closed.interval->high < 100);
}
