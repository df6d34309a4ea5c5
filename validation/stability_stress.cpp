#include <limits>

#include "reference/hertz_stress.hpp"
#include "stability.hpp"
#include "stress/maximum.hpp"
#include "stress/points.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = NAN;

// A hill of pressure with steps, not symmetric, between 0 and 1.
Field hill(Shape shape) {
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index i, Index j) {
    const double x = static_cast<double>(i + 1) / static_cast<double>(shape.nx + 1),
                 y = static_cast<double>(j + 1) / static_cast<double>(shape.ny + 1);
    return (i + 2 * j) % 3 == 1 ? 0.0 : 16 * x * x * y * (1 - x) * (1 - y);
  });
}

// The layer at some cells against the sum over all cells, per greatest pressure.
double layer_error(const Grid& grid, const Field& p, double z, double nu, const Friction& friction) {
  const StressSolver solver({grid, p, nu, friction});
  const StressPoints points({grid, p, nu, friction});
  StressSolver::Workspace work;
  const double scale = p.maxCoeff();
  double worst = 0;
  solver.layer(z, stress::all, work, [&](Index i, const StressRow& row) {
    if (i % std::max<Index>(1, grid.shape.nx / 3) != 0) return;
    for (Index j = 0; j < grid.shape.ny; j += std::max<Index>(1, grid.shape.ny / 3)) {
      const stress::Tensor exact = points.at(grid.x(i), grid.y(j), z);
      for (auto c : stress::components) {
        const double error = std::abs(row[c][static_cast<std::size_t>(j)] - exact[c]) / scale;
        worst = error <= worst ? worst : error;  // and NaN
      }
    }
  });
  return worst;
}

// stress/layers.hpp: round-off below 16 ε Σ|p|, of pressures up to 1.
double round_off(const Grid& grid) {
  return 16 * std::numeric_limits<double>::epsilon() * static_cast<double>(grid.shape.cells());
}

struct Load {
  std::string name;
  const char* hard;
  Grid grid;
  double depth = 1;  ///< in units of the longer side of a cell
  double nu = 0.3, scale = 1;
  Friction friction = {};
};

void against_sums(const StabilityTable& table, const Load& l) {
  table.answered(l.name, l.hard, [&] {
    const Field p = l.scale * hill(l.grid.shape);
    const double z = l.depth * std::max(l.grid.dx, l.grid.dy);
    return Finding{"computed", "error / p_max", layer_error(l.grid, p, z, l.nu, l.friction),
                   round_off(l.grid)};
  });
}

void layers(const StabilityTable& table) {
  const Grid plain{{24, 20}, 1e-5, 1e-5};
  for (double nu : {-0.99, 0.0, 0.5})
    against_sums(table, {fmt::format("nu = {:g}", nu), "the ends of its range", plain, 1, nu});
  for (double depth : {0.0, 1e-12, 1e-6, 1e-2, 1e3, 1e9, 1e30})
    against_sums(table, {fmt::format("depth {:g} cells", depth),
                         depth == 0  ? "surface: limits of the corner functions"
                         : depth < 1 ? "near the surface"
                                     : "rectangles far away: corners cancel",
                         plain, depth});
  against_sums(table, {"pixel aspect 50", "flat cells", {{24, 20}, 50e-6, 1e-6}, 0.02});
  against_sums(table, {"pixel aspect 1/50", "flat cells", {{24, 20}, 1e-6, 50e-6}, 0.02});
  against_sums(table, {"1 x 64 cells", "one row", {{1, 64}, 1e-5, 1e-5}});
  against_sums(table, {"64 x 1 cells", "one column", {{64, 1}, 1e-5, 1e-5}});
  against_sums(table, {"1 x 1 cell", "one cell", {{1, 1}, 1e-5, 1e-5}});
  against_sums(table, {"31 x 37 cells", "primes", {{31, 37}, 1e-5, 1e-5}});
  against_sums(table, {"32 x 64 cells", "powers of two", {{32, 64}, 1e-5, 1e-5}});
  for (double scale : {1e-99, 1e99})
    against_sums(
        table, {fmt::format("pressure of {:g} Pa", scale), "far beyond any pressure", plain, 1, 0.3, scale});
  for (double side : {1e-12, 1e3})
    against_sums(table, {fmt::format("cells of {:g} m", side), "scale of lengths", {{24, 20}, side, side}});
  against_sums(table,
               {"friction 1e3", "traction a thousand times the pressure", plain, 1, 0.3, 1, {1e3, 0.6}});
}

// 64 cells on three radii of Hertz's contact: the search's 3e-5 and the cells' 0.25 (Δx/a)².
void maxima(const StabilityTable& table) {
  const Grid grid{{64, 64}, 3.0 / 64, 3.0 / 64};
  const Field hertz = hertz_pressure(grid);
  for (double scale : {1e-99, 1e9, 1e99})
    table.answered(fmt::format("Hertz's maximum, p_0 = {:g} Pa", scale), "squares of stresses", [&] {
      const StressMaximum m = maximum_stress(StressSolver({grid, scale * hertz, 0.3}));
      return Finding{"found", "error", std::abs(m.value / scale / 0.620041004 - 1), 6e-4};
    });
  table.answered("no pressure at all", "nothing to find", [&] {
    const StressMaximum m = maximum_stress(StressSolver({grid, Field::Zero(64, 64), 0.3}));
    return Finding{"zero", "stress", m.value, 0};
  });
  table.answered("one loaded cell", "the maximum a fraction of a cell deep", [&] {
    Field p = Field::Zero(64, 64);
    p(0, 63) = 1;
    const StressMaximum m = maximum_stress(StressSolver({grid, p, 0.3}));
    const double off = std::max(std::abs(m.x - grid.x(0)), std::abs(m.y - grid.y(63))) / grid.dx;
    return Finding{fmt::format("found {:.2f} cells deep", m.depth / grid.dx), "cells beside it", off, 0.5};
  });
}

void refusals(const StabilityTable& table) {
  const Grid grid{{8, 8}, 1, 1};
  const Field one = Field::Ones(8, 8);
  for (double nu : {-1.0, 0.51, nan})
    table.refused(fmt::format("nu = {}", nu), "outside -1 ... 0.5", [&] { StressSolver({grid, one, nu}); });
  for (double z : {-1.0, infinity, nan})
    table.refused(fmt::format("depth {} m", z), "no depth", [&] { check_depth(z); });
  for (double p : {1e300, infinity, nan})
    table.refused(fmt::format("a pressure of {:g}", p), "squares of stresses", [&] {
      Field wrong = one;
      wrong(1, 2) = p;
      StressSolver({grid, wrong, 0.3});
    });
  table.refused("friction -1", "negative", [&] { StressSolver({grid, one, 0.3, {-1, 0}}); });
  table.refused("8 x 7 pressures on 8 x 8 cells", "shapes differ", [&] {
    StressSolver({grid, one.leftCols(7), 0.3});
  });
}

}  // namespace

void stress_stability() {
  const StabilityTable table("stress");
  layers(table);
  maxima(table);
  refusals(table);
}

}  // namespace asperity
