#include "stress/maximum_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/calibration.hpp"
#include "core/halved.hpp"
#include "stress/edge.hpp"

namespace asperity {

StressMaximum maximum_error(const LoadedBody& body, const std::array<StressMaximum, 3>& maxima,
                            const StressSearch& search, bool at_limit_pressure) {
  namespace share = calibration::grid_error;
  const auto& [fine, half, quarter] = maxima;
  const double h = std::min(body.grid.dx, body.grid.dy);
  const double cells = std::max(1.0, fine.depth / h);
  const double edge = search.below > 0 ? 0 : edge_error(fine, search.of, body, at_limit_pressure);
  StressMaximum out;
  if (std::isnan(edge)) {
    out.value = out.depth = edge;
    return out;
  }
  out.value =
      std::max({share::maximum_stress * grid_change(fine.value, half.value, quarter.value),
                share::shallow_stress / (cells * cells) * fine.value, share::search * fine.value, edge});
  const double of_change = (at_limit_pressure ? share::depth_at_limit : share::depth) * std::sqrt(cells);
  out.depth =
      std::max({of_change * grid_change(fine.depth, half.depth, quarter.depth, share::floor_of_depth),
                share::depth_of_search * fine.depth, calibration::stress::scan_shallowest * h - fine.depth});
  if (at_limit_pressure && fine.depth < 2 * h) {
    out.value += share::near_plastic * fine.value;
    out.depth += fine.depth;
  }
  return out;
}

}  // namespace asperity
