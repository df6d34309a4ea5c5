/// What the grid leaves of the largest stress below a contact: its error, from the contact on coarser cells.
///
/// With m of math/grid_change.hpp over the maxima below the contact on n, n/2 and n/4 cells, and h the
/// shorter side of a cell,
///     error of the value   max(0.28 m, 0.03 min(1, (h/z)²) of it),                               (1)
///     error of its depth   max(m/4, 0.03 h).                                                     (2)
/// Where the limit pressure is reached and z < 2h the stress is that of single cells' edges: a tenth of the
/// value is added to (1), z to (2).
///
/// Symbols   z depth of the largest stress [m]   n cells along a side
/// Accuracy  validation/contact_grid_error.
#pragma once

#include <array>

#include "core/field.hpp"

namespace asperity {

/// The largest value and its depth on one grid.
struct PeakStress {
  double value = 0, depth = 0;
};

/// On n, n/2 and n/4 cells; errors in the units of both.
PeakStress maximum_error(const Grid& grid, const std::array<PeakStress, 3>& maxima, bool at_limit_pressure);

}  // namespace asperity
