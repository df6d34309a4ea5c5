#include "stats/filter/resampling.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/words.hpp"
#include "transform/refinement.hpp"

namespace asperity {
namespace {

void resample_axis(Index& points, double& step, bool periodic, double target) {
  if (points == 1) return;
  const double length = static_cast<double>(points) * step, cells = length / target;
  constexpr double most = std::numeric_limits<int>::max() / 2;
  check_parameter(target > 0 && cells >= 2 * (1 - 1e-12) && cells <= most, "spacing",
                  "'" + in_digits(target, 12) + " m' is not from " + number(length / most) +
                      " m to half the axis, " + in_digits(length / 2, 12) + " m");
  points = static_cast<Index>(periodic ? std::round(cells) : std::floor(cells * (1 + 1e-12)));
  step = periodic ? length / static_cast<double>(points) : target;
}

}  // namespace

Grid resampled_grid(const Grid& grid, double dx, double dy) {
  Grid out = grid;
  resample_axis(out.shape.nx, out.dx, grid.periodic.x, dx);
  resample_axis(out.shape.ny, out.dy, grid.periodic.y, dy);
  return out;
}

Field resampled(const Field& z, const Grid& grid, double dx, double dy, int threads) {
  return resampled_onto(z, grid, resampled_grid(grid, dx, dy), threads);
}

}  // namespace asperity
