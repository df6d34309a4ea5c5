/// Sums over neighbouring points of a field, row by row.
///
/// On a periodic grid every point has all neighbours; otherwise only points that have them are visited. Sums
/// of rows are added up in order, so that results do not depend on the number of threads. A side, cell or
/// stencil with a missing height is NaN and left out of the sum and of the divisor.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/field.hpp"
#include "core/parallel.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

using Row = Eigen::Array<double, 1, Eigen::Dynamic>;

/// Rows of a field, with `margin` more points at the end if it is periodic; the first rows follow the last.
class NeighbourRows {
 public:
  NeighbourRows(const Field& z, const Grid& grid, Index margin)
      : z_(z), missing_(grid.periodic.both() ? 0 : margin), margin_(margin - missing_) {}

  /// The number of rows followed by `margin` more, and of points in a row.
  Index rows() const { return std::max<Index>(0, z_.rows() - missing_); }
  Index columns() const { return std::max<Index>(0, z_.cols() - missing_); }
  /// Row i, 0 ≤ i < rows() + margin, of columns() + margin points.
  Row operator()(Index i) const {
    Row out(z_.cols() + margin_);
    out.head(z_.cols()) = z_.row(i % z_.rows());
    for (Index j = 0; j < margin_; ++j) out(z_.cols() + j) = z_(i % z_.rows(), j % z_.cols());
    return out;
  }

 private:
  const Field& z_;
  Index missing_, margin_;  // points without all neighbours, or points to add
};

/// Sums and numbers of the entries that are not NaN.
template <std::size_t K>
using RowSums = std::array<ValidSum, K>;

inline double mean_of(const ValidSum& sum) { return sum.sum / sum.count; }

/// Σ_i sum(i) over `rows` rows; sum(i) is K sums along row i.
template <std::size_t K, class Sum>
RowSums<K> sum_rows(Index rows, int threads, Sum sum) {
  std::vector<RowSums<K>> of_rows(size(rows));
  parallel_ranges(rows, threads, [&](Index begin, Index end, int) {
    for (Index i = begin; i < end; ++i) of_rows[size(i)] = sum(i);
  });
  RowSums<K> total{};
  for (const RowSums<K>& row : of_rows)
    for (std::size_t k = 0; k < K; ++k) {
      total[k].sum += row[k].sum;
      total[k].count += row[k].count;
    }
  return total;
}

}  // namespace asperity
