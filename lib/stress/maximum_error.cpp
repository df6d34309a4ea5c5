#include "stress/maximum_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/calibration.hpp"
#include "math/grid_change.hpp"
#include "stress/edge.hpp"

namespace asperity {

StressMaximum maximum_error(const LoadedBody& body, const std::array<StressMaximum, 3>& maxima,
                            const StressSearch& search, bool at_limit_pressure) {
  namespace share = calibration::grid_error;
  const auto& [fine, half, quarter] = maxima;
  const double h = std::min(body.grid.dx, body.grid.dy);
  const double shallow = fine.depth > h ? std::pow(h / fine.depth, 2) : 1;
  const double edge = search.below > 0 ? 0 : edge_error(fine, search.of, body, at_limit_pressure);
  StressMaximum out;
  if (std::isnan(edge)) {
    out.value = out.depth = edge;
    return out;
  }
  out.value = std::max({share::maximum_stress * grid_change(fine.value, half.value, quarter.value),
                        share::shallow_stress * shallow * fine.value, share::search * fine.value, edge});
  out.depth = std::max({share::depth * grid_change(fine.depth, half.depth, quarter.depth),
                        share::depth_of_cell * h, share::depth_of_search * fine.depth});
  if (at_limit_pressure && fine.depth < 2 * h) {
    out.value += share::near_plastic * fine.value;
    out.depth += fine.depth;
  }
  return out;
}

}  // namespace asperity
