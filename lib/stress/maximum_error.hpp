/// What the grid leaves of the largest stress below a contact: its error, from the contact on coarser cells.
///
/// With m of core/halved.hpp over the maxima below the contact on n, n/2 and n/4 cells, and the depth in
/// cells c = max(1, z/h),
///     error of the value   max(0.28 m, 0.03/c² of it, 2e-5 of it),                               (1)
///     error of its depth   max(0.275 √c m', 5e-4 z, ¼ h - z), 0.41 for 0.275 at a limit pressure, (2)
/// m' with a tenth of the second difference in place of a quarter: depths on coarse cells jump. √c: the
/// deeper the maximum, the flatter, and the less its place settles from grid to grid. What the search
/// leaves: 2e-5, 5e-4, and above the first layer ¼ h. Where the limit pressure is reached and z < 2h the
/// stress is that of single cells' edges: a tenth of the value is added to (1), z to (2). What cells hide of
/// an edge, as of sliding, coarser cells hide too: unless the search begins below it, (1) is no less than
/// that (stress/edge.hpp), and both are NaN where that is.
///
/// Symbols   z depth of the largest stress [m]   n cells along a side   h shorter side of a cell [m]
/// Accuracy  validation/contact_grid_error without friction; tests/stress/maximum_error.cpp with it.
#pragma once

#include <array>

#include "stress/maximum.hpp"

namespace asperity {

/// Of the maxima on n, n/2 and n/4 cells, the first below this body: errors of the value and of the depth.
StressMaximum maximum_error(const LoadedBody& body, const std::array<StressMaximum, 3>& maxima,
                            const StressSearch& search, bool at_limit_pressure);

}  // namespace asperity
