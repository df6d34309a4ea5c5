/// The table that asperity-stress prints of points.
#pragma once

#include "tools/cli/table.hpp"
#include "tools/stress/quantity.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

using StressPlaces = std::vector<std::array<double, 3>>;  ///< x, y and depth [m]

/// Three lengths a line, in metres or with units; # begins a comment. Throws DataError("points", …), also for a table of so
/// many points that takes more memory than is allowed.
StressPlaces read_points(const Tool& tool, const std::string& name);

/// The selected quantities at each of the points.
Table stress_table(const StressScene& scene, const StressSelection& selection, const StressPlaces& points,
                   int threads);

/// That points lie less deep than accurate_depth, and that there is more than the yield stress in the table.
void warn_of_points(const Tool& tool, const StressScene& scene, const StressPlaces& points,
                    const Table& table);

}  // namespace asperity::cli
