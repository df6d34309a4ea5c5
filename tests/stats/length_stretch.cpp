// The factors of lengths, stats/uncertainty/length_stretch.hpp.
#include "stats/uncertainty/length_stretch.hpp"

#include "fields.hpp"
#include "stats/spatial/acf.hpp"
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

}  // namespace

// T = zᵀ W z/N with W(a,b) = w(a-b) has the cumulants 2 tr (WC)²/N² and 8 tr (WC)³/N³, and with Sq² the
// covariance 2 tr (WC C)/N². Round-off of 117 terms thrice.
TEST_CASE("the cumulants of a stretch are those of its quadratic form", "[stretch][exact]") {
  const Grid g = grid(13, 9, true);
  const LagField rho = gaussian_correlation(1.7, 1.2, {6, 4});
  const LengthStretch stretch(rho, g, {3, 2});
  REQUIRE(stretch.names() == Names{"length_x", "length_y", "length", "length_x/length_y"});
  const LengthStretch::Law law = stretch.law(g, 0);
  const auto n = static_cast<double>(g.shape.cells());
  const Eigen::MatrixXd c = circulant(g.shape, rho);
  std::vector<Eigen::MatrixXd> forms;
  for (const LagField& w : law.weights) forms.push_back(circulant(g.shape, w) * c / n);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto a = static_cast<Index>(i);
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(std::abs(law.covariance(a, static_cast<Index>(j)) - 2 * (forms[i] * forms[j]).trace()) <=
            1e-12 * law.covariance.diagonal().maxCoeff());
    CHECK(law.third(a) == Approx(8 * (forms[i] * forms[i] * forms[i]).trace()).margin(1e-12).epsilon(0));
    CHECK(law.with_variance(a) == Approx(2 * (forms[i] * c).trace() / n).margin(1e-12).epsilon(0));
  }
}

// The slopes of a Gaussian are exact; what is left is of second order, s² by a factor that W decides.
TEST_CASE("a stretch of either axis, of both and of their ratio is found where it is", "[stretch][order]") {
  const Grid g = grid(128, 128);
  const double lx = 4, ly = 5;
  const LengthStretch::Law law = LengthStretch(gaussian_correlation(lx, ly, {24, 24}), g, {24, 24}).law(g, 0);
  auto found = [&](double x, double y) -> Eigen::ArrayXd {
    return law(gaussian_correlation(lx * std::exp(x), ly * std::exp(y), {24, 24}));
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
  const double error = std::sqrt(LengthStretch(rho, g, {32, 32}).law(g, 0).covariance(0, 0));
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

// 200 fields: the mean is right within four of its errors, the spread within 4/√400 = 20 %.
TEST_CASE("stretches of fields as prescribed are zero on average, and spread as their law says",
          "[stretch][statistics]") {
  for (const bool periodic : {true, false}) {
    const Grid g = grid(64, 64, periodic);
    const double length = 5;
    const LagField rho = gaussian_correlation(length, length, {32, 32});
    const EffectiveSampleSize size(rho, g);
    const LengthStretch stretch(rho, g, {16, 16});
    const LengthStretch::Law law = stretch.law(g, size.mean_power(1));
    std::array<Spread, 4> of;
    for (unsigned seed = 0; seed < 200; ++seed) {
      const Field z = periodic ? gaussian_acf_field({64, 64}, length, seed)
                               : Field(gaussian_acf_field({128, 96}, length, seed).topLeftCorner(64, 64));
      const LagField acf = estimate_autocorrelation(z, g, {.max_lag = {16, 16}});
      const Eigen::ArrayXd t = law(acf) / acf(0, 0) * (1 - size.mean_power(1)) + law.with_variance;
      for (std::size_t i = 0; i < 4; ++i) of[i].add(t(static_cast<Index>(i)));
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = std::sqrt(law.covariance(static_cast<Index>(i), static_cast<Index>(i)));
      CAPTURE(periodic, i, error, of[i].mean(), of[i].deviation());
      CHECK(std::abs(of[i].mean()) <= 4 * error / std::sqrt(200));
      CHECK(std::abs(of[i].deviation() / error - 1) <= 0.2);
    }
  }
}

// 1500 periodic fields of N/S_2 = 163: four errors √(6/1500) of a skewness. Without the covariance with Sq² it
// would be wrong by 0.5.
TEST_CASE("a stretch over the field's own variance is as skewed as stated", "[stretch][statistics]") {
  const Grid g = grid(64, 64, true);
  const LagField rho = LagField::of(
      {32, 32}, [](Index p, Index q) { return std::exp(-static_cast<double>(p * p + q * q) / 16); });
  const double taken = EffectiveSampleSize(rho, g).mean_power(1);
  const LengthStretch::Law law = LengthStretch(rho, g, {16, 16}).law(g, taken);
  const double error = std::sqrt(law.covariance(2, 2));
  Spread of;
  std::vector<double> all;
  for (unsigned seed = 0; seed < 1500; ++seed) {
    const LagField acf =
        estimate_autocorrelation(gaussian_acf_field(g.shape, 4, seed), g, {.max_lag = {16, 16}});
    all.push_back((law(acf)(2) / acf(0, 0) * (1 - taken) + law.with_variance(2)) / error);
    of.add(all.back());
  }
  double cubes = 0;
  for (const double t : all) cubes += std::pow((t - of.mean()) / of.deviation(), 3) / 1500;
  CAPTURE(of.mean(), of.deviation(), cubes, law.skewness()(2), law.with_variance(2) / error);
  CHECK(std::abs(cubes - law.skewness()(2)) <= 4 * std::sqrt(6.0 / 1500));
}
