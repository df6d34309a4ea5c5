/// Sums over cells by blocks are those cell by cell.
#include "stress/cell_tree.hpp"

#include <random>

#include "stress/points.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A fifth of the cells under pressures of 0 to 1.
LoadedBody scattered(const Grid& grid, const Friction& friction) {
  std::mt19937 random(7);
  std::uniform_real_distribution<> uniform;
  const Field p = sample(grid, [&](double, double) { return uniform(random) < 0.2 ? uniform(random) : 0.0; });
  return {grid, p, 0.3, friction};
}

}  // namespace

// A block acts from 1.7 sides off its middle on, 3.4 half sides: polynomials of 8 points err there by ρ^-8,
// ρ = 3.4 + √(3.4² - 1), 2.6e-7 of what the block does; all blocks that far do a part of the largest pressure.
TEST_CASE("stresses by blocks of cells are the sums over the cells within 1e-7 of the largest pressure",
          "[points][law]") {
  for (double aspect : {1.0, 3.0, 0.05, 20.0})
    for (const Friction& friction : {Friction{}, Friction{0.4, 0.7}}) {
      const Grid grid{{90, 75}, 1, aspect};
      const LoadedBody body = scattered(grid, friction);
      const CellTree tree(body);
      const StressPoints points(body);
      for (int k = 0; k < 12; ++k) {
        const double z = k < 4 ? 0.3 * k : std::pow(2.0, 0.8 * (k - 4)) * std::max(1.0, aspect);
        const double x = grid.x(5 + 7 * k) + (k < 4 ? 0 : 0.3), y = grid.y((11 * k) % 75);
        const stress::Tensor fast = tree.at(x, y, z), exact = points.at(x, y, z);
        for (auto c : stress::components) {
          CAPTURE(aspect, friction.coefficient, x, y, z, c);
          CHECK(std::abs(fast[c] - exact[c]) <= 1e-7);
        }
      }
    }
}

// The arc tangent of 0/0 made the stress there no number, and the search found nothing below a contact whose
// axis runs through corners.
TEST_CASE("the stress below a corner of cells is that of the sum over cells", "[points][law]") {
  const Grid grid{{24, 20}, 1, 1};
  const LoadedBody body = scattered(grid, {0.4, 0.7});
  const stress::Tensor fast = CellTree(body).at(0, 0, 1.5), exact = StressPoints(body).at(0, 0, 1.5);
  for (auto c : stress::components) CHECK(std::abs(fast[c] - exact[c]) <= 1e-7);
}
