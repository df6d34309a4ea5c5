#include "contact/bodies.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

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

}  // namespace asperity
