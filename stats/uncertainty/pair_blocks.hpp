/// Sums over the pairs of points of a field, block by block, at all lags up to (P, Q).
///
///     Σ z z',   Σ ½(z² + z'²),   Σ 1     over the pairs whose first point lies in a block.             (1)
/// A pair counts where both of its points are measured; along a periodic axis every point has a partner. The
/// products are a correlation of the block and its surroundings by the FFT, piece by piece where the lags are
/// short.
///
/// Accuracy  round-off. Cost: nearly all of that of stats/uncertainty/lag_waves.hpp, which needs them.
#pragma once

#include <utility>
#include <vector>

#include "core/extent.hpp"
#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"
#include "stats/uncertainty/long_waves.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// (1) at lags of the whole plane: row P + p, column Q + q.
struct PairSums {
  Field products, squares, pairs;

  void add(PairSums&& other) {
    if (products.size() == 0) return void(*this = std::move(other));
    products += other.products, squares += other.squares, pairs += other.pairs;
  }
};

class PairBlocks {
 public:
  /// The field is the caller's, and stays.
  PairBlocks(const Field& d, const Grid& grid, Shape max_lag, Index along_x, Index along_y);

  bool complete() const { return complete_; }
  Index count() const { return along_x_ * along_y_; }
  /// (1) of some blocks, by a thread each.
  std::vector<PairSums> sums(Extent some, int threads) const;
  /// The waves at the middles of a block's pairs, a row a lag.
  AxisProducts waves(Index b, const std::vector<LongWaves::Wave>& all) const;
  /// The measured points of each block in a row of blocks.
  Eigen::VectorXd points(Index row) const;

 private:
  // Points first ≤ i < last along an axis.
  struct Range {
    Index first, last;

    Index length() const { return last - first; }
  };
  struct Spectrum;

  Index x_of(Index b) const { return b / along_y_; }
  Index y_of(Index b) const { return b % along_y_; }
  static Range block(Index b, Index blocks, Index n);
  static Index largest(Index blocks, Index n);
  static Range partnered(Range x, Index lag, Index n, bool periodic);
  template <class Value>
  Field surroundings(Range x, Range y, Value value) const;
  PairSums sums(Range x, Range y) const;
  AlignedVector<Complex> transformed(const Field& f) const;
  Field correlated(const Spectrum& f, const Spectrum& g) const;
  void squares_of_rectangles(const Field& far, Range x, Range y, PairSums& out) const;

  const Field& d_;
  Grid grid_;
  Shape max_lag_;
  Index along_x_, along_y_;
  bool complete_;
  Shape piece_, torus_;
  RealTransform2D transform_;
};

}  // namespace asperity
