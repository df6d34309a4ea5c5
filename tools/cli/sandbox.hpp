/// Work that may hang, crash or take all memory, done in a process of its own.
///
/// What a library makes of a hostile file cannot be bounded from within. A forked process does the work under
/// limits and hands back bytes; whatever becomes of it, the process that asked goes on. The child runs the
/// work alone: no handler of signals, nothing at exit, no flush of buffers; it ends with its parent, and its
/// standard error is not heard. The work must not need a lock that another thread may hold (malloc's are
/// safe). One thread at a time may ask; while it waits, the process hears of the end of its children.
///
/// Cost      about a millisecond, and the bytes once in memory.
#pragma once

#include <string>

#include "dataset/netcdf.hpp"

namespace asperity::cli {

/// The bytes that the work hands to its sink. Throws DataError(variable, …) with the work's own words where
/// it threw one, and where it broke a limit, that of memory not under the address sanitizer, or the process.
Bytes run_in_sandbox(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

}  // namespace asperity::cli
