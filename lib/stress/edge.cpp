#include "stress/edge.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/calibration.hpp"
#include "stress/equivalent.hpp"

namespace asperity {
namespace {

// Of the surface in the plane stress σxx, σyy.
double value_of(Criterion of, double xx, double yy) {
  const stress::Tensor s{xx, yy, 0, 0, 0, 0};
  switch (of) {
    case Criterion::von_mises:
      return von_mises(s);
    case Criterion::max_shear:
      return max_shear_stress(s);
    case Criterion::principal:
      return principal_stress(s).value[0];
  }
  return 0;
}

}  // namespace

double edge_stress(Criterion of, double poisson, double friction) {
  const double rest = (1 - 2 * poisson) / 3, slip = std::numbers::pi * friction / 8;
  return std::max(value_of(of, rest + (4 + poisson) * slip, -rest + 3 * poisson * slip),
                  value_of(of, 2 * friction, 2 * poisson * friction));
}

double edge_error(const StressMaximum& maximum, Criterion of, const LoadedBody& body,
                  bool at_limit_pressure) {
  const bool has_edge = !body.grid.periodic.both() || (body.pressure == 0).any();
  if (!has_edge) return 0;
  const bool bears = body.friction.coefficient > 0 || of == Criterion::principal;
  if (at_limit_pressure) return bears ? std::numeric_limits<double>::quiet_NaN() : 0;
  const double largest = body.pressure.maxCoeff(),
               missing = edge_stress(of, body.poisson, body.friction.coefficient) * largest - maximum.value;
  return missing > 0 ? missing + calibration::stress::edge_stairs * largest : 0;
}

}  // namespace asperity
