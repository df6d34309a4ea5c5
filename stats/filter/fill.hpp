/// Fills the missing points of a field.
///
/// `laplace` makes each missing value the mean of its neighbours, weighted by 1/Δx² and 1/Δy²: the membrane
///     (z(i+1,j) - 2z + z(i-1,j))/Δx² + (z(i,j+1) - 2z + z(i,j-1))/Δy² = 0                           (1)
/// spanned over each hole, across the seam of a periodic axis, with zero slope across other edges of the
/// field. Its values lie between the smallest and the largest value around the hole. Filled values are not
/// measurements.
///
/// Accuracy  of (1) round-off of a sparse Cholesky factorisation, ε times the square of the widest hole in
///           points.
/// Cost      n missing points in the plane: n^1.5 operations, n log n memory.
#pragma once

#include "core/field.hpp"

namespace asperity {

enum class Filling { laplace, mean, least };

/// Throws DataError("heights", …) when every point is missing.
Field filled(Field z, const Grid& grid, Filling filling);

}  // namespace asperity
