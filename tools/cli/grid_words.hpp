/// Grids in words, and when two are the same.
#pragma once

#include <cmath>
#include <string>

#include "core/field.hpp"
#include "tools/cli/quantity.hpp"

namespace asperity::cli {

/// ", periodic", ", periodic along x", or nothing.
inline std::string periodic_words(Periodic periodic) {
  if (!periodic.any()) return "";
  return periodic.both() ? ", periodic" : periodic.x ? ", periodic along x" : ", periodic along y";
}

/// "64x32 cells on 1mm x 0.5mm, periodic"
inline std::string described(const Grid& grid) {
  return std::to_string(grid.shape.nx) + "x" + std::to_string(grid.shape.ny) + " cells on " +
         format_quantity(grid.size_x(), "m") + " x " + format_quantity(grid.size_y(), "m") +
         periodic_words(grid.periodic);
}

inline bool same_spacing(const Grid& one, const Grid& other) {
  constexpr double printed = 1e-6;  // sizes may come from texts
  return std::abs(one.dx / other.dx - 1) <= printed && std::abs(one.dy / other.dy - 1) <= printed;
}

inline bool same_grid(const Grid& one, const Grid& other) {
  return one.shape == other.shape && one.periodic == other.periodic && same_spacing(one, other);
}

}  // namespace asperity::cli
