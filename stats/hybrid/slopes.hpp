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
/// A contact feels the slope of the surface between the points (rms_slope), as its own band limit has it
/// (transform/refinement.hpp): that of its waves. Along an axis that repeats, and continues at its seam, by
/// Parseval,
///     s² = mean over lines of Σ_k q_k² |z^_k|²,   q_k = 2πk/L,                                        (3)
/// half of the wave of two points, which is there as its cosine. Along another axis it is s² of (1), low by
/// the waves that h cuts short; with s²(2h) of sides of two steps, 0.62 (s² - s²(2h)) is more than that for
/// waves of three points and more. The half steps before the first point and after the last are left out: an
/// n-th of what the neighbouring sides differ from the mean.
///
/// Seam. With d(i) the rms step from line i to the next, over the points of a line, and d(N-1) that from the
/// last line to the first, a surface that is marked periodic jumps at its seam where
///     d(N-1) > 2 max d(i),   0 ≤ i < N-1.                                                            (4)
/// A surface of the period has no first line: its seam is one of N steps like the others, whatever its
/// texture, lay or spikes. A trend or a part of a larger surface has a step that no other comes near; so has
/// one tooth of a saw a period. Noise of one point a line, the worst case, is taken for a jump in 1 of 1000
/// at 16 lines, and less often on more; fewer lines are not judged.
///
/// Growth. Does the grid resolve the surface? On means of 2 × 2 and of 4 × 4 points,
///     γ = (s²(n) - s²(n/2)) / (s²(n/2) - s²(n/4)).                                                   (5)
/// Where finer points show little that is new, s² converges and γ is small: γ → ¼ for smooth surfaces, and
/// 2^(2-2H) for a self-affine one without a short-wave cut-off. From γ = 1 on the slope grows without end:
/// the contact of such a surface depends on its grid at any spacing. Seen: shortest wave of 16 cells 0 to
/// 0.3, 8 cells 0.3 to 0.4, 4 cells 0.5 to 0.8, 3 cells 0.9 to 1.4, 2 cells 1.4 to 1.6; Gaussian ACF 0.3 to
/// 0.5, Matérn with ν = 2 0.6, exponential 3.9 to 4.7, self-affine with H = 0.8 2.1. A form of degree 2 is
/// removed first, except from a surface that is periodic along both axes; an odd last line is left out.
#pragma once

#include <array>
#include <cmath>

#include "core/field.hpp"

namespace asperity {

struct SlopeParameters {
  double sdq = NAN;  ///< [m/m]
  double sdr = NAN;  ///< share of the plan area
  double cells = 0;  ///< with all corners
};

/// Throws DataError("heights", …) without a cell of 2 × 2 measured points.
SlopeParameters slope_parameters(const Field& z, const Grid& grid, int threads = 1);

struct RmsSlope {
  double value = NAN;
  double error = NAN;  ///< by the spacing, of a surface that the grid resolves
};

/// By (3), or (1) with its error, of heights without missing points. NaN of one point along a free axis.
RmsSlope rms_slope(const Field& heights, const Grid& grid);

struct Seam {
  double step = 0, largest = 0;  ///< d(N-1), and the largest of the others, in the unit of the heights
  bool jumps() const { return step > 2 * largest; }
};

/// Across x and across y; zeros along an axis that is free or has fewer than 16 lines.
std::array<Seam, 2> seams(const Field& heights, Periodic periodic);

/// Whether a contact on this grid is one of the surface.
enum class Resolved { yes, doubtful, no };

struct SlopeGrowth {
  double gamma = 0;  ///< (5); NaN below 16 points a side
  /// yes below 0.8 and where γ is not known, no from 1 on.
  Resolved resolved() const;
};

/// Of heights without missing points [m]. 0 where the slope does not change: a plane, a constant.
SlopeGrowth slope_growth(Field heights, const Grid& grid, int threads = 1);

}  // namespace asperity
