#include "contact/patches.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace asperity {
namespace {

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

Patches find_patches(const Grid& grid, std::span<const std::int8_t> state) {
  return Finder(grid, state).found();
}

}  // namespace asperity
