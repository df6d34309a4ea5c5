/// Memory for large arrays in pages of 2 MiB, where the system has them on request.
///
/// The first touch of a page costs about half a microsecond, as much as copying it: an array of 4096 × 4096 doubles
/// has 32768 pages of the common size, and 64 large ones.
#pragma once

#include <cstdint>
#include <sys/mman.h>

namespace asperity {

/// To be called on memory that has not been touched yet; small blocks, and a system that refuses, are left as they are.
inline void prefer_large_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + page - 1) / page * page, last = (begin + bytes) / page * page;
  if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace asperity
