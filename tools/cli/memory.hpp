/// The memory that a run may take, of one default in all tools.
#pragma once

#include <cstddef>
#include <unistd.h>

namespace asperity::cli {

/// What may always be read, whatever --memory says [byte]: it is little beside the program's own.
inline constexpr std::size_t always_read = std::size_t{16} << 20;

/// Half of the machine's memory [byte]; 1 GiB where the system does not tell.
inline std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages < 1 || page < 1) return std::size_t{1} << 30;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

}  // namespace asperity::cli
