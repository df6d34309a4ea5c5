// The outline of cells: sides counted by hand, areas against the circle's.
#include "contact/outline.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double pi = std::numbers::pi;

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
