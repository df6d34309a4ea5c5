/// Fields on a rectangular grid of cells.
///
/// x is the first index i, y the second index j, and j runs fastest in memory. Points are cell-centred,
///     x_i = (i + ½) Δx - Lx/2,   y_j = (j + ½) Δy - Ly/2,
/// so that the origin is the middle of the domain Lx × Ly = nx Δx × ny Δy.
///
/// Symbols   nx, ny  number of cells     Δx, Δy  spacing [m]     Lx, Ly  size of the domain [m]
#pragma once

#include <cstddef>
#include <string>

#include <Eigen/Core>

namespace asperity {

using Index = Eigen::Index;

/// A count in the type of the standard library.
constexpr std::size_t size(Index n) { return static_cast<std::size_t>(n); }

/// A quantity per cell, nx × ny, row-major (y fastest).
using Field = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Shape {
  Index nx = 0, ny = 0;

  Index cells() const { return nx * ny; }
  bool operator==(const Shape&) const = default;
};

inline Shape shape_of(const Field& f) { return {f.rows(), f.cols()}; }
/// "31x17"
inline std::string text(Shape s) { return std::to_string(s.nx) + "x" + std::to_string(s.ny); }

/// The axes along which a domain repeats.
struct Periodic {
  bool x = false, y = false;

  constexpr Periodic() = default;
  constexpr Periodic(bool along_both) : x(along_both), y(along_both) {}
  constexpr Periodic(bool along_x, bool along_y) : x(along_x), y(along_y) {}
  constexpr bool both() const { return x && y; }
  constexpr bool any() const { return x || y; }
  constexpr bool one() const { return x != y; }  ///< along one axis, free along the other
  bool operator==(const Periodic&) const = default;
};

/// A domain cut into cells.
struct Grid {
  Shape shape;
  double dx = 0, dy = 0;  ///< spacing [m]
  Periodic periodic = {};

  double x(Index i) const { return (static_cast<double>(i) + 0.5) * dx - 0.5 * size_x(); }
  double y(Index j) const { return (static_cast<double>(j) + 0.5) * dy - 0.5 * size_y(); }
  double size_x() const { return static_cast<double>(shape.nx) * dx; }
  double size_y() const { return static_cast<double>(shape.ny) * dy; }
  double cell_area() const { return dx * dy; }
};

/// f(x, y) sampled at the cell centres.
template <class Function>
Field sample(const Grid& grid, Function f) {
  Field out(grid.shape.nx, grid.shape.ny);
  for (Index i = 0; i < grid.shape.nx; ++i)
    for (Index j = 0; j < grid.shape.ny; ++j) out(i, j) = f(grid.x(i), grid.y(j));
  return out;
}

}  // namespace asperity
