/// A field on a finer grid, through the same points, by its own band limit.
///
/// Along a periodic axis of n points a field is the trigonometric polynomial of its waves |k| ≤ n/2,
///     z(x) = 1/n Σ_k z^(k) exp(2πi k x/n),   x in points,                                               (1)
/// the highest of an even n as its cosine, so that z is real and no direction is preferred. Along another
/// axis it is a form of degree 2 and the waves of what is left, mirrored at half a point before the first and
/// after the last: (1) of 2n points. A cells in place of each have their centres at
///     x_m = (m + ½)/A - ½,   m = 0 … nA - 1,                                                          (2)
/// so that the domain keeps its place and its size. Of an odd A every A-th from (A-1)/2 is one of the field's
/// own points. What has waves of less than two points, or steps, rings as (1) does. Values of any other
/// spacing about the same middle are (1) at their places; waves of less than two of them are left out, so
/// that none is taken for a longer one.
///
/// Accuracy  ε log2(2 n A) max|z|; the waves of (1) exactly, and forms of degree 2 on a free axis. Waves of a
///           free axis have an error near its ends, where the mirror bends them: of one of amplitude a and
///           wave number q about a qΔx/10 within a point or two, and less as 1/distance² inside.
/// Cost      a transform there and one back of each row and column, of 2n points on a free axis: 0.1 s for
///           1024² from 256² or so; three times that for values that do not fill the axis
///           (ChirpTransform). Memory: the fine field and one of nx × nyB.
///
/// J. P. Boyd, Chebyshev and Fourier spectral methods, 2nd ed., Dover (2001), chapters 4 and 11.
#pragma once

#include "core/field.hpp"
#include "transform/plan.hpp"

namespace asperity {

/// The grid of (2) for A × B values a point.
Grid refined_grid(const Grid& grid, Shape factor);

/// Bytes that `refined` takes, the given field apart.
double refinement_memory(const Grid& grid, Shape factor);

/// (2), on refined_grid; `field` has the grid's shape. Throws ParameterError("refine") for a factor below 1,
/// DataError("heights") for values that are not finite.
Field refined(const Field& field, const Grid& grid, Shape factor, int threads = 1);

/// (1) at the centres of the target's cells, which has the same middle. Throws as `refined` does.
Field resampled_onto(const Field& field, const Grid& grid, const Grid& target, int threads = 1);

/// Sums of waves at equidistant points of any spacing.
///
///     y_m = Σ_{k<K} c_k exp(iθkm),   m = 0 … M-1,                                                       (1)
/// for any θ: with km = (k² + m² - (m-k)²)/2 a convolution with the chirp exp(-iθ m²/2), of K + M - 1 points.
///
/// Accuracy  ε (log2(K+M) + θ max(K,M)²/4π) of Σ|c|: the chirp's phase is rounded.
/// Cost      one transform there and one back of K + M points.
///
/// L. I. Bluestein, IEEE Trans. Audio Electroacoust. 18 (1970) 451-455.
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
