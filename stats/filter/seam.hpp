/// The seam of an axis that is said to be periodic, and how to close it.
///
/// Where an axis becomes periodic its last point has the first as its neighbour. Their difference
///     J(j) = z(0,j) - z(nx-1,j)                                                                      (1)
/// is a jump, to be compared with the steps z(i+1,j) - z(i,j) between neighbours inside. Two ways to
/// a smaller one:
///     tilt    z(i,j) + i mean(J)/(nx-1): the mean jump and the mean step become zero, nothing else changes;
///     taper   m + (z - m) f,  f = (1 - cos(π s/ℓ))/2  at a distance s < ℓ from the nearer end, where s is
///             (i + ½)Δ, otherwise 1; m the mean of the field: the roughness fades out, and within ℓ of the
///             ends the mean of f² is 3/8.
/// Missing   Pairs with a missing point do not count; missing points stay missing.
/// Cost      a pass.
#pragma once

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"

namespace asperity {

struct SeamJump {
  double mean = 0, rms = 0, largest = 0;  ///< of J, the largest in size [m]
  double step_rms = 0;                    ///< of the steps inside [m]
  Index pairs = 0;                        ///< values of J
};

/// Throws DataError("heights", …) for an axis of fewer than three points or without a pair.
SeamJump seam_jump(const Field& z, Axis1D axis);

/// The tilt that closes the mean jump.
Field closed_by_tilt(const Field& z, Axis1D axis);

/// The taper. Throws ParameterError("taper") unless Δ ≤ ℓ ≤ half the axis.
Field closed_by_taper(const Field& z, const Grid& grid, Axis1D axis, double length);

}  // namespace asperity
