/// The stress at points, as a table.
#pragma once

#include "tools/stress/quantity.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// Prints the selected quantities at each point of a file: x, y and depth a line, with their units, or under
/// a header that has them, '# x [um] y [um] depth [um]'; # begins a comment. Throws DataError("points", …),
/// also where the table needs more memory than is allowed. Warns of points above accurate_depth and of
/// stresses above the yield stress.
void print_points(const Tool& tool, StressOptions& options, const StressSelection& selection);

}  // namespace asperity::cli
