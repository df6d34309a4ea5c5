/// What asperity-stress leaves of a solution: attributes of a dataset, and a table of points.
#pragma once

#include "stress/maximum.hpp"
#include "tools/cli/table.hpp"
#include "tools/stress/quantity.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// The effective parameters.
void record_parameters(StressScene& scene, const StressOptions& options);
void record_maximum(Attributes& a, const StressMaximum& maximum);

/// The selected quantities at each of the points (x, y, z) [m].
Table stress_table(const StressScene& scene, const StressSelection& selection,
                   const std::vector<std::array<double, 3>>& points, int threads);

/// Three lengths a line, in metres or with units; # begins a comment. Throws DataError("points", …), also for a table of so
/// many points that takes more memory than is allowed.
std::vector<std::array<double, 3>> parse_points(std::string_view text, const MemoryBound& memory);

}  // namespace asperity::cli
