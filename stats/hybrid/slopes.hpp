/// Sdq and Sdr of ISO 25178-2: the rms slope of a surface and the area it has beyond its plan.
///
/// A cell is a square of four neighbouring points with the corners z(i,j), z(i+1,j), z(i,j+1), z(i+1,j+1);
/// its sides have the slopes a = Δz/Δx at j and a' at j+1, b = Δz/Δy at i and b' at i+1. On a periodic grid
/// the last points are neighbours of the first ones.
///     Sdq = √(mean a² + mean b²)                      over all sides in x, and all in y               (1)
/// Sdr is that of the four triangles which join the sides to the middle of the cell, at the mean height of
/// the corners. A triangle on a side in x has the gradient (a, (b+b')/2), on one in y ((a+a')/2, b):
///     Sdr = mean over cells of ¼ Σ_triangles √(1 + |∇z|²) - 1.                                         (2)
/// Unlike a cell cut in two along a diagonal, this does not change when the surface is turned over or
/// transposed. Sides and cells with a missing corner do not count (stats/filter/missing.hpp): neither their slopes and areas,
/// nor their plan.
///
/// Accuracy  (1), (2) are exact for a plane. Of a wave of wave number q along an axis (1) is
///           sin(qh/2)/(qh/2) times the slope: error -(qh)²/24; (2) falls short by
///           h²/24 mean[z''²/(1 + z'²)^{3/2}], the length of chords less that of arcs. Both depend on the
///           spacing as the surface itself does: of a surface that is rough at all scales they have no limit.
///           Sdr of small slopes keeps its digits: √(1+g²) - 1 is g²/(1 + √(1+g²)).
/// Cost      one pass each, four roots a cell for (2).
#pragma once

#include "core/field.hpp"
#include "stats/hybrid/neighbours.hpp"

namespace asperity {

struct SlopeParameters {
  double sdq = 0;  ///< [m/m]
  double sdr = 0;  ///< share of the plan area
};

/// The sums of a field that comes in strips.
class SlopeSums {
 public:
  void add(const Strip& strip, int threads = 1);
  /// Throws DataError("heights", …) without a cell of 2 × 2 points that are there.
  SlopeParameters parameters(const Grid& grid) const;

 private:
  RowSums<3> sums_{};
};

}  // namespace asperity
