#include "stats/spatial/acf.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/uncertainty/acf_error.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double direct(const Field& d, bool periodic, Index p, Index q, bool biased) {
  const Index nx = d.rows(), ny = d.cols();
  double sum = 0, pairs = 0;
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const Index a = i + p, b = j + q;
      if (!periodic && (a < 0 || a >= nx || b < 0 || b >= ny)) continue;
      sum += d(i, j) * d((a + nx) % nx, (b + ny) % ny);
      ++pairs;
    }
  return sum / (biased ? static_cast<double>(d.size()) : pairs);
}

double greatest_difference(const Field& z, const Grid& g, const AcfParameters& parameters) {
  const LagField acf = estimate_autocorrelation(z, g, parameters);
  const Field d = z - parameters.level.value_or(z.mean());
  double worst = 0;
  for (Index p = -acf.max_p(); p <= acf.max_p(); ++p)
    for (Index q = -acf.max_q(); q <= acf.max_q(); ++q)
      worst = std::max(worst, std::abs(acf(p, q) - direct(d, g.periodic.both(), p, q, parameters.biased)));
  return worst;
}

Eigen::ArrayXd profile(Index n, double (*rho)(double)) {
  return Eigen::ArrayXd::NullaryExpr(n, [&](Index p) { return rho(static_cast<double>(p)); });
}

}  // namespace

// Transforms add ε log2(torus) ≤ 12 ε of Σd² to each sum of pairs; the fewest pairs are one.
TEST_CASE("the ACF by FFT equals the direct sum over pairs at every lag", "[acf][exact]") {
  for (Shape shape : {Shape{1, 9}, Shape{12, 1}, Shape{8, 8}, Shape{13, 10}, Shape{7, 33}}) {
    const Field z = random_field(shape, 11);
    const double bound = 12 * epsilon * z.square().sum();
    const Grid open = grid(shape.nx, shape.ny), periodic = grid(shape.nx, shape.ny, true);
    const Shape all{shape.nx - 1, shape.ny - 1}, half{shape.nx / 2, shape.ny / 2};
    CAPTURE(shape.nx, shape.ny);
    CHECK(greatest_difference(z, open, {.max_lag = all}) <= bound);
    CHECK(greatest_difference(z, open, {.max_lag = half, .biased = true}) <= bound);
    CHECK(greatest_difference(z, open, {.max_lag = half, .level = 0.1}) <= bound);
    CHECK(greatest_difference(z, periodic, {.max_lag = half}) <= bound);
    Grid strip = open;  // along one axis alone: a piece
    for (Periodic one : {Periodic{true, false}, Periodic{false, true}}) {
      strip.periodic = one;
      CHECK(greatest_difference(z, strip, {.max_lag = all}) <= bound);
    }
  }
}

TEST_CASE("a periodic sine of amplitude A has the ACF A^2/2 cos(q lag)", "[acf][exact]") {
  const double A = 2e-6;
  const Field z = sine({48, 16}, A, 3);
  const LagField acf = estimate_autocorrelation(z, grid(48, 16, true), {.max_lag = {24, 8}});
  for (Index p = 0; p <= 24; ++p)
    for (Index q = -8; q <= 8; ++q) {
      const double exact = A * A / 2 * std::cos(2 * std::numbers::pi * 3 * static_cast<double>(p) / 48);
      CHECK(std::abs(acf(p, q) - exact) <= 12 * epsilon * A * A);
    }
}

TEST_CASE("turning the surface over x mirrors q, transposing it exchanges p and q", "[acf][law]") {
  const Field z = moving_average({30, 22}, {3, 2}, 12) + random_field({30, 22}, 13);
  const double bound = 12 * epsilon * z.square().sum();
  const LagField acf = estimate_autocorrelation(z, grid(30, 22), {.max_lag = {9, 9}});
  const LagField flipped = estimate_autocorrelation(z.colwise().reverse(), grid(30, 22), {.max_lag = {9, 9}});
  const LagField transposed = estimate_autocorrelation(z.transpose(), grid(22, 30), {.max_lag = {9, 9}});
  for (Index p = -9; p <= 9; ++p)
    for (Index q = -9; q <= 9; ++q) {
      CHECK(std::abs(flipped(p, q) - acf(p, -q)) <= bound);
      CHECK(std::abs(transposed(q, p) - acf(p, q)) <= bound);
    }
}

TEST_CASE("the ACF at lag zero is Sq squared and bounds the biased ACF at every lag", "[acf][law]") {
  const Field z = moving_average({40, 40}, {4, 4}, 14);
  const LagField acf = estimate_autocorrelation(z, grid(40, 40), {.max_lag = {39, 39}, .biased = true});
  const double variance = (z - z.mean()).square().mean();
  CHECK(relative_error(acf(0, 0), variance) <= 40 * epsilon);
  CHECK(acf.half_plane().abs().maxCoeff() <= acf(0, 0));
}

TEST_CASE("the ACF does not depend on the number of threads, to the last bit", "[acf][law]") {
  const Field z = random_field({70, 90}, 15);
  auto of = [&](int threads) {
    return estimate_autocorrelation(z, grid(70, 90), {.max_lag = {30, 30}, .threads = threads}).half_plane();
  };
  CHECK((of(1) == of(3)).all());
}

