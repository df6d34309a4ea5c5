/// Errors from twins (stats/twins/twin_errors.hpp) for rows of asperity-stats.
#pragma once

#include "stats/measure.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

enum class TwinUse { where_quick, everywhere };

/// Of all parameters, or of those for which theory does not hold; if `where_quick`, only for fields that take
/// about two seconds on one core (512x512 points for one group of parameters, 256x256 for all), and a note on
/// what is left out.
void errors_by_twins(const Tool& tool, const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     Parameters& parameters);

}  // namespace asperity::cli
