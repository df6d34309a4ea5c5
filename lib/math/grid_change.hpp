/// How far a figure moves from grid to grid.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/calibration.hpp"

namespace asperity {

/// max(|v(n) - v(n/2)|, s |v(n/2) - v(n/4)|) of a figure on n, n/2 and n/4 cells a side. The first difference
/// alone is near zero by accident in a few per cent of scenes.
inline double grid_change(double fine, double half, double quarter,
                          double s = calibration::grid_error::floor_of_first) {
  return std::max(std::abs(fine - half), s * std::abs(half - quarter));
}

}  // namespace asperity
