/// Numbers in messages.
#pragma once

#include <cstdio>
#include <string>

#include "core/field.hpp"

namespace asperity {

/// "31x17"
inline std::string text(Shape s) { return std::to_string(s.nx) + "x" + std::to_string(s.ny); }

/// To three digits.
inline std::string number(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

}  // namespace asperity
