#include "contact/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/extent.hpp"

namespace asperity {
namespace {

constexpr double lattice = 0.5, lattice_bias = 0.03;  // of the accuracy: validation/contact_grid_error
constexpr double bias = (std::numbers::pi - 1 + std::numbers::ln2) / 24;  // of a cell a side

// The cells of the set.
class Cells {
 public:
  Cells(const Grid& grid, const Contact& contact, Contact::State least, Contact::State most)
      : grid_(grid), state_(contact.state), least_(least), most_(most) {}

  bool operator()(Index i, Index j) const {
    const auto state = state_[size(i * grid_.shape.ny + j)];
    return least_ <= state && state <= most_;
  }
  bool around(Index i, Index j) const { return (*this)(i % grid_.shape.nx, j % grid_.shape.ny); }

 private:
  const Grid& grid_;
  const std::vector<std::int8_t>& state_;
  Contact::State least_, most_;
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

using Periods = std::array<std::int32_t, 2>;  // along x, y

Periods operator+(Periods a, Periods b) { return {a[0] + b[0], a[1] + b[1]}; }
Periods operator-(Periods a, Periods b) { return {a[0] - b[0], a[1] - b[1]}; }

// Trees of cells. A cell's offset is counted from its parent.
class Forest {
 public:
  explicit Forest(Index cells) : nodes_(size(cells)) {}

  void plant(Index cell) { node(cell).parent = cell; }

  struct Found {
    Index root;
    Periods offset;  // from the root
  };
  // Halves the path on its way.
  Found find(Index cell) {
    Periods from_root{};
    while (node(cell).parent != cell) {
      Node& here = node(cell);
      const Node& above = node(here.parent);
      if (above.parent != here.parent) {
        here.offset = here.offset + above.offset;
        here.parent = above.parent;
      }
      from_root = from_root + here.offset;
      cell = here.parent;
    }
    return {cell, from_root};
  }

  // Of two cells that share a side, `step` periods apart; the periods by which their patch goes around.
  Periods join(Index one, Index other, Periods step) {
    const Found a = find(one), b = find(other);
    const Periods around = a.offset + step - b.offset;
    if (a.root == b.root) return around;
    const bool under_a = node(a.root).cells >= node(b.root).cells;
    Node &top = node(under_a ? a.root : b.root), &below = node(under_a ? b.root : a.root);
    below.parent = under_a ? a.root : b.root;
    below.offset = under_a ? around : Periods{-around[0], -around[1]};
    top.cells += below.cells;
    return {};
  }

 private:
  struct Node {
    Index parent = 0, cells = 1;  // cells: of a root
    Periods offset{};
  };
  Node& node(Index cell) { return nodes_[size(cell)]; }

  std::vector<Node> nodes_;
};

class Finder {
 public:
  Finder(const Grid& grid, std::span<const std::int8_t> state)
      : grid_(grid), state_(state), forest_(grid.shape.cells()) {}

  Patches found() {
    const auto [nx, ny] = grid_.shape;
    for (Index cell = 0; cell < nx * ny; ++cell)
      if (inside(cell)) forest_.plant(cell);
    for (Index i = 0; i < nx; ++i)
      for (Index j = 0; j < ny; ++j) {
        if (!inside(i * ny + j)) continue;
        if (i + 1 < nx || grid_.periodic.x) meet(i * ny + j, (i + 1) % nx * ny + j, {i + 1 == nx, 0});
        if (j + 1 < ny || grid_.periodic.y) meet(i * ny + j, i * ny + (j + 1) % ny, {0, j + 1 == ny});
      }
    number();
    return std::move(out_);
  }

 private:
  bool inside(Index cell) const { return state_[size(cell)] != 0; }

  void meet(Index one, Index other, Periods step) {
    if (!inside(other)) return;
    const Periods around = forest_.join(one, other, step);
    out_.percolates_x |= around[0] != 0;
    out_.percolates_y |= around[1] != 0;
  }

  // Numbers the roots as their first cells come, then by size.
  void number() {
    const Index cells = grid_.shape.cells();
    std::vector<std::int32_t> of_root(size(cells));
    out_.label.resize(size(cells));
    std::vector<Index> count;
    for (Index cell = 0; cell < cells; ++cell) {
      if (!inside(cell)) continue;
      std::int32_t& label = of_root[size(forest_.find(cell).root)];
      if (label == 0) {
        count.push_back(0);
        label = static_cast<std::int32_t>(count.size());
      }
      out_.label[size(cell)] = label;
      ++count[static_cast<std::size_t>(label - 1)];
    }
    sort_by_size(count);
    span_the_domain();
  }

  void sort_by_size(const std::vector<Index>& count) {
    std::vector<std::size_t> order(count.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t k) { return count[k]; });
    std::vector<std::int32_t> rank(count.size() + 1, 0);
    for (std::size_t k = 0; k < order.size(); ++k) {
      rank[order[k] + 1] = static_cast<std::int32_t>(k + 1);
      out_.cells.push_back(count[order[k]]);
    }
    for (std::int32_t& label : out_.label) label = rank[static_cast<std::size_t>(label)];
  }

  // (1): patches at both free ends.
  void span_the_domain() {
    const auto [nx, ny] = grid_.shape;
    auto spans = [&](Index lines, Index along, Index across, Index last) {
      std::vector<bool> first(out_.cells.size() + 1);
      for (Index k = 0; k < lines; ++k) first[label(k * along)] = true;
      first[0] = false;
      bool both = false;
      for (Index k = 0; k < lines; ++k) both |= first[label(k * along + last * across)];
      return both;
    };
    if (!grid_.periodic.x) out_.percolates_x |= spans(ny, 1, ny, nx - 1);
    if (!grid_.periodic.y) out_.percolates_y |= spans(nx, ny, 1, ny - 1);
  }
  std::size_t label(Index cell) const { return static_cast<std::size_t>(out_.label[size(cell)]); }

  Grid grid_;
  std::span<const std::int8_t> state_;
  Forest forest_;
  Patches out_;
};

}  // namespace

Outline outline(const Grid& grid, const Contact& contact, Contact::State least, Contact::State most) {
  const Cells cells(grid, contact, least, most);
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

Patches find_patches(const Grid& grid, std::span<const std::int8_t> state) {
  return Finder(grid, state).found();
}

}  // namespace asperity
