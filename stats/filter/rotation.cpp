#include "stats/filter/rotation.hpp"

#include <utility>

namespace asperity {

// z'(p) = z(R(-90°) p): x' = -y, y' = x.
Field turned_quarters(const Field& z, int quarters) {
  switch ((quarters % 4 + 4) % 4) {
    case 1:
      return z.transpose().colwise().reverse();
    case 2:
      return z.reverse();
    case 3:
      return z.transpose().rowwise().reverse();
    default:
      return z;
  }
}

Grid turned_quarters(const Grid& grid, int quarters) {
  Grid out = grid;
  if (quarters % 2 == 0) return out;
  std::swap(out.shape.nx, out.shape.ny);
  std::swap(out.dx, out.dy);
  std::swap(out.periodic.x, out.periodic.y);
  return out;
}

Field mirrored(const Field& z, Axis1D axis) {
  return axis == Axis1D::x ? Field(z.colwise().reverse()) : Field(z.rowwise().reverse());
}

}  // namespace asperity
