/// Memory of large arrays, and a check that there is enough.
///
/// The first access to a page costs half a microsecond, as much as copying it: large arrays are in pages of
/// 2 MiB, if the system provides them on request.
#pragma once

#include <new>
#include <sys/mman.h>
#include <vector>

#include "core/field.hpp"
#include "core/os.hpp"

namespace asperity {

/// A list of n zeros in such pages.
template <class Element>
std::vector<Element> large_list(std::size_t n) {
  std::vector<Element> out;
  out.reserve(n);
  os::prefer_large_pages(out.data(), n * sizeof(Element));
  out.resize(n);
  return out;
}

/// A field in such pages, not initialised.
inline Field large_field(Shape shape) {
  Field out(shape.nx, shape.ny);
  os::prefer_large_pages(out.data(), size(out.size()) * sizeof(double));
  return out;
}

/// Throws std::bad_alloc if this many bytes are not available in one piece. For libraries that fail without
/// memory: FFTW aborts, KINSOL uses freed memory. The bytes are allocated and freed, so another thread may
/// take them in between. Costs 2 µs.
inline void require_memory(std::size_t bytes) {
  void* const taken = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (taken == MAP_FAILED) throw std::bad_alloc();
  ::munmap(taken, bytes);
}

}  // namespace asperity
