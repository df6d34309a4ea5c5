/// Cosine and sine transforms of eight real sequences at a time.
///
/// A real sequence x_j that is even about 0 and has period n has a real spectrum; one that is odd has an
/// imaginary one. With ±x_j standing for x_{-j},
///     even   X_k = Σ_j x_j cos(2πjk/n),         odd   X_k = Σ_j x_j sin(2πjk/n),     j = 0 … n-1.      (1)
/// Two such sequences are the real and imaginary part of a complex one, and come back apart without
/// arithmetic.
///
/// Cost: half of the complex transforms of the eight sequences; FFTW's cosine transforms of the first kind
/// take several times as long. Accuracy: ε log2 n of Σ|x|.
#pragma once

#include "core/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

enum class Parity { even, odd };

class MirroredTransform {
 public:
  static constexpr Index width = 8;          ///< sequences
  static constexpr Index pairs = width / 2;  ///< complex columns: sequences 2c and 2c+1

  /// The period is even.
  explicit MirroredTransform(Index period) : columns_(period, pairs, Ways::forward_only) {}

  Index period() const { return columns_.points(); }
  Index stride() const { return columns_.stride(); }
  Index size() const { return columns_.size(); }
  /// x[c][j] for 0 ≤ j < given ≤ n/2 + 1, zero further on, becomes X[c][k] for 0 ≤ k < n (0 ≤ k ≤ n/2 of odd
  /// sequences, the others are scratch). Columns are stride() apart; `x`, whose other rows are filled in, and
  /// `out` are aligned and have size() points. x[c][0] and x[c][n/2] of odd sequences must be zero.
  void apply(Parity parity, Complex* x, Index given, Complex* out) const;

 private:
  ColumnTransform columns_;
};

}  // namespace asperity
