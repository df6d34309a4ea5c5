/// Sums of waves at equidistant points of any spacing.
///
///     y_m = Σ_{k<K} c_k exp(iθkm),   m = 0 … M-1,                                                       (1)
/// for any θ: with km = (k² + m² - (m-k)²)/2 a convolution with the chirp exp(-iθ m²/2), of K + M - 1 points.
///
/// Accuracy  ε (log2(K+M) + θ max(K,M)²/4π) of Σ|c|: the chirp's phase is rounded.
/// Cost      one transform there and one back of K + M points.
///
/// L. I. Bluestein, IEEE Trans. Audio Electroacoust. 18 (1970) 451-455.
#pragma once

#include "transform/plan.hpp"

namespace asperity {

class ChirpTransform {
 public:
  ChirpTransform(Index terms, Index values, double theta);

  /// c, of `terms` coefficients. Not for two threads at once.
  Complex* terms() { return given_.data(); }
  /// (1) of them, which are lost.
  const Complex* apply();

 private:
  Complex chirp(Index k, double sign) const;

  Index terms_, values_;
  double theta_;
  ColumnTransform transform_;
  AlignedVector<Complex> given_, found_, symbol_, phase_;
};

}  // namespace asperity
