/// Sdq and Sdr of ISO 25178-2: the rms slope and the developed interfacial area ratio of a surface.
///
/// A cell of the corners z(i,j), z(i+1,j), z(i,j+1), z(i+1,j+1) has sides of the slopes a = Δz/Δx at j and a'
/// at j+1, b = Δz/Δy at i and b' at i+1. On a periodic grid the last points are neighbours of the first ones.
///     Sdq = √(mean a² + mean b²)                      over all sides in x, and all in y               (1)
/// Sdr uses the four triangles between the sides and the middle of the cell, at the mean height of its
/// corners. A triangle on a side in x has the gradient (a, (b+b')/2), on a side in y ((a+a')/2, b):
///     Sdr = mean over cells of ¼ Σ_triangles √(1 + |∇z|²) - 1.                                         (2)
/// Unlike a cell cut along a diagonal, this does not change when the surface is turned over or transposed.
/// Sides and cells with a missing corner are left out, together with their plan area.
///
/// Accuracy  (1), (2) are exact for a plane. For a wave of wave number q along an axis, (1) is the slope
///           times sin(qh/2)/(qh/2): error -(qh)²/24; (2) is low by h²/24 mean[z''²/(1 + z'²)^{3/2}], because
///           chords replace arcs. Both depend on the spacing: a surface that is rough at all scales has no
///           limit. Sdr of small slopes keeps its digits, because √(1+g²) - 1 is computed as g²/(1 +
///           √(1+g²)).
/// Cost      one pass each, four roots per cell for (2).
///
/// The rms slope of the surface between the points, as its own band limit has it (transform/refinement.hpp),
/// is that of its waves. Along an axis that repeats, and continues at its seam (seam.hpp), by Parseval,
///     s² = mean over lines of Σ_k q_k² |z^_k|²,   q_k = 2πk/L,                                        (3)
/// half of the wave of two points, which is there as its cosine. Along another axis it is s² of (1), low by
/// the waves that h cuts short; with s²(2h) of sides of two steps, 0.62 (s² - s²(2h)) is more than that for
/// waves of three points and more. The half steps before the first point and behind the last are left out:
/// an n-th of what the sides beside them differ from the mean.
#pragma once

#include <cmath>

#include "stats/hybrid/neighbours.hpp"

namespace asperity {

struct SlopeParameters {
  double sdq = NAN;  ///< [m/m]
  double sdr = NAN;  ///< share of the plan area
};

struct RmsSlope {
  double value = NAN;
  double error = NAN;  ///< by the spacing, of a surface that the grid resolves (slope_growth.hpp)
};

/// By (3), or (1) with its error, of heights without missing points. NaN of one point along a free axis.
RmsSlope rms_slope(const Field& heights, const Grid& grid);

/// The sums of a field.
class SlopeSums {
 public:
  void add(const Strip& strip, int threads = 1);
  /// Throws DataError("heights", …) without a cell of 2 × 2 measured points.
  SlopeParameters parameters(const Grid& grid) const;

 private:
  RowSums<3> sums_{};
};

}  // namespace asperity
