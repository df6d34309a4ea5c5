#include "stats/hybrid/slopes.hpp"

#include "core/error.hpp"

namespace asperity {
namespace {

// Σ [√(1 + g²) - 1].
template <class SquaredSlopes>
ValidSum excess(const SquaredSlopes& g2) {
  return sum_of_valid(g2 / (1 + (1 + g2).sqrt()));
}

// (2) of the cells between two rows, without the mean. Each triangle sees all corners of its cell.
ValidSum excess_of_triangles(const Row& upper, const Row& lower, const Grid& grid) {
  const Index cells = upper.size() - 1;
  const Row a = (lower - upper) / grid.dx;
  const Row b = (upper.tail(cells) - upper.head(cells)) / grid.dy;
  const Row b_lower = (lower.tail(cells) - lower.head(cells)) / grid.dy;
  const Row a_middle = (0.5 * (a.head(cells) + a.tail(cells))).square(),
            b_middle = (0.5 * (b + b_lower)).square();
  const ValidSum first = excess(a.head(cells).square() + b_middle),
                 second = excess(a.tail(cells).square() + b_middle), third = excess(a_middle + b.square()),
                 fourth = excess(a_middle + b_lower.square());
  return {0.25 * (first.sum + second.sum + third.sum + fourth.sum), first.count};
}

}  // namespace

void SlopeSums::add(const Strip& strip, int threads) {
  if (strip.shortest_side() < 2) return;
  const NeighbourRows rows(strip, 1);
  const Index sides_y = rows.columns(), ny = strip.z.cols();
  add_rows(sums_, strip.z.rows(), threads, [&](Index i) {
    const Row row = rows(i);
    RowSums<3> of_row{};
    of_row[1] = sum_of_valid((row.segment(1, sides_y) - row.head(sides_y)).square());
    if (i < rows.rows()) {
      const Row next = rows(i + 1);
      of_row[0] = sum_of_valid((next - row).head(ny).square());
      of_row[2] = excess_of_triangles(row, next, strip.grid);
    }
    return of_row;
  });
}

SlopeParameters SlopeSums::parameters(const Grid& grid) const {
  if (!(sums_[2].count > 0)) throw DataError("heights", "slopes need 2 x 2 points, none of them missing");
  return {.sdq = std::sqrt(mean_of(sums_[0]) / (grid.dx * grid.dx) + mean_of(sums_[1]) / (grid.dy * grid.dy)),
          .sdr = mean_of(sums_[2])};
}

}  // namespace asperity
