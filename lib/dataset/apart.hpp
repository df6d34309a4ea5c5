/// Work that may hang, crash or take all memory, done in a process of its own.
///
/// What a library makes of a hostile file cannot be bounded from within. A forked process does the work under
/// limits and hands back bytes; whatever becomes of it, the process that asked for it goes on. The child runs
/// nothing but the work: no handler of the parent's signals, nothing at exit, no flush of its buffers; it ends when
/// its parent does, and what it says on standard error is not heard. Of several threads only the one that asks goes
/// on in it: the work must not need a lock that another one may hold (malloc's are safe).
///
/// Cost      about a millisecond, and the bytes once in memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "dataset/sparse_file.hpp"

namespace asperity {

struct Limits {
  unsigned seconds = 1;    ///< of processor time
  std::size_t memory = 0;  ///< bytes beyond those of the parent; not heeded under the address sanitizer
};

/// The bytes that the work hands to its sink. Throws DataError(variable, …) with the work's own words where it
/// threw one, and where it broke a limit or the process.
SparseFile made_apart(const std::function<void(const std::function<void(std::string_view)>& sink)>& work,
                      Limits limits, const std::string& variable);

}  // namespace asperity
