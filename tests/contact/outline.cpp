// The outline of cells: sides counted by hand, areas against the circle's.
#include "contact/outline.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "scenes.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

template <class Inside>
Contact cells(const Grid& grid, Inside inside) {
  Contact out;
  const Field f = sample(grid, [&](double x, double y) { return inside(x, y) ? 1.0 : 0.0; });
  for (Index i = 0; i < f.size(); ++i)
    out.state.push_back(f.data()[i] > 0 ? Contact::elastic : Contact::open);
  out.area = f.sum() * grid.cell_area();
  return out;
}

}  // namespace

TEST_CASE("a block of cells has as many sides as its rim, and its symmetries are counted",
          "[contact][exact]") {
  const Grid grid{{8, 6}, 2, 3};
  // Columns x = -3, -1, 1 and rows y = -1.5, 1.5.
  const Contact block =
      cells(grid, [](double x, double y) { return std::abs(x + 1) < 2.5 && std::abs(y) < 2; });
  const Outline rim = outline(grid, block);
  CHECK(rim.sides_x == 2 * 2);
  CHECK(rim.sides_y == 2 * 3);
  CHECK(rim.perimeter(grid) == 4 * 3 + 6 * 2);
  CHECK(rim.images == 4);
  CHECK(outline(grid, block, Contact::plastic).sides() == 0);
  const Contact corner = cells(grid, [](double x, double y) { return x < -4 && y < -4 && x + y < -12; });
  CHECK(outline(grid, corner).sides() > 0);
  // At the edge of a free domain nothing is known beyond; a periodic one goes on.
  const Contact strip = cells(grid, [](double x, double) { return x < 0; });
  CHECK(outline(grid, strip).sides_x == 6);
  CHECK(outline({grid.shape, 2, 3, true}, strip).sides_x == 12);
  CHECK(outline({grid.shape, 2, 3, true}, strip).sides_y == 0);
  const Contact full = cells(grid, [](double, double) { return true; });
  CHECK(outline({grid.shape, 2, 3, true}, full).sides() == 0);
  CHECK(corrected_area(grid, full, outline(grid, full)) == full.area);
}

TEST_CASE("an L of cells has one image, a square eight", "[contact][exact]") {
  const Grid grid{{6, 6}, 1, 1};
  CHECK(outline(grid, cells(grid, [](double x, double y) { return std::abs(x) < 1 && std::abs(y) < 1; }))
            .images == 8);
  CHECK(outline(grid, cells(grid, [](double x,
                                     double y) { return (x == -0.5 && y < 2) || (x == 0.5 && y == -2.5); }))
            .images == 1);
}

TEST_CASE("the correction takes 0.118 of a cell a side, the scatter grows with the root", "[contact][law]") {
  const Grid grid{{64, 64}, 0.5, 0.5};
  const Contact disc = cells(grid, [](double x, double y) { return std::hypot(x - 0.1, y + 0.07) < 9.3; });
  const Outline rim = outline(grid, disc);
  // A convex outline has 4 sides a cell of its diameter along the lines.
  CHECK(rim.sides() == Approx(8 * 9.3 / 0.5).epsilon(0.03));
  const double share = (disc.area - corrected_area(grid, disc, rim)) / (rim.sides() * grid.cell_area());
  CHECK(share == Approx((pi - 1 + std::log(2.0)) / 24).epsilon(1e-12));
  CHECK(area_scatter(grid, rim) == Approx((0.5 * std::sqrt(rim.sides()) + 0.03 * rim.sides()) * 0.25));
  CHECK(area_excess(grid, rim) >= area_scatter(grid, rim));
}

// A line contact along a line of the grid repeats one piece of its outline: its area is a whole cell off at
// most each way, and 0.5 √(2n · 2n) + 0.03 · 2n cells are more than that of n.
TEST_CASE("straight edges along the grid repeat one piece, and their area lies within its error",
          "[contact][law]") {
  for (const bool turned : {false, true}) {
    const Grid grid{turned ? Shape{40, 96} : Shape{96, 40}, 0.5, 0.5, true};
    for (double half = 4; half < 5; half += 0.05) {
      const Contact strip =
          cells(grid, [&](double x, double y) { return std::abs((turned ? y : x) - 0.013) < half; });
      const Outline rim = outline(grid, strip);
      CAPTURE(turned, half, rim.images);
      CHECK(rim.images % 40 == 0);
      CHECK(std::abs(corrected_area(grid, strip, rim) - 2 * half * 20) <= area_scatter(grid, rim));
    }
  }
}

