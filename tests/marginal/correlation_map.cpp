#include "marginal/correlation_map.hpp"

#include <numbers>

#include <gsl/gsl_cdf.h>

#include "marginal/measured.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

template <class Function>
Translation pointwise(double detail, Function g) {
  return {"", detail, [g](std::span<double> y) {
            for (double& value : y) value = g(value);
          }};
}

// The largest difference from a closed form over [-1, 1], and of R(R⁻¹(r)) from r.
template <class Function>
void require_closed_form(const CorrelationMap& map, Function exact, double tolerance) {
  for (double rho = -1; rho <= 1; rho += 1.0 / 64) {
    CAPTURE(rho);
    CHECK(std::abs(map(rho) - exact(rho)) <= tolerance);
    CHECK(std::abs(map(map.inverse(exact(rho))) - exact(rho)) <= tolerance + 1e-11);
  }
}

}  // namespace

// Series and quadrature are computed to 1e-13 of the variance; the closed forms' own round-off is ε times
// their conditioning, below 10 here.
TEST_CASE("the correlation of a lognormal translation is (w^rho - 1)/(w - 1)", "[correlation_map][exact]") {
  for (double delta : {0.7, 1.0, 2.0, 8.0}) {
    CAPTURE(delta);
    const double w = std::exp(1 / (delta * delta));
    const CorrelationMap map(pointwise(
        1, [=](double y) { return std::expm1(y / delta - 0.5 / (delta * delta)) / std::sqrt(w - 1); }));
    require_closed_form(
        map, [&](double rho) { return std::expm1(rho / (delta * delta)) / (w - 1); }, 1e-12);
    CHECK(std::abs(map.lowest() + 1 / w) <= 1e-12);
  }
}

TEST_CASE("the correlation of a hyperbolic sine is a quotient of hyperbolic sines",
          "[correlation_map][exact]") {
  for (double delta : {0.8, 1.5, 5.0}) {
    CAPTURE(delta);
    const double w = 1 / (delta * delta), rms = std::sqrt(0.5 * std::expm1(2 * w));
    const CorrelationMap map(pointwise(1, [=](double y) { return std::sinh(y / delta) / rms; }));
    require_closed_form(
        map, [&](double rho) { return std::sinh(rho * w) / std::sinh(w); }, 1e-12);
    CHECK(std::abs(map.lowest() + 1) <= 1e-12);
  }
}

// Φ is entire, but its orders fall like 4^-k only: the series ends where 1e-13 are left.
TEST_CASE("uniform heights of correlation rho have the correlation (6/pi) asin(rho/2)",
          "[correlation_map][exact]") {
  const CorrelationMap map(
      pointwise(1, [](double y) { return std::sqrt(12.0) * (gsl_cdf_ugaussian_P(y) - 0.5); }));
  CHECK(map.tail() <= 1e-13);
  require_closed_form(
      map, [](double rho) { return 6 / std::numbers::pi * std::asin(rho / 2); }, 1e-12);
}

// Two values: the orders fall like k^(-3/2), and what is left of them, the tail, bounds the error. Where the
// step is smeared over a detail the exact correlation itself differs by some details near ρ = 1.
TEST_CASE(
    "a tanh so steep that heights have two values has the correlation (2/pi) asin(rho), within its tail",
    "[correlation_map][law]") {
  const double detail = 1e-3;
  const CorrelationMap map(pointwise(detail, [=](double y) { return std::tanh(y / (2 * detail)); }));
  CHECK(map.tail() > 1e-4);
  for (double rho : {-0.99, -0.5, 0.1, 0.5, 0.9}) {
    CAPTURE(rho);
    CHECK(std::abs(map(rho) - 2 / std::numbers::pi * std::asin(rho)) <= map.tail());
  }
  CHECK(std::abs(map(1) - 1) <= 1e-12);
}

TEST_CASE("the inverse is the limit below the lowest correlation and above 1",
          "[correlation_map][contract]") {
  const CorrelationMap map(pointwise(1, [](double y) { return y; }));
  CHECK(map.orders() == 2);  // the first and an empty tail
  CHECK(map.inverse(-1.5) == -1);
  CHECK(map.inverse(1.5) == 1);
  CHECK(map.inverse(1) == 1);
  CHECK(std::abs(map.inverse(0.3) - 0.3) <= 1e-12);
}
