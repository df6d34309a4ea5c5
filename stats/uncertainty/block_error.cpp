#include "stats/uncertainty/block_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double fewest_blocks = 10;

// The rectangle that holds the counted cells.
struct Extent {
  Index first_row, rows, first_column, columns;

  explicit Extent(const Field& z) {
    const Eigen::ArrayXX<bool> counted = !z.isNaN();
    auto ends = [](const auto& any, Index& first, Index& length) {
      Index last = any.size();
      for (first = 0; first < last && !any(first);) ++first;
      while (last > first && !any(last - 1)) --last;
      length = last - first;
    };
    ends(Eigen::ArrayX<bool>(counted.rowwise().any()), first_row, rows);
    ends(Eigen::ArrayX<bool>(counted.colwise().any()), first_column, columns);
  }
};

// Row b: the counted cells of block b between the edges, and below them.
struct BlockCounts {
  Field within, below;

  BlockCounts(const Field& z, const std::vector<double>& edges, const Extent& e, Index sides) {
    const Index across = std::min(sides, e.rows), along = std::min(sides, e.columns);
    within = Field::Zero(across * along, static_cast<Index>(edges.size()) + 1);
    for (Index i = 0; i < e.rows; ++i)
      for (Index j = 0; j < e.columns; ++j) {
        const double value = z(e.first_row + i, e.first_column + j);
        if (std::isnan(value)) continue;
        const Index bin = std::ranges::upper_bound(edges, value) - edges.begin();
        within(i * across / e.rows * along + j * along / e.columns, bin) += 1;
      }
    below = within;
    for (Index k = 1; k < below.cols(); ++k) below.col(k) += below.col(k - 1);
  }

  bool enough() const { return static_cast<double>((in_block() > 0).count()) >= fewest_blocks; }
  Eigen::ArrayXd in_block() const { return below.col(below.cols() - 1); }

  // √(1) of a column.
  std::vector<double> errors(const Field& counts) const {
    const Eigen::ArrayXd n = in_block();
    const double blocks = static_cast<double>(n.size());
    std::vector<double> out;
    for (Index k = 0; k < counts.cols(); ++k) {
      const double share = counts.col(k).sum() / n.sum();
      out.push_back(std::sqrt(blocks / (blocks - 1) * (counts.col(k) - share * n).square().sum()) / n.sum());
    }
    return out;
  }
};

void take_larger(std::vector<double>& errors, const std::vector<double>& others) {
  for (std::size_t k = 0; k < errors.size(); ++k) errors[k] = std::fmax(errors[k], others[k]);
}

}  // namespace

ShareErrors share_errors(const Field& z, const std::vector<double>& edges) {
  const Extent extent(z);
  ShareErrors out{std::vector<double>(edges.size() + 1, unknown),
                  std::vector<double>(edges.size() + 1, unknown)};
  if (extent.rows > 0)
    for (const Index sides : {8, 4}) {
      const BlockCounts counts(z, edges, extent, sides);
      if (!counts.enough()) continue;
      take_larger(out.within, counts.errors(counts.within));
      take_larger(out.below, counts.errors(counts.below));
    }
  out.below.pop_back();
  return out;
}

}  // namespace asperity
