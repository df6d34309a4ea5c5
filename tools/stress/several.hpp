/// The largest stresses below several pressed surfaces.
#pragma once

#include "tools/stress/maximum.hpp"

namespace asperity::cli {

/// Prints a table: with --maximum a row for each surface, then the mean over them and its standard error;
/// with --result maxima a row for each depth, with the mean and its standard error. Surfaces that fail are
/// not in the mean. Returns the worst of the exit codes.
int print_several(Tool& tool, StressOptions& options);

}  // namespace asperity::cli
