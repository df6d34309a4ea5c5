// How the slope grows from grid to grid: closed forms of a wave and of white noise.
#include "stats/hybrid/slopes.hpp"

#include <cmath>
#include <numbers>

#include "math/noise.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Field white(Shape shape) {
  Field out(shape.nx, shape.ny);
  WhiteNoise noise(7);
  for (Index i = 0; i < out.rows(); ++i) noise.row(i, {out.row(i).data(), size(out.cols())});
  return out;
}

}  // namespace

// Means over h₁ = 2h and 4h of a wave keep cos(q h/2), cos(q h/2) cos(q h) of it, and neighbours at a distance H show
// (2/H)² sin²(qH/2)/2 of its square.
TEST_CASE("a wave grows by the transfer functions of means and differences", "[hybrid][exact]") {
  const double pi = std::numbers::pi;
  for (Index cells :
       {16, 32, 64}) {  // no wave of two points on the coarsest grid, whose square depends on its place
    const double q = 2 * pi / static_cast<double>(cells);
    const Grid grid{{64, 64}, 1, 1, true};
    const Field z = sample(grid, [q](double x, double) { return std::cos(q * x + 0.3); });
    auto slope = [q](double width, double left) {
      return std::pow(left * 2 / width * std::sin(q * width / 2), 2);
    };
    const double s1 = slope(1, 1), s2 = slope(2, std::cos(q / 2)),
                 s4 = slope(4, std::cos(q / 2) * std::cos(q));
    CHECK(slope_growth(z, grid).gamma == Approx((s1 - s2) / (s2 - s4)).epsilon(1e-9));
  }
}

// Of white noise each coarser grid keeps a quarter of the variance over four times the squared spacing: s² falls by 16.
TEST_CASE("white noise grows by sixteen and is not resolved, a smooth cap is", "[hybrid][law]") {
  const Grid grid{{256, 256}, 1e-6, 1e-6, true};
  // The mean of 16 384 squares scatters by √(2/16 384) = 1.1 % or so.
  const SlopeGrowth noise = slope_growth(white(grid.shape), grid);
  CHECK(noise.gamma == Approx(16).epsilon(0.06));
  CHECK(noise.resolved() == Resolved::no);
  const Grid free{{128, 96}, 1e-6, 2e-6};
  const Field cap = sample(free, [](double x, double y) { return 4 * x * x - 3 * y * y + x + 1e-4; });
  CHECK(slope_growth(cap, free).resolved() == Resolved::yes);
  CHECK(slope_growth(Field::Zero(64, 64), {{64, 64}, 1, 1}).gamma == 0);
  CHECK(std::isnan(slope_growth(Field::Zero(8, 64), {{8, 64}, 1, 1}).gamma));
  // An odd line is left out.
  CHECK(slope_growth(white({129, 67}), {{129, 67}, 1, 1, true}).resolved() == Resolved::no);
}
