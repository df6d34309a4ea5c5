/// Points that stand out of a surface from all sides.
///
/// In each of eight directions d a point has three others on one side and three on the other, beyond what is
/// w points wide; p and q are their medians, and
///     r_d = z - (p + q)/2,   s_d = 1.4826 median|r_d| over the map,                                   (1)
/// is nearly linear in heights: whatever the correlation of a Gaussian surface, r_d/s_d is Gaussian. With
///     T = min_d |r_d|/s_d   where z lies beyond p and q by 0.75 K s_d in every d, on the same side,    (2)
/// and 0 elsewhere, an edge or a line along some direction has T = 0, up to where it leaves the map: of a
/// direction with one side alone, z must be beyond that side. Rougher places are judged by themselves: g is
/// the largest median of 1.4826 |r_d|/s_d in the tile of 16 × 16 points and its neighbours, over 1.1, or 1.
/// A point is an outlier if
///     T > K g,   or T > 0.7 K g next to an outlier.                                                    (3)
/// Outliers become missing and (1) to (3) repeat until there are none, for w = 1, 3, 7, … up to the width. In
/// the end each is judged anew against the surface without them, and what is no outlier returns.
///
/// Symbols   K  bound      w  width of what may stand out [points]      s_d  deviation [m]
/// Scope     s_d is at least 1/√12 of a step of the heights, for steps are no deviations. A side is there if
///           two of its points are; a point without both sides in any direction, as in corners, is not
///           judged. A profile has one direction.
/// Accuracy  A Gaussian surface loses some 2 (1 - Φ(K)), 6e-7 for K = 5, white heights of skewness
///           -1.5 lost 2.4e-3, correlated ones 8e-5. Of spikes of 8 and more rms heights, up to 3 × 3 points
///           on seven surfaces, periodic or not, with and without holes, at least 98 % were found.
/// Missing   Points that are missing do not count, and stay missing.
/// Cost      of a pass 24 medians of three a point and eight of the map; two passes for each w, one more for
///           each round that finds something, and a last one: 1024² points, w = 1 and 3, take 0.6 s.
#pragma once

#include <vector>

#include "core/field.hpp"

namespace asperity {

struct OutlierRule {
  double bound = 5;   ///< K
  Shape width{3, 3};  ///< the largest w, along each axis
  double step = 0;    ///< of the heights; 0: none [m]
};

struct Outliers {
  Field heights;      ///< outliers missing
  Index removed = 0;  ///< how many
  struct Scale {
    Shape width;       ///< w
    double deviation;  ///< the middle one of the s_d; NaN: no point is judged [m]
  };
  std::vector<Scale> scales = {};
  double spiky = 0;  ///< share of the heights beyond K robust deviations from their median
};

/// Throws ParameterError("outliers") unless 0 < K < ∞ and 0 < w, and where no point can be judged.
Outliers without_outliers(const Field& z, const Grid& grid, const OutlierRule& rule = {}, int threads = 1);

// ---- missing points filled ----

/// Fills the missing points of a field.
///
/// `laplace` makes each missing value the mean of its neighbours, weighted by 1/Δx² and 1/Δy²: the membrane
///     (z(i+1,j) - 2z + z(i-1,j))/Δx² + (z(i,j+1) - 2z + z(i,j-1))/Δy² = 0                           (1)
/// spanned over each hole, across the seam of a periodic axis, with zero slope across other edges of the
/// field. Its values are between the smallest and the largest value around the hole. Filled values are not
/// measurements.
///
/// Accuracy  of (1) round-off of a sparse Cholesky factorisation, ε times the square of the widest hole in
///           points.
/// Cost      n missing points in the plane: n^1.5 operations, n log n memory.

enum class Filling { laplace, mean, least };

/// Throws DataError("heights", …) when every point is missing.
Field filled(Field z, const Grid& grid, Filling filling);

}  // namespace asperity