TEST_CASE("lags beyond the field, or beyond half a period, are refused as --max-lag", "[acf][contract]") {
  const Field z = random_field({16, 16}, 16);
  CHECK_THROWS_AS(estimate_autocorrelation(z, grid(16, 16), {.max_lag = {16, 3}}), ParameterError);
  CHECK_THROWS_AS(estimate_autocorrelation(z, grid(16, 16), {.max_lag = {3, -1}}), ParameterError);
  CHECK_THROWS_AS(estimate_autocorrelation(z, grid(16, 16, true), {.max_lag = {9, 3}}), ParameterError);
  CHECK_NOTHROW(estimate_autocorrelation(z, grid(16, 16), {.max_lag = {15, 15}}));
}

// λ of exp(-0.31 p) at level t is ln(1/t)/0.31; rounding of two logarithms.
TEST_CASE("the first crossing of an exponential is exact at any level", "[acf-length][exact]") {
  const auto rho = profile(60, [](double p) { return std::exp(-0.31 * p); });
  for (double level : {0.9, 0.5, 1 / std::numbers::e, 0.1, 1e-6}) {
    const auto crossing = first_crossing(rho, level);
    REQUIRE(crossing);
    CHECK(relative_error(crossing->lag, std::log(1 / level) / 0.31) <= 100 * epsilon);
    CHECK(relative_error(crossing->slope, -0.31 * level) <= 100 * epsilon);
  }
}

// With ln ρ = -b p² the chord over one sample lies b s(1-s) below the parabola at the fraction s, and the
// slope there is -2bλ: the crossing comes early by s(1-s)/(2λ), but for terms of higher order in 1/λ.
TEST_CASE("the first crossing of a Gaussian ACF is early by s(1-s)/(2 lag)", "[acf-length][order]") {
  const auto rho = profile(200, [](double p) { return std::exp(-p * p / 2500); });
  for (double level : {0.8, 0.5, 1 / std::numbers::e, 0.1}) {
    const double exact = 50 * std::sqrt(-std::log(level)), s = exact - std::floor(exact);
    const auto crossing = first_crossing(rho, level);
    REQUIRE(crossing);
    CHECK(std::abs(exact - crossing->lag - s * (1 - s) / (2 * exact)) <= 1 / (exact * exact));
  }
}

TEST_CASE("a profile that jumps below zero is crossed on a straight line, one that stays above is not",
          "[acf-length][contract]") {
  Eigen::ArrayXd rho(3);
  rho << 1.0, 0.6, -0.4;
  CHECK(first_crossing(rho, 0.1)->lag == Approx(1.5).epsilon(1e-14));
  CHECK_FALSE(first_crossing(rho.head(2), 0.1));
}

// From 0.25, the level 0.1: a straight line to zero is crossed at 0.6, and ln ρ would be at 0.17 for ρ =
// 1e-3.
TEST_CASE("noise about a correlation of zero does not move the crossing before it by a tenth of a sample",
          "[acf-length][law]") {
  const double at_zero = crossing_between(0.25, 0, 0.1).lag;
  CHECK(at_zero == Approx(0.6).epsilon(1e-14));
  double former = at_zero;
  for (double below = 1e-4; below <= 0.05; below += 1e-4) {
    const double lag = crossing_between(0.25, below, 0.1).lag;
    CHECK(std::abs(lag - at_zero) <= 0.1);
    CHECK(std::abs(lag - former) <= 0.002);
    former = lag;
  }
}

// 1/n Σ over one lag: E[z²]² = 1.
TEST_CASE("white noise has ACF errors of 1/sqrt(pairs), and none at lag zero", "[acf-error][exact]") {
  const AcfError error(triangular_correlation({1, 1}), grid(20, 30));
  CHECK(relative_error(error.normalised(5, -6), 1 / std::sqrt(15.0 * 24)) <= 10 * epsilon);
  CHECK(error.normalised(0, 0) == 0);
}

// 400 fields: the mean's standard error is SE/20. The spread of a spread is 1/√800 = 3.5 %, and up to twice
// that for the skewed sums of squares near lag zero; four of them. 4.2 standard errors leave 1 % for 7 × 13
// lags together; the ratio's own bias is of second order, 1/N_eff = 0.6 % of ρ.
TEST_CASE("over an ensemble the normalised ACF is unbiased and as wide as Bartlett's formula says",
          "[acf-error][statistics]") {
  const Shape window{4, 3};
  const Grid g = grid(48, 40);
  const LagField rho = triangular_correlation(window);
  const AcfError error(rho, g);
  std::vector<Spread> normalised(7 * 13);
  for (unsigned seed = 0; seed < 400; ++seed) {
    const LagField acf =
        estimate_autocorrelation(moving_average(g.shape, window, seed), g, {.max_lag = {6, 6}, .level = 0.0});
    for (Index p = 0; p <= 6; ++p)
      for (Index q = -6; q <= 6; ++q)
        normalised[static_cast<std::size_t>(13 * p + 6 + q)].add(acf(p, q) / acf(0, 0));
  }
  for (Index p = 0; p <= 6; ++p)
    for (Index q = -6; q <= 6; ++q) {
      const Spread& of = normalised[static_cast<std::size_t>(13 * p + 6 + q)];
      CAPTURE(p, q);
      CHECK(std::abs(of.mean() - rho(p, q)) <= 4.2 * error.normalised(p, q) / 20 + 0.006 * rho(p, q));
      CHECK(of.deviation() == Approx(error.normalised(p, q)).epsilon(0.2));
    }
}
