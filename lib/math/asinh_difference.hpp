/// asinh((y+b)/|w|) - asinh((y-b)/|w|): what an edge from y-b to y+b contributes at a distance w, b > 0.
///
/// Both terms of one sign cancel; sinh of their difference is then
///     4by / [(y+b) √((y-b)² + w²) + (y-b) √((y+b)² + w²)],
/// in which nothing does, and which stays finite for w = 0.
///
/// Accuracy  some ε, relative.
#pragma once

#include <cmath>

namespace asperity {

inline double asinh_difference(double w, double y, double b) {
  const double above = y + b, below = y - b;
  if (above * below <= 0) return std::asinh(above / std::abs(w)) - std::asinh(below / std::abs(w));
  return std::asinh(4 * b * y / (above * std::hypot(below, w) + below * std::hypot(above, w)));
}

}  // namespace asperity
