/// Means over neighbouring points of a field, row by row.
///
/// On a periodic grid every point has all neighbours; otherwise only points that have them are visited. Sums
/// are taken a row at a time and added up in order: results depend neither on the number of threads nor on
/// strips. A side, cell or stencil with a missing height is NaN and left out, of the mean's divisor too.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "core/field.hpp"
#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

/// Whole rows of a field: `core` of them, and behind them a halo, for their neighbours, of the next ones. On
/// a periodic grid the first rows are next to the last one; a strip of all rows needs no halo.
struct Strip {
  const Field& z;
  Grid grid;  ///< of the whole field
  Index core;

  static Strip whole(const Field& z, const Grid& grid) { return {z, grid, z.rows()}; }
  bool closed() const { return grid.periodic && z.rows() == grid.shape.nx; }
  /// Points of the field's shorter side; without end where it repeats itself.
  Index shortest_side() const {
    return grid.periodic ? std::numeric_limits<Index>::max() : std::min(grid.shape.nx, grid.shape.ny);
  }
};

/// Rows of a strip, with `margin` points more at the end where the field repeats itself.
class NeighbourRows {
 public:
  NeighbourRows(const Strip& strip, Index margin)
      : z_(strip.z),
        rows_(std::min(strip.core, z_.rows() + (strip.closed() ? margin : 0) - margin)),
        columns_(z_.cols() - (strip.grid.periodic ? 0 : margin)),
        margin_(strip.grid.periodic ? margin : 0) {}

  /// How many rows have `margin` more behind them, and how many points of a row.
  Index rows() const { return std::max<Index>(0, rows_); }
  Index columns() const { return std::max<Index>(0, columns_); }
  /// Row i, 0 ≤ i < rows() + margin, of columns() + margin points.
  Row operator()(Index i) const {
    Row out(z_.cols() + margin_);
    out.head(z_.cols()) = z_.row(i % z_.rows());
    for (Index j = 0; j < margin_; ++j) out(z_.cols() + j) = z_(i % z_.rows(), j % z_.cols());
    return out;
  }

 private:
  const Field& z_;
  Index rows_, columns_, margin_;
};

/// Sums of what is there, and how much is there.
template <std::size_t K>
using RowSums = std::array<ValidSum, K>;

inline double mean_of(const ValidSum& sum) { return sum.sum / sum.count; }

/// Adds Σ_i sum(i) over `rows` rows, each of K sums along row i, to the total.
template <std::size_t K, class Sum>
void add_rows(RowSums<K>& total, Index rows, int threads, Sum sum) {
  std::vector<RowSums<K>> of_rows(static_cast<std::size_t>(rows));
  parallel_ranges(rows, threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) of_rows[static_cast<std::size_t>(i)] = sum(i);
  });
  for (const RowSums<K>& row : of_rows)
    for (std::size_t k = 0; k < K; ++k) {
      total[k].sum += row[k].sum;
      total[k].count += row[k].count;
    }
}

}  // namespace asperity
