/// Convolution of a field with a kernel that is even in both indices.
///
///     out(i,j) = Σ_{i',j'} K(|i-i'|, |j-j'|) in(i',j'),                                          (1)
///
/// linear on an nx × ny field by padding to a torus Px × Py, Px ≥ 2nx - 1, Py ≥ 2ny - 1, or circular when the
/// torus is the field itself. K's spectrum, the symbol, is real and even: a quarter of it is stored.
///
/// Accuracy  ε log2(Px Py) of max|K| Σ|in|, round-off only; in single precision numbers count in the largest
///           coefficient and value, so that no scale leaves its range.
/// Cost      one pruned transform there and back (transform/pruned.hpp); in single precision half, from 512²
///           on.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "core/field.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// The smallest fast torus on which the convolution of an nx × ny field does not wrap around.
Shape padded_torus(Shape field);

/// The symbol of an even kernel on a torus of even sides: `kernel(i, j)` is called for 0 ≤ i ≤ Px/2, 0 ≤ j ≤
/// Py/2, by several threads at once. Returns (Px/2+1) × (Py/2+1) real values K^(kx, ky); on several ranks its
/// symbol_columns.
Field even_transfer_function(Shape torus, const std::function<double(Index, Index)>& kernel, int threads = 1,
                             const Ranks& ranks = alone());

/// The ky of the blocks that a rank works on.
Extent symbol_columns(Shape torus, const Ranks& ranks, int rank);
inline Extent symbol_columns(Shape torus, const Ranks& ranks) {
  return symbol_columns(torus, ranks, ranks.rank());
}

/// Memory that convolutions use in turn.
using WorkSpace = std::shared_ptr<AlignedVector<std::byte>>;
/// At least so many bytes of it, not initialised.
std::byte* room_in(const WorkSpace& work, std::size_t bytes);

template <class Real>
class BasicEvenConvolution {
 public:
  /// `symbol` as even_transfer_function returns it, for this torus and these ranks. Convolutions that never
  /// work at the same time may share a work space, which is grown to what the largest needs.
  BasicEvenConvolution(Shape field, Shape torus, const Field& symbol, int threads = 1, WorkSpace work = {},
                       const Ranks& ranks = alone());
  /// The same convolution in another precision.
  template <class Other>
  explicit BasicEvenConvolution(const BasicEvenConvolution<Other>& other);

  Shape shape() const { return transform_.field(); }
  /// (1); `out` may be `in`. Not for two threads at once on one work space.
  void apply(const Field& in, Field& out);

 private:
  template <class Other>
  friend class BasicEvenConvolution;
  using Number = std::complex<Real>;

  void multiply(Index b, Number* block) const;
  std::span<Number> half_spectrum() const;

  BasicPrunedTransform<Real> transform_;
  double unit_;                 ///< of the symbol: all of it is at most 1 in single precision
  AlignedVector<Real> symbol_;  ///< [column of own blocks][kx ≤ Px/2], divided by unit_ Px Py
  WorkSpace work_;
  int threads_;
};
using EvenConvolution = BasicEvenConvolution<double>;

}  // namespace asperity
