#include "stress/maximum.hpp"

#include "layer.hpp"
#include "stress/hertz.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

constexpr double hertz_value = 0.620041004, hertz_depth = 0.480864;

// h²/12 of the Laplacian of the stress (see layers.cpp) changes the von Mises stress by this much at its
// maximum; on the axis the tensor is diagonal with xx = yy, so that von Mises is |xx - zz|.
double predicted_error(double h) {
  constexpr double step = 2e-3;
  auto value = [](double x) {
    const stress::Tensor s = hertz_stress(x, 0, hertz_depth, 0.3);
    return 0.5 * (s[stress::xx] + s[stress::yy]) - s[stress::zz];
  };
  return h * h / 12 * 4 * (value(step) - value(0)) /
         (step * step);  // ∇² = 4 f'' on the axis, f(x) = f0 + f'' x²
}

StressMaximum hertz_maximum(const Grid& grid) {
  return maximum_von_mises(StressSolver(grid, hertz_pressure(grid), 0.3));
}

// The largest value at a cell centre over many depths.
double brute_force(const StressSolver& solver, double shallowest, double deepest, int layers) {
  std::vector<double> depths, top(static_cast<std::size_t>(layers), 0.0);
  for (int k = 0; k < layers; ++k)
    depths.push_back(shallowest * std::pow(deepest / shallowest, k / (layers - 1.0)));
  std::vector<double> row(static_cast<std::size_t>(solver.grid().shape.ny));
  solver.layers(depths, stress::all, [&](Index l, Index, const StressRow& s) {
    von_mises(s, solver.grid().shape.ny, row.data());
    for (double value : row)
      top[static_cast<std::size_t>(l)] = std::max(top[static_cast<std::size_t>(l)], value);
  });
  return *std::max_element(top.begin(), top.end());
}

}  // namespace

// Besides the stress's own error the parabolas in z leave 2e-5.
TEST_CASE("the maximum of a Hertz contact is found with the truncation error of the stress at its place",
          "[maximum][order]") {
  for (Index n : {32, 64, 128}) {
    const Grid grid = hertz_grid(n);
    const StressMaximum found = hertz_maximum(grid);
    CAPTURE(n, found.von_mises, found.depth);
    CHECK(found.von_mises - hertz_value == Approx(predicted_error(grid.dx)).epsilon(0.05).margin(2e-5));
    CHECK(relative_error(found.depth, hertz_depth) <= 0.005);
  }
}

// The parabola through three points of a smooth even peak off by s h finds s h up to h³: percents of a cell.
TEST_CASE("the place of the maximum is found between the cell centres", "[maximum][law]") {
  for (auto [sx, sy] : {std::pair{0.0, 0.0}, std::pair{0.3, -0.4}, std::pair{0.5, 0.5}}) {
    const Grid grid{{50, 64}, 0.06, 0.05};
    const double cx = sx * grid.dx, cy = sy * grid.dy;
    const Field p = sample(grid, [&](double x, double y) {
      return std::sqrt(std::max(0.0, 1 - (x - cx) * (x - cx) - (y - cy) * (y - cy)));
    });
    const StressMaximum found = maximum_von_mises(StressSolver(grid, p, 0.3));
    CAPTURE(sx, sy, found.x, found.y);
    CHECK(std::abs(found.x - cx) <= 0.03 * grid.dx);
    CHECK(std::abs(found.y - cy) <= 0.03 * grid.dy);
  }
}

// One loaded cell on top of a contact puts a second maximum within a cell of the surface.
TEST_CASE("of two maxima at different depths the larger is found", "[maximum][law]") {
  const Grid grid = hertz_grid(48);
  for (double spike : {0.2, 0.6, 3.0}) {
    Field p = hertz_pressure(grid);
    p(20, 30) += spike;
    const StressSolver solver(grid, p, 0.3);
    const double scanned = brute_force(solver, 0.25 * grid.dx, 1.5, 120);
    const StressMaximum found = maximum_von_mises(solver);
    CAPTURE(spike, scanned, found.von_mises, found.depth);
    CHECK(found.von_mises >= (1 - 2e-3) * scanned);
    CHECK(found.von_mises <= 1.02 * scanned);  // between the centres it is a little higher
  }
}

TEST_CASE("the maximum scales with the pressure and does not depend on the number of threads",
          "[maximum][law]") {
  const Grid grid = hertz_grid(32);
  const Field p = hertz_pressure(grid);
  const StressMaximum one = maximum_von_mises(StressSolver(grid, p, 0.3, 1)),
                      twice = maximum_von_mises(StressSolver(grid, 2 * p, 0.3, 3));
  CHECK(twice.von_mises == 2 * one.von_mises);
  CHECK(twice.depth == one.depth);
}

TEST_CASE("an unloaded surface has its maximum zero", "[maximum][contract]") {
  const Grid grid = hertz_grid(8);
  CHECK(maximum_von_mises(StressSolver(grid, Field::Zero(8, 8), 0.3)).von_mises == 0);
}