TEST_CASE("under a limit pressure no area is below load over limit, and plastic patches put it in doubt",
          "[contact][law]") {
  const Grid grid{{64, 64}, 0.5, 0.5};
  Contact disc = cells(grid, [](double x, double y) { return std::hypot(x - 0.1, y + 0.07) < 9.3; });
  const Outline rim = outline(grid, disc);
  const double limit = 2, elastic = corrected_area(grid, disc, rim);
  CHECK(corrected_area_error(grid, disc, rim) == area_scatter(grid, rim));
  disc.load = 0.5 * limit * elastic;
  CHECK(corrected_area(grid, disc, rim, limit) == elastic);
  disc.load = 0.999 * limit * disc.area, disc.plastic_area = disc.area;
  CHECK(corrected_area(grid, disc, rim, limit) == disc.load / limit);
  CHECK(disc.area - elastic + area_scatter(grid, rim) == Approx(corrected_area_error(grid, disc, rim)));
}

namespace {

using State = std::vector<std::int8_t>;

Grid cells(Index nx, Index ny, Periodic around) { return {{nx, ny}, 1e-6, 2e-6, around}; }

// Rows of a picture: # is in contact.
struct Picture {
  Picture(std::initializer_list<std::string_view> rows)
      : nx(static_cast<Index>(rows.size())), ny(static_cast<Index>(rows.begin()->size())) {
    for (std::string_view row : rows)
      for (char c : row) state.push_back(c == '#');
  }
  Patches patches(bool around) const { return find_patches(cells(nx, ny, around), state); }
  Index nx, ny;
  State state;
};

// Walks from each cell over an unrolled plane: a patch that comes back to a cell from another period goes
// around. Quadratic in the number of periods that the walk may leave.
struct Walked {
  std::vector<std::set<Index>> patches;
  bool along_x = false, along_y = false;
};

Walked walked(const Grid& grid, const State& state) {
  const Index nx = grid.shape.nx, ny = grid.shape.ny;
  Walked out;
  std::set<Index> seen;
  for (Index start = 0; start < nx * ny; ++start) {
    if (state[size(start)] == 0 || seen.contains(start)) continue;
    using Place = std::pair<Index, Index>;
    std::map<Index, Place> first;  // where a cell was met on the plane
    std::deque<Place> queue{{start / ny, start % ny}};
    first[start] = queue.front();
    while (!queue.empty()) {
      const auto [i, j] = queue.front();
      queue.pop_front();
      for (const auto& [k, l] : {Place{i + 1, j}, Place{i - 1, j}, Place{i, j + 1}, Place{i, j - 1}}) {
        if (!grid.periodic.x && (k < 0 || k >= nx)) continue;
        if (!grid.periodic.y && (l < 0 || l >= ny)) continue;
        const Index cell = ((k % nx + nx) % nx) * ny + (l % ny + ny) % ny;
        if (state[size(cell)] == 0) continue;
        if (const auto [at, is_new] = first.try_emplace(cell, k, l); is_new) {
          queue.emplace_back(k, l);
        } else {
          out.along_x |= at->second.first != k;
          out.along_y |= at->second.second != l;
        }
      }
    }
    std::set<Index> patch;
    for (const auto& [cell, place] : first) patch.insert(cell);
    seen.insert(patch.begin(), patch.end());
    auto has_row = [&](Index i) { return std::ranges::any_of(patch, [&](Index c) { return c / ny == i; }); };
    auto has_column = [&](Index j) {
      return std::ranges::any_of(patch, [&](Index c) { return c % ny == j; });
    };
    if (!grid.periodic.x) out.along_x |= has_row(0) && has_row(nx - 1);
    if (!grid.periodic.y) out.along_y |= has_column(0) && has_column(ny - 1);
    out.patches.push_back(std::move(patch));
  }
  std::ranges::stable_sort(out.patches, std::greater<>(), [](const auto& patch) { return patch.size(); });
  return out;
}

}  // namespace

