#include "contact/hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_sf_ellint.h>

#include "contact/influence.hpp"
#include "core/error.hpp"

namespace asperity {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int bisections = 64;
constexpr double largest_ratio = 1e100;  // of curvatures; GSL's R_D ends at k² = 1e-204

double carlson_d(double x, double y, double z) { return gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE); }

// k ≤ 1 of (4) for B/A = exp(ratio) ≥ 1; it lies above A/B. Bisection does not mind that near k = 1 round-off
// takes the sign of the mismatch at both ends.
double axes_ratio(double ratio) {
  double low = -ratio, high = 0;
  for (int i = 0; i < bisections; ++i) {
    const double middle = (low + high) / 2, k2 = std::exp(2 * middle);
    (std::log(carlson_d(0, 1, k2) / carlson_d(0, k2, 1)) - ratio > 0 ? low : high) = middle;
  }
  return std::exp(high);
}

}  // namespace

bool has_point_contact(const Bodies& bodies) {
  const auto [less, more] = std::minmax({bodies.curvature_x(), bodies.curvature_y()});
  return less > 0 && std::isfinite(more) && more / less <= largest_ratio;
}

Hertz hertz(const Bodies& bodies, double load) {
  bodies.check();
  if (!has_point_contact(bodies))
    throw ParameterError(
        "radius", fmt::format("composite curvatures of {} and {} 1/m have no contact in a point: both must "
                              "be above 0, and neither {:.0e} times the other",
                              bodies.curvature_x(), bodies.curvature_y(), largest_ratio));
  if (!(load > 0 && std::isfinite(load)))
    throw ParameterError("load", fmt::format("{} N is not above 0", load));
  const double along_x = bodies.curvature_x(), along_y = bodies.curvature_y();
  const auto [less, more] = std::minmax({along_x, along_y});
  const double k = axes_ratio(std::log(more / less)), modulus = bodies.composite_modulus();
  const double a = std::cbrt(load * carlson_d(0, k * k, 1) / (pi * modulus * less)), b = k * a;

  Hertz out{std::sqrt(a * b), 1.5 * load / (pi * a * b), 0, a, b};
  out.approach = out.pressure * b * gsl_sf_ellint_RF(0, k * k, 1, GSL_PREC_DOUBLE) / modulus;
  if (along_x > along_y) std::swap(out.radius_x, out.radius_y);
  return out;
}

HertzLine hertz_line(double composite_modulus, double curvature, double load_per_length, double datum) {
  const double b = std::sqrt(4 * load_per_length / (pi * composite_modulus * curvature));
  return {b, 2 * load_per_length / (pi * b),
          load_per_length / (pi * composite_modulus) * (1 + 2 * std::log(2 * datum / b))};
}

bool has_line_contact(const Grid& grid, const Bodies& bodies) {
  const double across = grid.periodic.x ? bodies.curvature_y() : bodies.curvature_x();
  return grid.periodic.one() && across > 0 && std::isfinite(across);
}

HertzLine hertz_line(const Grid& grid, const Bodies& bodies, double load) {
  const bool in_x = grid.periodic.x;
  return hertz_line(bodies.composite_modulus(), in_x ? bodies.curvature_y() : bodies.curvature_x(),
                    load / (in_x ? grid.size_x() : grid.size_y()), displacement_datum(grid));
}

}  // namespace asperity
