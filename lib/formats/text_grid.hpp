/// The grid line spacing behind printed coordinates.
///
/// A coordinate that is printed with a last digit of size u is off by u/2 at most. Points x_k of a grid
/// first + k·step, with first and step from the ends of the range, therefore agree with it within
///     |x_k - first - k·step| <= (u_k + max(u_first, u_last))/2 + ρ                                     (1)
/// where ρ is the rounding of a binary number: 8ε of the largest coordinate, or 2^-22 of it if all are
/// numbers in single precision, as printed. The last digit is the finest among the coordinates, for
/// numbers with fixed decimals and for those with fixed significant digits alike. (1) must hold within a
/// quarter of the step; or else some first and step must hold for all points of a grid without gaps within
///     |x_k - first - k·step| <= u_k/2 + ρ ,                                                            (2)
/// of which those with the most room to spare are taken.
///
/// Grid lines may be missing, up to half of them: the step is then the smallest distance. Digits that are
/// too coarse, such as 2.5 of them a step, fit a grid with missing lines as well as one without. If eight
/// or more would be missing, none is: (2) held for 18 of 20 000 random choices of 8 missing ones among 20,
/// for none of 20 000 among 30 or 60. A single one is missing if there are twenty lines or more: the
/// spacing then changes by less than a twentieth. What lies between is ambiguous, unless (2) holds by ties
/// of rounding alone: then lines are missing. Coordinates that fit no grid are compared again with those
/// joined that differ by one digit.
///
/// Cost      n log n for n coordinates.
#pragma once

#include <cmath>
#include <optional>

#include "core/field.hpp"

namespace asperity {

using Column = Eigen::ArrayXd;

/// Coordinates of a grid along one axis.
struct GridAxis {
  double first = 0, step = 0;
  Index count = 1;

  Index place(double x) const { return count > 1 ? std::llround((x - first) / step) : 0; }
};

/// Nothing if the coordinates fit no grid, or two.
std::optional<GridAxis> axis_of(const Column& coordinates);
/// Throws DataError("map", …) naming the coordinate that is off, or both grids.
GridAxis require_axis(const Column& coordinates, char name);

}  // namespace asperity
