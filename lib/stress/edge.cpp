#include "stress/edge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/calibration.hpp"

namespace asperity {

// Linear between the values at every tenth of ν from Hamilton's field; the first is on the line through 0.
double edge_friction(double poisson) {
  constexpr std::array at_tenths{-0.0231, 0.0138, 0.0507, 0.0933, 0.1416,
                                 0.1945,  0.2499, 0.3047, 0.3558, 0.4069};
  constexpr double first = -0.4, spacing = 0.1;
  const double place =
      std::clamp((poisson - first) / spacing, 0.0, static_cast<double>(at_tenths.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(place), at_tenths.size() - 2);
  return std::max(0.0, std::lerp(at_tenths[k], at_tenths[k + 1], place - static_cast<double>(k)));
}

bool has_edge(const LoadedBody& body) { return !body.grid.periodic || (body.pressure == 0).any(); }

bool is_at_edge(const StressMaximum& maximum, Criterion of, const LoadedBody& body) {
  return has_edge(body) && maximum.depth < accurate_depth(body.grid) &&
         (of == Criterion::principal || body.friction.coefficient >= edge_friction(body.poisson));
}

double edge_error(const LoadedBody& body, Criterion of) {
  const double tension =
      of == Criterion::principal ? calibration::stress::edge_error_tension * body.friction.coefficient : 0;
  return (shallow_error(body.poisson, body.friction) + tension) * body.pressure.maxCoeff();
}

}  // namespace asperity
