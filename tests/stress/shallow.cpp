/// What the search for the largest stress leaves out is lower, and what it starts from is there.
#include <random>

#include "layer.hpp"
#include "stress/points.hpp"
#include "stress/search.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// Caps of several sizes on a square of 96 cells, the last the highest.
Field caps(const Grid& grid, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<> uniform;
  Field p = Field::Zero(grid.shape.nx, grid.shape.ny);
  for (int k = 0; k < 8; ++k) {
    const double r = 2 + 8 * uniform(random), top = 0.7 + 0.3 * uniform(random),
                 x0 = 80 * uniform(random) - 40, y0 = 80 * uniform(random) - 40;
    p = p.max(sample(grid, [&](double x, double y) {
      return top * std::sqrt(std::max(0.0, 1 - ((x - x0) * (x - x0) + (y - y0) * (y - y0)) / (r * r)));
    }));
  }
  return p;
}

}  // namespace

// Half of them are discs, which without friction bear most.
TEST_CASE("no random pattern of loads exceeds the bound of patterns", "[maximum][law]") {
  std::mt19937 random(3);
  std::uniform_real_distribution<> uniform;
  const LoadedBody body{{{64, 64}, 1, 1}, Field::Zero(64, 64), 0.3, {0.3, 0.4}};
  for (double z : {0.0, 0.5, 2.0, 8.0})
    for (Criterion of : {Criterion::von_mises, Criterion::max_shear, Criterion::principal}) {
      const NearKernel kernel(body, 1, near_reach, z);
      const double bound = kernel.largest(of);
      for (int k = 0; k < 40; ++k) {
        const double qx = 3 * uniform(random), qy = 3 * uniform(random), phase = 7 * uniform(random),
                     radius = 16 * uniform(random);
        stress::Tensor s{};
        for (Index i = -near_reach; i <= near_reach; ++i)
          for (Index j = -near_reach; j <= near_reach; ++j) {
            const auto u = static_cast<double>(i), v = static_cast<double>(j);
            const bool on = k % 2 == 0 ? std::cos(qx * u + qy * v + phase) > 0 : std::hypot(u, v) < radius;
            for (auto c : stress::components)
              if (on) s[c] += kernel.at(i, j)[c];
          }
        CHECK(equivalent_stress(of, s) <= bound * (1 + 1e-9));
      }
    }
}

// Far parts are those of cells four times as wide, good to a per cent of the largest pressure.
TEST_CASE("the shallow search finds the largest value of each layer that may hold the largest of all",
          "[maximum][law]") {
  for (Periodic periodic : {Periodic{}, Periodic{true, false}})
    for (const Friction& friction : {Friction{}, Friction{0.4, 0.5}}) {
      const Grid grid{{96, 96}, 1, 1, periodic};
      const LoadedBody body{grid, caps(grid, 5), 0.3, friction};
      const std::vector<double> depths{1, 2, 4, 8};
      const auto found = ShallowSearch::maxima(body, Criterion::von_mises, depths,
                                               -std::numeric_limits<double>::infinity(), 1);
      const auto layers = maximum_by_depth(StressSolver(body), Criterion::von_mises, depths);
      const double top = std::ranges::max_element(layers, {}, &StressMaximum::value)->value;
      for (const StressMaximum& layer : layers) {
        if (layer.value < 0.98 * top) continue;
        double value = 0;
        for (const LayerMaximum& m : found) value = std::max(value, m.value);
        CAPTURE(friction.coefficient, periodic.x, layer.depth, layer.value, value);
        CHECK(value >= layer.value - 0.01);
      }
    }
}

// Values of the field at points 1e-3 of the depth beside the place fall as the square of that, 1e-6.
TEST_CASE("the largest stress of several contacts is a maximum of the field, to 1e-6, the highest of all",
          "[maximum][law]") {
  for (int seed : {1, 2, 3, 4})
    for (double friction : {0.0, 0.15}) {
      const Grid grid{{96, 96}, 1, 1};
      const LoadedBody body{grid, caps(grid, seed), 0.3, {friction, 0.5}};
      const StressMaximum found = maximum_stress(StressSolver(body));
      const StressPoints points(body);
      auto value = [&](double x, double y, double z) { return von_mises(points.at(x, y, z)); };
      CAPTURE(seed, friction, found.x, found.y, found.depth, found.value);
      REQUIRE(found.depth >= 1);
      CHECK(relative_error(value(found.x, found.y, found.depth), found.value) <= 1e-9);
      for (int axis = 0; axis < 3; ++axis)
        for (double step : {-0.01, 0.01}) {
          const double d = step * found.depth;
          CHECK(value(found.x + (axis == 0) * d, found.y + (axis == 1) * d, found.depth + (axis == 2) * d) <=
                found.value * (1 + 1e-7));
        }
      std::vector<double> depths;
      for (double z = 1; z < 30; z *= 1.05) depths.push_back(z);
      for (const StressMaximum& layer : maximum_by_depth(StressSolver(body), Criterion::von_mises, depths))
        CHECK(value(layer.x, layer.y, layer.depth) <= found.value * (1 + 1e-6));
    }
}

