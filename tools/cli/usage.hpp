/// What a run has taken of the machine, for --time.
#pragma once

#include <string>

namespace asperity::cli {

/// "1.52 s, CPU 2.9 s (2.7 s user, 0.2 s system), peak memory 61 MB", with the processes that it has started and
/// waited for.
std::string usage_of_run(double wall_seconds);

}  // namespace asperity::cli
