/// Memory for large arrays in pages of 2 MiB, if the system provides them on request: the first access to a
/// page costs half a microsecond, as much as copying it.
#pragma once

#include <cstdint>
#include <sys/mman.h>
#include <vector>

namespace asperity {

/// For memory not yet accessed; has no effect on small blocks, or if the system refuses.
inline void prefer_large_pages(void* memory, std::size_t bytes) {
  constexpr std::size_t page = std::size_t{2} << 20;
  const std::size_t before = (page - reinterpret_cast<std::uintptr_t>(memory) % page) % page;
  if (bytes < before + page) return;
  ::madvise(static_cast<char*>(memory) + before, (bytes - before) / page * page, MADV_HUGEPAGE);
}

/// A list of n zeros in such pages.
template <class Element>
std::vector<Element> large_list(std::size_t n) {
  std::vector<Element> out;
  out.reserve(n);
  prefer_large_pages(out.data(), n * sizeof(Element));
  out.resize(n);
  return out;
}

}  // namespace asperity
