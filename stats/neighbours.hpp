/// Means over neighbouring points of a field, row by row.
///
/// On a periodic grid every point has all neighbours: a row continues with its first points, the last row
/// with the first one. Otherwise only points that have them are visited. Sums are taken a row at a time and
/// the rows' sums added up in order: a result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "grid/field.hpp"
#include "grid/parallel.hpp"

namespace asperity {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

/// Rows of a field, with `margin` points more at the end where the field repeats itself.
class NeighbourRows {
 public:
  NeighbourRows(const Field& z, const Grid& grid, Index margin)
      : z_(z), margin_(grid.periodic ? margin : 0), reach_(margin) {}

  /// How many rows have `margin` more behind them, and how many points of a row.
  Index rows() const { return std::max<Index>(0, z_.rows() + margin_ - reach_); }
  Index columns() const { return std::max<Index>(0, z_.cols() + margin_ - reach_); }
  /// Row i, 0 ≤ i < rows() + margin, of columns() + margin points.
  Row operator()(Index i) const {
    Row out(z_.cols() + margin_);
    out.head(z_.cols()) = z_.row(i % z_.rows());
    for (Index j = 0; j < margin_; ++j) out(z_.cols() + j) = z_(i % z_.rows(), j % z_.cols());
    return out;
  }

 private:
  const Field& z_;
  Index margin_, reach_;
};

template <std::size_t K>
using RowSums = std::array<double, K>;

/// Σ_i sum(i) over `rows` rows, each of K sums along row i.
template <std::size_t K, class Sum>
RowSums<K> sum_over_rows(Index rows, int threads, Sum sum) {
  std::vector<RowSums<K>> of_rows(static_cast<std::size_t>(rows));
  parallel_ranges(rows, threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) of_rows[static_cast<std::size_t>(i)] = sum(i);
  });
  RowSums<K> total{};
  for (const RowSums<K>& row : of_rows)
    for (std::size_t k = 0; k < K; ++k) total[k] += row[k];
  return total;
}

}  // namespace asperity
