#include "stats/hybrid/slope_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/halved.hpp"
#include "stats/filter/form.hpp"

namespace asperity {
namespace {

constexpr Index least_side = 16;
constexpr double round_off = 1e-12;     // of a mean square slope, by which it may fall
constexpr double left_of_form = 1e-20;  // of a mean square slope, by its round-off

// Of gamma, from which on a grid does not resolve the slopes, or may not: validation/contact_grid_error.
constexpr double unresolved = 1.0, doubtful = 0.8;

double mean_square_slope(const Field& z, const Grid& grid) {
  const Index nx = z.rows(), ny = z.cols();
  double x = (z.bottomRows(nx - 1) - z.topRows(nx - 1)).square().sum();
  double y = (z.rightCols(ny - 1) - z.leftCols(ny - 1)).square().sum();
  const bool around = grid.periodic.both();
  if (around) {
    x += (z.row(0) - z.row(nx - 1)).square().sum();
    y += (z.col(0) - z.col(ny - 1)).square().sum();
  }
  const Index sides = around ? 0 : 1;
  return x / (grid.dx * grid.dx * static_cast<double>((nx - sides) * ny)) +
         y / (grid.dy * grid.dy * static_cast<double>(nx * (ny - sides)));
}

}  // namespace

Resolved SlopeGrowth::resolved() const {
  return gamma >= unresolved ? Resolved::no : gamma >= doubtful ? Resolved::doubtful : Resolved::yes;
}

SlopeGrowth slope_growth(Field z, const Grid& grid, int threads) {
  if (std::min(grid.shape.nx, grid.shape.ny) < least_side) return {std::numeric_limits<double>::quiet_NaN()};
  const double with_form = mean_square_slope(z, grid);
  if (!grid.periodic.both()) z = remove_form(std::move(z), 2);
  std::array<double, 3> slopes{};
  Grid cells = grid;
  for (double& slope : slopes) {
    slope = mean_square_slope(z, cells);
    cells.periodic = cells.periodic.both() && cells.shape.nx % 2 == 0 && cells.shape.ny % 2 == 0;
    z = halved(z, threads);
    cells = halved(cells);
  }
  const double first = slopes[0] - slopes[1], second = slopes[1] - slopes[2];
  if (!(first > round_off * slopes[0] && slopes[0] > left_of_form * with_form)) return {0};
  return {second > 0 ? first / second : std::numeric_limits<double>::infinity()};
}

}  // namespace asperity
