/// The median of a window about each point.
///
/// The window has a × b points, both odd, and ends at the edges of the field, but not at a seam of a periodic
/// axis. Of an even number of points the median is the mean of the middle two.
///
/// Missing   Points that are missing do not count, and stay missing.
/// Accuracy  exact: medians are heights, or the mean of two.
/// Cost      sorting the field, and 2a changes of a set of ranks a point.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// The points of a window of this width [m] along both axes: 2 floor(width/2Δ) + 1, at most those of the
/// field. Throws ParameterError("median") unless at least 3 points along one axis.
Shape median_window(const Grid& grid, double width);

/// Throws ParameterError("median") unless both sides of the window are odd and above zero.
Field median_surface(const Field& z, const Grid& grid, Shape window, int threads = 1);

}  // namespace asperity
