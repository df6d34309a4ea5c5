/// The option --memory, of one default in all tools that have it.
#pragma once

#include <cstddef>
#include <string>
#include <unistd.h>

#include "cli/tool.hpp"

namespace asperity::cli {

/// Half of the machine's memory [byte]; 1 GiB where the system does not tell.
inline std::size_t half_of_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages < 1 || page < 1) return std::size_t{1} << 30;
  return static_cast<std::size_t>(pages) / 2 * static_cast<std::size_t>(page);
}

/// What is bounded is told by `text`. The default is told in words, so that the manual is the same on every machine.
inline void declare_memory(Tool& tool, std::size_t& bytes, const std::string& text) {
  bytes = half_of_memory();
  tool.bytes("--memory", bytes, text + ". Absent: half of the machine's", "Resources")->default_str("");
}

}  // namespace asperity::cli
