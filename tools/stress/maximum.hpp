/// The largest stress below a loaded surface: --maximum, and the table of --result maxima.
#pragma once

#include "stress/maximum.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/tool.hpp"
#include "tools/stress/options.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// What --of and --below ask for on this grid; throws ParameterError("below", …).
StressSearch search_of(const StressOptions& options, const Grid& grid);

/// The name of the attribute with this maximum.
std::string attribute_of(Criterion of);

/// Searches in whole layers, sets the attributes stress_max_…, with the error of a maximum at an edge, and
/// warns of one that the grid does not resolve or that may lie outside. Of several ranks the first searches,
/// and holds the whole pressure for it.
StressMaximum find_maximum(const Tool& tool, StressScene& scene, const StressSearch& search);

/// The largest stress of each layer and its place, the table of --result maxima; warns as find_maximum does.
Table maxima_of(const Tool& tool, const StressOptions& options, const StressScene& scene);

}  // namespace asperity::cli
