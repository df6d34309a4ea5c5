/// Cosine and sine transforms of eight interleaved real sequences at a time.
///
/// A real sequence x_j that is even about 0 and has period n has a real spectrum; one that is odd has an
/// imaginary one. With ±x_j standing for x_{-j},
///     even   X_k = Σ_j x_j cos(2πjk/n),         odd   X_k = Σ_j x_j sin(2πjk/n),     j = 0 … n-1.      (1)
/// Two such sequences are the real and imaginary part of a complex one and come back apart without
/// arithmetic, so that eight interleaved reals are four interleaved complex numbers as they lie in memory.
///
/// Cost: half of the complex transforms of the eight sequences, all in vector registers; FFTW's own cosine
/// transforms of the first kind take several times as long. Accuracy: ε log2 n of Σ|x|.
#pragma once

#include "grid/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

enum class Parity { even, odd };

class MirroredTransform {
 public:
  static constexpr Index width = 8;  ///< sequences

  /// The period is even.
  explicit MirroredTransform(Index period)
      : complex_(period, width / 2, InterleavedTransform::Ways::forward_only) {}

  Index period() const { return complex_.points(); }
  /// x[j][8] for 0 ≤ j < given ≤ n/2 + 1, zero further on, becomes X[k][8] for 0 ≤ k < n (0 ≤ k ≤ n/2 of an
  /// odd sequence, the others are scratch). `x` is aligned and has room for n rows. Rows 0 and n/2 of an odd
  /// sequence must be zero.
  void apply(Parity parity, double* x, Index given) const;

 private:
  InterleavedTransform complex_;
};

}  // namespace asperity
