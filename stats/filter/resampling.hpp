/// A map on a grid of another spacing.
///
/// The heights are the waves and the form of transform/refinement.hpp, evaluated at the centres of the new
/// cells: up, all waves of the map; down, those longer than two new cells, so that none is taken for another
/// (the anti-alias filter, with a sharp limit: heights with steps ring by a tenth of the step).
///
/// A periodic axis keeps its length L, in n' = round(L/Δ') cells of L/n'. A free axis has the spacing Δ'
/// exactly, and as many cells as fit into its length, in its middle.
///
/// Accuracy  round-off for waves of a periodic axis below the limit, and for forms of degree 2 along a free
///           one; waves of a free axis as transform/refinement.hpp.
/// Cost      transforms of each row and column, three times their length on a free axis. Memory: the new
///           field, one of nx × n'y, and a transform of a row and a column per thread.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// The new grid. Throws ParameterError("spacing") unless 0 < Δ' ≤ half the length of each axis of more than
/// one point. An axis of one point stays.
Grid resampled_grid(const Grid& grid, double dx, double dy);

/// Heights on resampled_grid; throws DataError("heights", …) if a point is missing: fill it first.
Field resampled(const Field& z, const Grid& grid, double dx, double dy, int threads = 1);

}  // namespace asperity