// Steps of 4 % in depth leave 2 (0.02)² of a maximum that falls by its own value over a depth, 1e-3.
TEST_CASE("of long cells no column bears more than the largest stress", "[maximum][law]") {
  for (int seed = 1; seed <= 8; ++seed) {
    const Grid grid{{44, 40}, 1, 12};
    LoadedBody body{grid, Field::Zero(44, 40), 0.3, {}};
    const Field square = caps({{44, 44}, 1, 1}, seed);
    body.pressure = square.leftCols(40);
    const StressSolver solver(body);
    const StressMaximum found = maximum_stress(solver);
    double top = 0;
    for (double z = 0.1; z < 12; z *= 1.04) {
      const TensorField field = layer(solver, z);
      for (Index i = 0; i < 44; ++i)
        for (Index j = 0; j < 40; ++j) top = std::max(top, von_mises(tensor_at(field, i, j)));
    }
    CAPTURE(seed, found.x, found.y, found.depth, found.value, top);
    CHECK(found.value >= top * (1 - 1e-7));
    CHECK(found.depth < 12);
    CHECK(found.value <= top * (1 + 1e-3));
  }
}

namespace {

// The largest value at the cells' centres in layers from one depth to another, each a factor deeper.
double largest_of_layers(const StressSolver& solver, double from, double to, double factor) {
  std::vector<double> depths;
  for (double z = from; z < to; z *= factor) depths.push_back(z);
  double top = 0;
  solver.layers(depths, stress::all, [&](Index, Index, const StressRow& row) {
    std::vector<double> values(row[0].size());
    von_mises(row, values);
    top = std::max(top, std::ranges::max(values));
  });
  return top;
}

}  // namespace

// Far parts of tiles, from the waves through wide cells, were 3 % of a step of the pressure off, and a maximum
// that is 1.5 % higher lay below a wrong one: 0.39727 in place of 0.40319.
TEST_CASE("below a load that repeats along both axes no column bears more than the largest stress",
          "[maximum][law]") {
  const Grid grid{{96, 84}, 1, 1.77, {true, true}};
  Field p = Field::Zero(96, 84);
  for (const auto& [r, top, cx, cy] :
       {std::array{7.8113, 0.9912, 0.683, 33.736}, std::array{10.8985, 0.9817, -29.61, -18.322},
        std::array{13.5276, 0.9811, 35.804, -39.619}})
    p = p.max(sample(grid, [r = r, top = top, cx = cx, cy = cy](double x, double y) {
      return top * std::sqrt(std::max(0.0, 1 - ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (r * r)));
    }));
  const double from = 1.819;
  const StressSolver solver({grid, p.min(0.6 * p.maxCoeff()), 0.3});
  const double found = maximum_stress(solver, {Criterion::von_mises, from}).value,
               columns = largest_of_layers(solver, from, 20, 1.03);
  CAPTURE(found, columns);
  CHECK(found >= columns * (1 - 1e-7));
  CHECK(found <= columns * 1.01);  // between the centres of long cells
}

// At its trailing edge many columns bear nearly the same a few hundredths of a cell deep; the search left all
// but one below that one's estimate, 0.7525 for 0.7542.
TEST_CASE("of a sliding contact no column near the surface bears more than the largest stress",
          "[maximum][law]") {
  const Grid grid{{128, 128}, 3.205 / 128, 3.205 / 128};
  const Field p =
      sample(grid, [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); });
  const StressSolver solver({grid, p, 0.3, {0.4, 0}});
  const StressMaximum found = maximum_stress(solver);
  const double columns = largest_of_layers(solver, 0.03 * grid.dx, 0.06 * grid.dx, 1.05);
  CAPTURE(found.value, found.depth / grid.dx, columns);
  CHECK(found.value >= columns * (1 - 1e-7));
  CHECK(found.value <= columns * (1 + 1e-3));
}

// The search is good to 1e-6 of either. Without its rule for maxima that recur it refines all 64.
TEST_CASE("the largest stress of a pattern is that of one period", "[maximum][law]") {
  for (double friction : {0.0, 0.3}) {
    auto largest = [&](Index periods) {
      const Index n = 16 * periods;
      const Grid grid{{n, n}, 1, 1, {true, true}};
      Field p(n, n);
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
          const double x = static_cast<double>(i % 16) - 7.3, y = static_cast<double>(j % 16) - 7.6;
          p(i, j) = std::sqrt(std::max(0.0, 1 - (x * x + 0.7 * y * y) / 25));
        }
      return maximum_stress(StressSolver({grid, p, 0.3, {friction, 0.5}})).value;
    };
    CHECK(relative_error(largest(8), largest(1)) <= 2e-6);
  }
}
