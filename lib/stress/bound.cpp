#include "stress/bound.hpp"

#include <cmath>
#include <limits>

#include "stress/influence.hpp"

namespace asperity {
namespace {

double norm(const stress::Tensor& s) {
  double sum = 0;
  for (stress::Component c : stress::components) sum += (c < stress::xy ? 1 : 2) * s[c] * s[c];
  return std::sqrt(sum);
}

// The largest norm at depth 1 under a unit force.
double largest_norm(double poisson, stress::Traction load) {
  constexpr int steps = 100;
  double top = 0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      top = std::max(top, norm(point_load_stress(4.0 * i / steps, 4.0 * j / steps, 1, poisson, load)));
  return 1.01 * top;
}

}  // namespace

StressBound::StressBound(const Grid& grid, const Field& pressure, const Friction& friction, double poisson)
    : force_(std::numeric_limits<double>::infinity()) {
  if (grid.periodic) return;
  const double sliding =
      friction.coefficient > 0 ? friction.coefficient * largest_norm(poisson, stress::shear_x) : 0;
  force_ = std::sqrt(1.5) * (largest_norm(poisson, stress::normal) + sliding) * pressure.abs().sum() *
           grid.cell_area();
}

double StressBound::at(double z) const {
  return z > 0 ? force_ / (z * z) : std::numeric_limits<double>::infinity();
}

}  // namespace asperity
