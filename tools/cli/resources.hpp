/// What a run may take of the machine, and what it has taken.
#pragma once

#include <cstddef>
#include <string>

namespace asperity::cli {

/// What may always be read, whatever --memory says [byte]: it is little beside the program's own.
inline constexpr std::size_t always_read = std::size_t{16} << 20;
/// Half of the machine's memory [byte], the default of --memory; 1 GiB where the system does not tell.
std::size_t half_of_memory();

/// For --time, "1.52 s, CPU 2.9 s (2.7 s user, 0.2 s system), peak memory 61 MB", with the processes that it has started
/// and waited for.
std::string usage_of_run(double wall_seconds);

}  // namespace asperity::cli
