/// Work that may hang, crash or take all memory, done in a process of its own.
///
/// No library bounds what it does with a hostile file. A forked process does the work under limits and
/// returns bytes; if it fails, the parent goes on. The child runs the work only: no signal handlers, no exit
/// handlers, no flush of buffers, no standard error; it ends with its parent. The work must not need a lock
/// that another thread may hold (malloc's are safe). One thread at a time may call; during the call the
/// process receives SIGCHLD.
///
/// Cost      about a millisecond, and the bytes once in memory.
#pragma once

#include <string>

#include "dataset/netcdf.hpp"

namespace asperity::cli {

/// The bytes that the work hands to its sink. Throws DataError(variable, …): the work's own, or one for a
/// broken limit (memory not under the address sanitizer) or a crash.
Bytes run_in_sandbox(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

}  // namespace asperity::cli
