/// Convolution of a field with a kernel that is even in both indices.
///
///     out(i,j) = Σ_{i',j'} K(|i-i'|, |j-j'|) in(i',j'),                                          (1)
///
/// linear on an nx × ny field by padding to a torus Px × Py, Px ≥ 2nx - 1, Py ≥ 2ny - 1, or circular when the
/// torus is the field itself. K's spectrum, the symbol, is real and even: a quarter of it is stored.
///
/// Accuracy  ε log2(Px Py) of max|K| Σ|in|, round-off only.
/// Cost      one pruned transform there and back (transform/pruned.hpp).
#pragma once

#include <functional>
#include <memory>

#include "core/field.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// The smallest fast torus on which the convolution of an nx × ny field does not wrap around.
Shape padded_torus(Shape field);

/// The symbol of an even kernel on a torus of even sides: `kernel(i, j)` is called for 0 ≤ i ≤ Px/2, 0 ≤ j ≤
/// Py/2, by several threads at once. Returns (Px/2+1) × (Py/2+1) real values K^(kx, ky).
Field even_transfer_function(Shape torus, const std::function<double(Index, Index)>& kernel, int threads = 1);

class EvenConvolution {
 public:
  /// `symbol` as even_transfer_function returns it, for this torus. Convolutions that never work at the same
  /// time may share a work space, which is grown to what the largest needs.
  EvenConvolution(Shape field, Shape torus, const Field& symbol, int threads = 1,
                  std::shared_ptr<HalfSpectrum> work = nullptr);

  Shape shape() const { return transform_.field(); }
  /// (1); `out` may be `in`. Not for two threads at once on one work space.
  void apply(const Field& in, Field& out);

 private:
  void multiply(Index b, Complex* block) const;

  PrunedTransform transform_;
  AlignedVector<double> symbol_;  ///< [column][kx ≤ Px/2], divided by Px Py
  std::shared_ptr<HalfSpectrum> half_;
  int threads_;
};

}  // namespace asperity
