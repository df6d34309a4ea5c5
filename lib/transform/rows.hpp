/// Eight real rows transformed together, two as the real and imaginary part of one complex row.
///
/// For z = a + ib, of real rows a and b,
///     a^(k) = (z^(k) + conj z^(-k)) / 2,   b^(k) = (z^(k) - conj z^(-k)) / 2i,                           (1)
/// and back z^ = a^ + i b^ at k and conj a^ + i conj b^ at -k. The four complex rows are one vectorised
/// transform.
///
/// The half spectrum of n points, 0 ≤ k ≤ n/2, comes in blocks of eight k, [k/8][row][k%8], as
/// transform/pruned.hpp keeps it; beyond k = n/2 the last block is zero there, and not read back.
///
/// Cost: half of eight real transforms, and a tenth of the planning. Accuracy: ε log2 n of the larger row.
#pragma once

#include "transform/plan.hpp"

namespace asperity {

template <class Real>
class BasicRowTransform {
 public:
  static constexpr Index rows = 8, width = 8;  ///< rows at a time; k in a block
  using Number = std::complex<Real>;

  explicit BasicRowTransform(Index n, Ways ways = Ways::both) : columns_(n, rows / 2, ways) {}

  Index points() const { return columns_.points(); }
  Index blocks() const { return (points() / 2 + width) / width; }

  /// The work space of one thread.
  struct Work {
    AlignedVector<Number> points, modes;
  };
  Work work() const;

  /// Transforms the rows r < count, `given` points from in + r·apart and zeros after them, times `scale`, to
  /// blocks that are block_stride apart.
  void forward(const double* in, Index apart, Index given, Index count, Number* blocks, Index block_stride,
               Work& work, double scale = 1) const;
  /// Back, times n and `scale`: the first `wanted` points of the rows r < count, to out + r·apart.
  void inverse(const Number* blocks, Index block_stride, Index count, Index wanted, double* out, Index apart,
               Work& work, double scale = 1) const;

 private:
  BasicColumnTransform<Real> columns_;
};
using RowTransform = BasicRowTransform<double>;

}  // namespace asperity
