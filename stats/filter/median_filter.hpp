/// The median of a window about each point, and points that lie far from it.
///
/// The window has a × b points, both odd, and ends at the edges of the field, but not at a seam of a periodic
/// axis. Of an even number of points the median is the mean of the middle two.
///
/// A point is an outlier if it lies further from the median of its window than k robust standard deviations,
///     |z - m| > k s,   s = 1.4826 median |z - m| over the whole field,                               (1)
/// which of Gaussian differences z - m is their standard deviation. Outliers become missing; filling them is
/// another step.
///
/// Missing   Points that are missing do not count, and stay missing.
/// Accuracy  exact: medians are heights, or the mean of two.
/// Cost      sorting the field, and 2a changes of a set of ranks a point.
///
/// D. C. Hoaglin, F. Mosteller, J. W. Tukey, Understanding robust and exploratory data analysis (1983).
#pragma once

#include "core/field.hpp"

namespace asperity {

/// The points of a window of this width [m] along both axes: 2 floor(width/2Δ) + 1, at most those of the
/// field. Throws ParameterError("median") unless at least 3 points along one axis.
Shape median_window(const Grid& grid, double width);

/// Throws ParameterError("median") unless both sides of the window are odd and above zero.
Field median_surface(const Field& z, const Grid& grid, Shape window, int threads = 1);

struct WithoutOutliers {
  Field heights;         ///< outliers missing
  Index removed = 0;     ///< how many
  double deviation = 0;  ///< s [m]
  double furthest = 0;   ///< the largest |z - m| of what was removed [m]
};

/// (1). Throws ParameterError("outliers") unless 0 < k < ∞, and DataError("heights") if s = 0 while some
/// points differ from their medians: more than half of them are equal to theirs.
WithoutOutliers without_outliers(const Field& z, const Grid& grid, Shape window, double k, int threads = 1);

}  // namespace asperity
