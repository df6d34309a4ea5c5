#include "stats/spatial/acf.hpp"

#include "core/error.hpp"
#include "fields.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf_length.hpp"

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

// ---- structure function ----

namespace {

double direct_structure(const Field& z, bool periodic, Index p, Index q) {
  const Index nx = z.rows(), ny = z.cols();
  double sum = 0, pairs = 0;
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j) {
      const Index a = i + p, b = j + q;
      if (!periodic && (a >= nx || b < 0 || b >= ny)) continue;
      sum += std::pow(z(a % nx, (b + ny) % ny) - z(i, j), 2);
      ++pairs;
    }
  return sum / pairs;
}

}  // namespace

// Transforms and partial sums add 12 ε each of Σz² to the sums; the fewest pairs are one.
TEST_CASE("the structure function equals the mean square difference of all pairs at every lag",
          "[structure-function][exact]") {
  for (Shape shape : {Shape{1, 9}, Shape{12, 1}, Shape{13, 10}, Shape{7, 33}}) {
    const Field z = 5 + random_field(shape, 101);
    const double bound = 24 * epsilon * (z - z.mean()).square().sum();
    for (const bool periodic : {false, true}) {
      const Shape lags = periodic ? Shape{shape.nx / 2, shape.ny / 2} : Shape{shape.nx - 1, shape.ny - 1};
      const LagField S = structure_function(z, grid(shape.nx, shape.ny, periodic), lags);
      for (Index p = 0; p <= lags.nx; ++p)
        for (Index q = -lags.ny; q <= lags.ny; ++q)
          CHECK(std::abs(S(p, q) - direct_structure(z, periodic, p, q)) <= 2 * bound);
    }
  }
}

TEST_CASE("a plane of slopes a, b has the structure function (ap + bq)^2, which no stationary surface has",
          "[structure-function][exact]") {
  const Field z = sample(grid(20, 16), [](double x, double y) { return 0.2 * x - 0.1 * y; });
  const LagField S = structure_function(z, grid(20, 16), {10, 8});
  for (Index p = 0; p <= 10; ++p)
    for (Index q = -8; q <= 8; ++q) {
      const double step = 0.2 * static_cast<double>(p) - 0.1 * static_cast<double>(q);
      CHECK(std::abs(S(p, q) - step * step) <= 48 * epsilon * (z - z.mean()).square().sum());
    }
  CHECK_THROWS_AS(structure_function(z, grid(20, 16), {20, 3}), ParameterError);
}

// ---- acf lobe ----

namespace {

// ρ = shape(r') with r' = √((x'/a)² + (y'/b)²), x' turned by the angle; lags in metres on the grid.
template <class Shape>
LagField elliptic(const Grid& g, Index lags, double a, double b, double angle, Shape shape) {
  return LagField(Field::NullaryExpr(lags + 1, 2 * lags + 1, [&](Index p, Index column) {
    const double x = static_cast<double>(p) * g.dx, y = static_cast<double>(column - lags) * g.dy;
    const double along = std::cos(angle) * x + std::sin(angle) * y,
                 across = std::cos(angle) * y - std::sin(angle) * x;
    return shape(std::hypot(along / a, across / b));
  }));
}

double exponential(double r) { return std::exp(-r); }
double gaussian(double r) { return std::exp(-r * r); }

// The angle between two axes.
double between(double a, double b) { return std::abs(std::remainder(a - b, std::numbers::pi)); }

}  // namespace

// Interpolation h²/(8r) and the direction h²/(4r), h the larger spacing; of the ratio the sum of both
// relative errors. The ellipse is fitted to points that lie within h²/(8r) of it, r the nearest.
TEST_CASE(
    "Sal, Str and the ellipse of an elliptic ACF are its axes within 3/8 of a sample squared over the length",
    "[acf-lobe][order]") {
  const double ln5 = std::log(5.0);
  for (const double angle : {0.0, 0.4, 1.2, -0.9}) {
    for (const double a : {12.0, 25.0, 60.0}) {
      const Grid g{{512, 512}, 1.0, 0.7, false};
      const double b = 0.4 * a;
      CAPTURE(angle, a);
      for (const bool smooth : {false, true}) {
        const double factor = smooth ? std::sqrt(ln5) : ln5, fast = factor * b, slow = factor * a;
        const double near_error = 0.375 / fast, far_error = 0.375 * slow / (fast * fast);
        const CentralLobe lobe =
            central_lobe(elliptic(g, 180, a, b, angle, smooth ? gaussian : exponential), g);
        REQUIRE((lobe.r_min && lobe.r_max && lobe.ellipse));
        CHECK(std::abs(lobe.r_min->length - fast) <= near_error);
        CHECK(std::abs(lobe.r_max->length - slow) <= far_error);
        CHECK(std::abs(*lobe.aspect_ratio() - 0.4) <= 0.4 * (near_error / fast + far_error / slow));
        CHECK(std::abs(lobe.ellipse->minor - fast) <= near_error / 3);
        CHECK(std::abs(lobe.ellipse->major.length - slow) <= far_error / 3);
        CHECK(between(lobe.ellipse->major.angle, angle) <= 0.125 / (fast * fast));
        // Of 2 ln of the ratio of the axes ε has the slope 1 - ε² ≤ 1 each.
        const double ratio = slow / fast, e = (ratio * ratio - 1) / (ratio * ratio + 1);
        const Eigen::Vector2d of_axes = e * Eigen::Vector2d(std::cos(2 * angle), std::sin(2 * angle));
        CHECK((*lobe.anisotropy - of_axes).norm() <=
              (near_error / fast + far_error / slow) / 3 + 0.25 / (fast * fast));
        // Two samples to either side of an axis r differs by less than h²/(2r).
        CHECK(between(lobe.r_max->angle, angle) <= 2 / fast);
        CHECK(between(lobe.r_min->angle, angle + std::numbers::pi / 2) <= 2 / fast);
      }
    }
  }
}