TEST_CASE("the patches of random fields are those of a walk from cell to cell", "[patches][exact]") {
  std::mt19937_64 generator(11);
  int spanning = 0, not_spanning = 0;
  for (const Shape shape : {Shape{24, 24}, {17, 31}, {1, 20}, {20, 1}, {2, 2}, {3, 40}, {1, 1}})
    for (const double share : {0.2, 0.5, 0.59, 0.65, 0.9})
      for (const Periodic around : {Periodic{false}, {true}, {true, false}, {false, true}})
        for (int draw = 0; draw < 8; ++draw) {
          State state(size(shape.cells()));
          std::bernoulli_distribution inside(share);
          for (std::int8_t& cell : state)
            cell = static_cast<std::int8_t>(inside(generator) ? 1 + draw % 2 : 0);
          const Grid grid = cells(shape.nx, shape.ny, around);
          const Patches found = find_patches(grid, state);
          const Walked expected = walked(grid, state);
          CAPTURE(shape.nx, shape.ny, share, around.x, around.y, draw);
          REQUIRE(found.count() == static_cast<Index>(expected.patches.size()));
          CHECK(found.percolates_x == expected.along_x);
          CHECK(found.percolates_y == expected.along_y);
          (expected.along_x ? spanning : not_spanning)++;
          for (std::size_t k = 0; k < expected.patches.size(); ++k) {
            CHECK(found.cells[k] == static_cast<Index>(expected.patches[k].size()));
            for (const Index cell : expected.patches[k])
              REQUIRE(found.label[size(cell)] == static_cast<std::int32_t>(k + 1));
          }
          CHECK(std::ranges::count_if(found.label, [](auto l) { return l > 0; }) ==
                std::ranges::count_if(state, [](auto s) { return s > 0; }));
        }
  CHECK(spanning > 50);
  CHECK(not_spanning > 50);
}

TEST_CASE("cells that meet at a corner alone are two patches, at opposite edges one where the grid repeats",
          "[patches][exact]") {
  CHECK(Picture{"#.", ".#"}.patches(false).count() == 2);
  const Picture edges{"#..#", "....", "#..."};
  CHECK(edges.patches(false).count() == 3);
  CHECK(edges.patches(true).count() == 1);
  CHECK_FALSE(edges.patches(true).percolates_x);
  CHECK_FALSE(edges.patches(true).percolates_y);
}

TEST_CASE("a patch that touches both edges percolates a free domain, and a periodic one only around it",
          "[patches][exact]") {
  const Picture hook{"##....", ".#....", ".##...", "..#..."};
  CHECK(hook.patches(false).percolates_x);
  CHECK_FALSE(hook.patches(false).percolates_y);
  CHECK_FALSE(hook.patches(true).percolates_x);
  const Picture ring{".#..", "##..", "#...", "##..", ".#.."};
  CHECK(ring.patches(true).percolates_x);
  CHECK_FALSE(ring.patches(true).percolates_y);
  const Picture none{"...", "..."};
  CHECK(none.patches(true).count() == 0);
  CHECK_FALSE(none.patches(false).percolates_x);
}

// Of one turn along x for two along y: nowhere is there a straight way around.
TEST_CASE("a spiral that goes around along both axes at once percolates along both", "[patches][exact]") {
  const Picture diagonal{"##..", ".##.", "..##", "#..#"};
  CHECK(diagonal.patches(true).count() == 1);
  CHECK(diagonal.patches(true).percolates_x);
  CHECK(diagonal.patches(true).percolates_y);
  const Picture spiral{"#######", "......#", "#####.#", "#...#.#", "#.###.#", "#.....#", "#######"};
  CHECK(spiral.patches(false).count() == 1);
  CHECK(spiral.patches(false).percolates_x);
}
