/// Errors from twins for rows of asperity-stats, with progress and a note on what is left out.
#pragma once

#include "stats/twins/twin_errors.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

/// As asperity::errors_by_twins.
void errors_by_twins(const Tool& tool, const Sample& sample, const MeasureOptions& asked, TwinUse use,
                     Parameters& parameters);

}  // namespace asperity::cli
