/// Scan lines put level with each other: the rows of a map that a probe measured one after the other.
///
/// Between two lines of a scanning probe the height drifts or jumps. Line j of z(i,j) = h(i,j) + o(j) loses
/// its offset, or a form of it:
///     median             the median of the line                                                       (1)
///     polynomial         Gram's polynomials up to degree k along the line; k = 0: its mean            (2)
///     median_difference  Σ_{l≤j} d(l),  d(l) = median over i of z(i,l) - z(i,l-1)                      (3)
///     jumps              the same sum of d(l) - c over the lines with |d(l) - c| > 5 s alone,          (4)
///                        c = median d,  s = 1.4826 median|d - c|: drift and surface stay.
///
/// The median of a tilted or bowed line is that of the few points around its middle: level the map first, or
/// use (2).
///
/// (1) to (3) take what the surface itself has along whole lines: stats/uncertainty/aligned_share.hpp. After
/// (4) the surface's own difference at each of the jumps is gone, s rms: with a share f of the lines behind a
/// jump, about their mean
///     rms = s √(Σ f (1 - f)),     the sum over the jumps.                                             (5)
///
/// Symbols   h  surface      o  offset of a line [m]      d  step from a line to the next [m]
/// Scope     (3) and (4) need two lines with points at the same places. A step that the surface has along a
///           whole line, as of a grating or a terrace along the lines, is a jump to them. s is at least 1/√12
///           of a step of the heights.
/// Accuracy  round-off. Of Gaussian d (4) takes 6e-7 of the lines for jumps.
/// Missing   Points that are missing do not count, and stay missing; across missing lines, c and s count once
///           for each line.
/// Cost      a pass and a median of each line; of (2) k products a point.
#pragma once

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"

namespace asperity {

struct RowAlignment {
  enum class Method { median, polynomial, median_difference, jumps };
  Method method = Method::median;
  int degree = 0;            ///< k of a polynomial
  Axis1D along = Axis1D::x;  ///< the axis of a line
  double step = 0;           ///< of the heights; 0: none [m]
};

struct AlignedRows {
  Field heights;
  Index lines = 0, jumps = 0;  ///< lines with points; how many of the steps between them jump
  double largest = 0;          ///< of the jumps, in size [m]
  double removed = 0;          ///< rms of what went, about its mean [m]
  double taken = 0;            ///< (5) [m]
};

/// Throws ParameterError("align-rows") for a periodic map, fewer than two lines with points, lines of one
/// point or of fewer than the degree needs, and neighbours without common places in (3), (4).
AlignedRows aligned_rows(const Field& z, const Grid& grid, const RowAlignment& how = {});

/// A line each row, whichever axis it is along.
inline Field lines_of(const Field& z, Axis1D along) { return along == Axis1D::x ? Field(z.transpose()) : z; }

}  // namespace asperity
