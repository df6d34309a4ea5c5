/// The stress at points, as a table.
#pragma once

#include "tools/stress/quantity.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// Prints the selected quantities at each of the points in the file that the options name: three lengths a
/// line, in metres or with units; # begins a comment. Throws DataError("points", …), also for a table of so
/// many points that takes more memory than is allowed. Warns of points that lie less deep than
/// accurate_depth, and of more than the yield stress.
void print_points(const Tool& tool, const StressOptions& options, const StressSelection& selection);

}  // namespace asperity::cli
