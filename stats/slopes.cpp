#include "stats/slopes.hpp"

#include <cmath>

#include "grid/error.hpp"
#include "stats/neighbours.hpp"

namespace asperity {
namespace {

// Σ [√(1 + g²) - 1].
template <class SquaredSlopes>
double excess(const SquaredSlopes& g2) {
  return (g2 / (1 + (1 + g2).sqrt())).sum();
}

// The four triangles of each cell between two rows, (2) without the mean.
double excess_of_triangles(const Row& upper, const Row& lower, const Grid& grid) {
  const Index cells = upper.size() - 1;
  const Row a = (lower - upper) / grid.dx;
  const Row b = (upper.tail(cells) - upper.head(cells)) / grid.dy;
  const Row b_lower = (lower.tail(cells) - lower.head(cells)) / grid.dy;
  const Row a_middle = (0.5 * (a.head(cells) + a.tail(cells))).square(),
            b_middle = (0.5 * (b + b_lower)).square();
  return 0.25 * (excess(a.head(cells).square() + b_middle) + excess(a.tail(cells).square() + b_middle) +
                 excess(a_middle + b.square()) + excess(a_middle + b_lower.square()));
}

}  // namespace

SlopeParameters slope_parameters(const Field& z, const Grid& grid, int threads) {
  const NeighbourRows rows(z, grid, 1);
  const Index sides_x = rows.rows(), sides_y = rows.columns(), ny = z.cols();
  if (sides_x < 1 || sides_y < 1) throw DataError("heights", "slopes need 2 x 2 points");
  const auto sums = sum_over_rows<3>(z.rows(), threads, [&](Index i) {
    const Row row = rows(i);
    RowSums<3> of_row{0, (row.segment(1, sides_y) - row.head(sides_y)).square().sum(), 0};
    if (i < sides_x) {
      const Row next = rows(i + 1);
      of_row[0] = (next - row).head(ny).square().sum();
      of_row[2] = excess_of_triangles(row, next, grid);
    }
    return of_row;
  });
  auto mean = [](double sum, Index n, Index m) { return sum / static_cast<double>(n * m); };
  return {.sdq = std::sqrt(mean(sums[0], sides_x, ny) / (grid.dx * grid.dx) +
                           mean(sums[1], z.rows(), sides_y) / (grid.dy * grid.dy)),
          .sdr = mean(sums[2], sides_x, sides_y)};
}

}  // namespace asperity
