/// Whether memory can be had, asked before a library that breaks down for want of it: FFTW aborts, KINSOL
/// goes on with what it has freed. It is taken and given back, and another thread may take it in between. 2
/// µs.
#pragma once

#include <cstddef>
#include <new>
#include <sys/mman.h>

namespace asperity {

/// Throws std::bad_alloc where there are not so many bytes in one piece.
inline void require_room(std::size_t bytes) {
  void* const taken = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (taken == MAP_FAILED) throw std::bad_alloc();
  ::munmap(taken, bytes);
}

}  // namespace asperity
