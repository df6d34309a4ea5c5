#include "contact/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/calibration.hpp"
#include "core/extent.hpp"

namespace asperity {
namespace {

using namespace calibration::grid_error;

constexpr double bias = (std::numbers::pi - 1 + std::numbers::ln2) / 24;  // of a cell a side

// The cells of the set.
class Cells {
 public:
  Cells(const Grid& grid, const Contact& contact, Contact::State least)
      : grid_(grid), state_(contact.state), least_(least) {}

  bool operator()(Index i, Index j) const { return state_[size(i * grid_.shape.ny + j)] >= least_; }
  bool around(Index i, Index j) const { return (*this)(i % grid_.shape.nx, j % grid_.shape.ny); }

 private:
  const Grid& grid_;
  const std::vector<std::int8_t>& state_;
  Contact::State least_;
};

std::array<Extent, 2> box_of(const Grid& grid, const Cells& cells) {
  const auto [nx, ny] = grid.shape;
  LineMask in_x = LineMask::Constant(nx, false), in_y = LineMask::Constant(ny, false);
  for (Index i = 0; i < nx; ++i)
    for (Index j = 0; j < ny; ++j)
      if (cells(i, j)) in_x(i) = in_y(j) = true;
  return {extent(in_x, grid.periodic.x), extent(in_y, grid.periodic.y)};
}

// Of the eight symmetries of a square, those of the cells in the box around them.
Index images_of(const Grid& grid, const Cells& cells) {
  const auto [x, y] = box_of(grid, cells);
  const Index nx = x.count, ny = y.count;
  auto holds = [&, x = x, y = y](bool mirror_x, bool mirror_y, bool transpose) {
    for (Index i = 0; i < nx; ++i)
      for (Index j = 0; j < ny; ++j) {
        Index a = transpose ? j : i, b = transpose ? i : j;
        if (mirror_x) a = nx - 1 - a;
        if (mirror_y) b = ny - 1 - b;
        if (cells.around(x.first + i, y.first + j) != cells.around(x.first + a, y.first + b)) return false;
      }
    return true;
  };
  const bool square = nx == ny && std::abs(grid.dx / grid.dy - 1) < 1e-9;
  Index images = 1;
  for (int k = 1; k < (square ? 8 : 4); ++k) images += holds(k & 1, k & 2, k & 4);
  return images;
}

// Of the translations along periodic axes: all of an axis if its lines are alike.
Index translations_of(const Grid& grid, const Cells& cells) {
  const auto [nx, ny] = grid.shape;
  bool along_x = grid.periodic.x, along_y = grid.periodic.y;
  for (Index i = 0; i < nx && (along_x || along_y); ++i)
    for (Index j = 0; j < ny; ++j) {
      along_x = along_x && cells(i, j) == cells.around(i + 1, j);
      along_y = along_y && cells(i, j) == cells.around(i, j + 1);
    }
  return (along_x ? nx : 1) * (along_y ? ny : 1);
}

}  // namespace

Outline outline(const Grid& grid, const Contact& contact, Contact::State least) {
  const Cells cells(grid, contact, least);
  const auto [nx, ny] = grid.shape;
  Outline out;
  for (Index i = 0; i < nx; ++i) {
    const bool below = i + 1 < nx || grid.periodic.x;
    for (Index j = 0; j < ny; ++j) {
      const bool in = cells(i, j);
      if (below) out.sides_x += in != cells.around(i + 1, j);
      if (j + 1 < ny || grid.periodic.y) out.sides_y += in != cells.around(i, j + 1);
    }
  }
  if (out.sides() > 0) out.images = images_of(grid, cells) * translations_of(grid, cells);
  return out;
}

double corrected_area(const Grid& grid, const Contact& contact, const Outline& outline,
                      double limit_pressure) {
  return std::max(contact.load / limit_pressure, contact.area - bias * outline.sides() * grid.cell_area());
}

double corrected_area_error(const Grid& grid, const Contact& contact, const Outline& outline) {
  const double plastic = contact.area > 0 ? contact.plastic_area / contact.area : 0;
  return area_scatter(grid, outline) + plastic * bias * outline.sides() * grid.cell_area();
}

double area_scatter(const Grid& grid, const Outline& outline) {
  return (lattice * outline.scatter() + lattice_bias * outline.sides()) * grid.cell_area();
}

double area_excess(const Grid& grid, const Outline& outline) {
  return bias * outline.sides() * grid.cell_area() + area_scatter(grid, outline);
}

}  // namespace asperity
