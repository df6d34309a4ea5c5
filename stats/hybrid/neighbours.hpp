/// Means over neighbouring points of a field, row by row.
///
/// On a periodic grid every point has all neighbours; otherwise only points that have them are visited. Sums
/// of rows are added up in order, so that results do not depend on the number of threads. A side,
/// cell or stencil with a missing height is NaN and left out of the sum and of the divisor.
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

/// A field and its grid. On a periodic one the first rows follow the last one.
struct Strip {
  const Field& z;
  Grid grid;

  static Strip whole(const Field& z, const Grid& grid) { return {z, grid}; }
  /// Points of the field's shorter side; unlimited if it is periodic.
  Index shortest_side() const {
    return grid.periodic.both() ? std::numeric_limits<Index>::max() : std::min(grid.shape.nx, grid.shape.ny);
  }
};

/// Rows of a field, with `margin` more points at the end if it is periodic.
class NeighbourRows {
 public:
  NeighbourRows(const Strip& strip, Index margin)
      : z_(strip.z),
        rows_(z_.rows() - (strip.grid.periodic.both() ? 0 : margin)),
        columns_(z_.cols() - (strip.grid.periodic.both() ? 0 : margin)),
        margin_(strip.grid.periodic.both() ? margin : 0) {}

  /// The number of rows followed by `margin` more, and of points in a row.
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

/// Sums and numbers of the entries that are not NaN.
template <std::size_t K>
using RowSums = std::array<ValidSum, K>;

inline double mean_of(const ValidSum& sum) { return sum.sum / sum.count; }

/// Adds Σ_i sum(i) over `rows` rows to the total; sum(i) is K sums along row i.
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