TEST_CASE(
    "the length in a direction is the radius of the ellipse within 1/4 of a sample squared over the length",
    "[acf-length][order]") {
  const Grid g{{512, 512}, 1.0, 0.7, false};
  const double a = 30, b = 18, angle = 0.6;
  for (const bool smooth : {false, true}) {
    const LagField rho = elliptic(g, 120, a, b, angle, smooth ? gaussian : exponential);
    for (double level : {0.1, 1 / std::numbers::e, 0.5})
      for (double direction = -1.5; direction <= 3; direction += 0.1) {
        const double fall = -std::log(level), r = smooth ? std::sqrt(fall) : fall;
        const double length =
            r / std::hypot(std::cos(direction - angle) / a, std::sin(direction - angle) / b);
        const auto crossing = first_crossing(rho, g, direction, level);
        REQUIRE(crossing);
        CAPTURE(smooth, level, direction);
        CHECK(std::abs(crossing->lag - length) <= 0.25 / length * (a / b));
        CHECK(relative_error(crossing->slope, -level * (smooth ? 2 * r : 1) * r / length) <= 1.5 / length);
      }
  }
}

TEST_CASE("along x and y the length in a direction is that of the profile", "[acf-length][exact]") {
  const Grid g{{64, 64}, 0.5, 2.0, false};
  const LagField rho = elliptic(g, 30, 4, 11, 0.3, exponential);
  const auto x = first_crossing(rho, g, 0, 0.3), along_x = first_crossing(rho.along_x(), 0.3);
  const auto y = first_crossing(rho, g, std::numbers::pi / 2, 0.3),
             along_y = first_crossing(rho.along_y(), 0.3);
  CHECK(relative_error(x->lag, along_x->lag * g.dx) <= 10 * epsilon);
  CHECK(relative_error(y->lag, along_y->lag * g.dy) <= 1e-14);
  CHECK(relative_error(y->slope, along_y->slope / g.dy) <= 1e-14);
}

// A second lobe as high as the first, at 20 samples: cos²-shaped ridges beside the central one.
TEST_CASE("lobes beside the central one count neither for Str nor for the ellipse", "[acf-lobe][exact]") {
  const Grid g = grid(100, 100);
  const LagField rho(Field::NullaryExpr(41, 81, [](Index p, Index column) {
    const double r = std::hypot(static_cast<double>(p), static_cast<double>(column - 40));
    return std::exp(-r / 6) +
           (std::hypot(static_cast<double>(p) - 25, static_cast<double>(column - 40)) < 4 ? 0.9 : 0);
  }));
  const CentralLobe lobe = central_lobe(rho, g);
  REQUIRE(lobe.r_max);
  const double exact = 6 * std::log(5.0);
  CHECK(std::abs(lobe.r_min->length - exact) <= 0.375 / exact);
  CHECK(std::abs(lobe.r_max->length - exact) <= 0.375 / exact);
}

TEST_CASE("a lobe that reaches the longest lags has Sal across it but neither Str nor an ellipse",
          "[acf-lobe][contract]") {
  const Grid g = grid(100, 100);
  const LagField ridges = elliptic(g, 40, 1e4, 5, 0.0, exponential);
  const CentralLobe lobe = central_lobe(ridges, g);
  REQUIRE(lobe.r_min);
  CHECK(lobe.r_min->length == Approx(5 * std::log(5.0)).epsilon(1e-3));
  CHECK_FALSE(lobe.r_max);
  CHECK_FALSE(lobe.ellipse);
  CHECK_FALSE(lobe.aspect_ratio());
  CHECK_FALSE(central_lobe(LagField(Field::Ones(5, 9)), g).r_min);
  CHECK_THROWS_AS(central_lobe(ridges, g, 1.0), ParameterError);
  CHECK_THROWS_AS(central_lobe(ridges, g, 0.0), ParameterError);
}

// Of the first 64 lags alone, where lengths are looked for first, the lobe is open and nothing falls to 10 %.
TEST_CASE("lengths beyond the first 64 lags are found as among all lags", "[acf][exact]") {
  const Grid g = grid(400, 60);
  const Surface surface = prepared({.grid = g, .heights = moving_average(g.shape, {90, 3}, 7)}, {});
  const AcfEstimate estimate = AcfEstimate::of(surface, {.max_lag = default_max_lag(g)});
  const Parameters lengths = acf_lengths(estimate, {{0.1, "10", "10 %"}}, {}, {}, {});
  const auto crossing = first_crossing(estimate.rho, g, 0, 0.1);
  REQUIRE(crossing);
  CHECK(crossing->lag > 64);
  CHECK(std::ranges::find(lengths, "length_10_x", &Parameter::name)->value == crossing->lag);
  CHECK(std::ranges::find(lengths, "ellipticity_10", &Parameter::name)->value ==
        central_lobe(estimate.rho, g, 0.1).ellipse->gamma());
}
