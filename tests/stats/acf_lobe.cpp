#include "core/error.hpp"
#include "fields.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/spatial/acf_length.hpp"

using namespace asperity;
using namespace asperity::test;

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
