#include "contact/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <gsl/gsl_sf_ellint.h>

#include "contact/influence.hpp"
#include "core/error.hpp"
#include "core/poisson.hpp"

namespace asperity {

namespace {

void check_radii(const char* name, double first, double second) {
  for (double r : {first, second})
    if (std::isnan(r) || r == 0) throw ParameterError(name, fmt::format("{} m is not a radius", r));
  if (!(1 / first + 1 / second >= 0))
    throw ParameterError(name, fmt::format("the hollow of {} m is narrower than the other body, {} m",
                                           std::min(first, second), std::max(first, second)));
}

constexpr int bisections = 64;
constexpr double largest_ratio = 1e100;  // of curvatures; GSL's R_D ends at k² = 1e-204

double carlson_d(double x, double y, double z) { return gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE); }

// k ≤ 1 of (7) for B/A = exp(ratio) ≥ 1; it lies above A/B. Bisection does not mind that near k = 1 round-off
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

void Bodies::check() const {
  auto round = [](Radii r) { return r.x == r.y || (std::isnan(r.x) && std::isnan(r.y)); };
  const bool spheres = round(radius[0]) && round(radius[1]);
  check_radii(spheres ? "radius" : "radius-x", radius[0].x, radius[1].x);
  check_radii(spheres ? "radius" : "radius-y", radius[0].y, radius[1].y);
  for (double e : young)
    if (!(e > 0)) throw ParameterError("young", fmt::format("{} Pa is not above 0", e));
  if (std::isinf(young[0]) && std::isinf(young[1])) throw ParameterError("young", "both bodies are rigid");
  for (double nu : poisson) check_poisson(nu);
}

double Bodies::composite_modulus() const {
  return 1 / ((1 - poisson[0] * poisson[0]) / young[0] + (1 - poisson[1] * poisson[1]) / young[1]);
}

double Bodies::curvature_x() const { return 1 / radius[0].x + 1 / radius[1].x; }

double Bodies::curvature_y() const { return 1 / radius[0].y + 1 / radius[1].y; }

Field undeformed_gap(const Grid& grid, const Bodies& bodies) {
  return undeformed_gap(grid, bodies, {0, grid.shape.nx});
}

Field undeformed_gap(const Grid& grid, const Bodies& bodies, Extent rows) {
  const double half_x = bodies.curvature_x() / 2, half_y = bodies.curvature_y() / 2;
  return Field::NullaryExpr(rows.count, grid.shape.ny, [&](Index i, Index j) {
    const double x = grid.x(rows.first + i), y = grid.y(j);
    return half_x * x * x + half_y * y * y;
  });
}

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
  const double a = std::cbrt(load * carlson_d(0, k * k, 1) / (std::numbers::pi * modulus * less)), b = k * a;

  Hertz out{std::sqrt(a * b), 1.5 * load / (std::numbers::pi * a * b), 0, a, b};
  out.approach = out.pressure * b * gsl_sf_ellint_RF(0, k * k, 1, GSL_PREC_DOUBLE) / modulus;
  if (along_x > along_y) std::swap(out.radius_x, out.radius_y);
  return out;
}

HertzLine hertz_line(double composite_modulus, double curvature, double load_per_length, double datum) {
  const double b = std::sqrt(4 * load_per_length / (std::numbers::pi * composite_modulus * curvature));
  return {b, 2 * load_per_length / (std::numbers::pi * b),
          load_per_length / (std::numbers::pi * composite_modulus) * (1 + 2 * std::log(2 * datum / b))};
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
