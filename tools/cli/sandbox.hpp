/// Work that may hang, crash or take all memory, done in a process of its own.
///
/// What a library makes of a hostile file cannot be bounded from within. A forked process does the work under
/// limits and hands back bytes; whatever becomes of it, the process that asked for it goes on. The child runs
/// nothing but the work: no handler of the parent's signals, nothing at exit, no flush of its buffers; it ends when
/// its parent does, and what it says on standard error is not heard. Of several threads only the one that asks goes
/// on in it: the work must not need a lock that another one may hold (malloc's are safe).
///
/// While it waits the process hears of the end of its children; before and afterwards as its parent left it. One thread
/// at a time may ask.
///
/// Cost      about a millisecond, and the bytes once in memory.
#pragma once

#include <string>

#include "dataset/netcdf.hpp"

namespace asperity::cli {

/// The bytes that the work hands to its sink. Throws DataError(variable, …) with the work's own words where it
/// threw one, and where it broke a limit or the process.
/// The limit of memory is not heeded under the address sanitizer.
Bytes run_in_sandbox(const WorkOfBytes& work, WorkLimits limits, const std::string& variable);

}  // namespace asperity::cli
