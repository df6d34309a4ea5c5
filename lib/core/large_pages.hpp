/// Memory for large arrays in pages of 2 MiB, where the system has them on request: the first touch of a page
/// costs half a microsecond, as much as copying it.
#pragma once

#include <cstdint>
#include <sys/mman.h>

namespace asperity {

/// Of memory that has not been touched yet; small blocks, and a system that refuses, are left as they are.
inline void prefer_large_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = std::size_t{2} << 20;
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  if (bytes < before + page) return;
  ::madvise(static_cast<char*>(memory) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
}

}  // namespace asperity
