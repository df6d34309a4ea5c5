/// Checks that memory is available before calling a library that fails without it: FFTW aborts, KINSOL uses
/// freed memory. The memory is allocated and freed, so another thread may take it in between. Costs 2 µs.
#pragma once

#include <cstddef>
#include <new>
#include <sys/mman.h>

namespace asperity {

/// Throws std::bad_alloc if this many bytes are not available in one piece.
inline void require_room(std::size_t bytes) {
  void* const taken = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (taken == MAP_FAILED) throw std::bad_alloc();
  ::munmap(taken, bytes);
}

}  // namespace asperity
