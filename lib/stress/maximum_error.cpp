#include "stress/maximum_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/halved.hpp"
#include "stress/equivalent.hpp"

namespace asperity {
namespace {

// (1), (2): validation/contact_grid_error.
constexpr double value_share = 0.28;    // of m
constexpr double shallow_share = 0.03;  // of the value, times min(1, (h/z)²)
constexpr double error_of_search = 2e-5, depth_of_search = 2e-4;
constexpr double depth_share = 0.2,
                 depth_share_at_limit = 0.4;  // of m, times the root of the depth in cells
constexpr double second_difference = 0.1;     // of the depth, a share that counts in m
constexpr double shallow_depth_share = 0.02;  // of the depth, over the square of it in cells
constexpr double steps_share = 0.3;           // of a cell, fading below the first
constexpr double near_plastic = 0.1;          // of the value above 2h below a limit pressure

// Of the largest pressure: the edge of cells is a stair, tests/stress/maximum_error.cpp.
constexpr double edge_stairs = 0.015;

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
  return missing > 0 ? missing + edge_stairs * largest : 0;
}

StressMaximum maximum_error(const LoadedBody& body, const std::array<StressMaximum, 3>& maxima,
                            const StressSearch& search, bool at_limit_pressure) {
  const auto& [fine, half, quarter] = maxima;
  const double h = std::hypot(body.grid.dx, body.grid.dy) / std::numbers::sqrt2;
  const double cells = std::max(1.0, fine.depth / h);
  const double edge = search.below > 0 ? 0 : edge_error(fine, search.of, body, at_limit_pressure);
  StressMaximum out;
  if (std::isnan(edge)) {
    out.value = out.depth = edge;
    return out;
  }
  out.value = std::max({value_share * grid_change(fine.value, half.value, quarter.value),
                        shallow_share / (cells * cells) * fine.value, error_of_search * fine.value, edge});
  const double of_change = (at_limit_pressure ? depth_share_at_limit : depth_share) * std::sqrt(cells);
  out.depth = std::max({of_change * grid_change(fine.depth, half.depth, quarter.depth, second_difference),
                        shallow_depth_share / (cells * cells) * fine.depth, depth_of_search * fine.depth,
                        steps_share * h * std::exp(2 * std::numbers::pi * (1 - cells))});
  if (at_limit_pressure && fine.depth < 2 * h) {
    out.value += near_plastic * fine.value;
    out.depth += fine.depth;
  }
  return out;
}

}  // namespace asperity
