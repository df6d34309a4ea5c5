#include <limits>
#include <numbers>
#include <random>

#include "contact/bodies.hpp"
#include "contact/influence.hpp"
#include "contact/solver.hpp"
#include "contact_scenes.hpp"
#include "stability.hpp"

namespace asperity {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = NAN;
constexpr double tolerance = 1e-8;

struct Pressed {
  Grid grid;
  Field gap;
  double modulus = scene_bodies.composite_modulus(), load = scene_load, limit = infinity;

  explicit Pressed(const ContactScene& scene)
      : grid(scene.grid),
        gap(scene.gap),
        modulus(scene.composite_modulus),
        load(scene.load),
        limit(scene.limit_pressure) {}
  Pressed(const Grid& on, Field undeformed) : grid(on), gap(std::move(undeformed)) {}
  double mean_pressure() const { return load / (grid.size_x() * grid.size_y()); }
  Contact contact() const {
    return solve_contact(grid, gap, modulus, {.load = load, .limit_pressure = limit, .tolerance = tolerance});
  }
};

Grid square(Index nx, Index ny, double side = 3e-3) {
  return {{nx, ny}, side / static_cast<double>(nx), side / static_cast<double>(ny)};
}

Field white(Shape shape, double rms) {
  std::mt19937_64 generator(3);
  std::normal_distribution<double> normal(0, rms);
  return Field::NullaryExpr(shape.nx, shape.ny, [&](Index, Index) { return normal(generator); });
}

bool finite(const Contact& c) {
  return c.pressure.isFinite().all() && c.gap.isFinite().all() && c.displacement.isFinite().all() &&
         std::isfinite(c.approach);
}

std::string outcome_of(const Contact& c) { return c.converged ? "converged" : "not converged: " + c.reason; }

// Bounds exact, load to 1e-12, and the residual.
Finding residual(const Pressed& problem) {
  const Contact c = problem.contact();
  const bool kept = finite(c) && c.pressure.minCoeff() >= 0 && c.pressure.maxCoeff() <= problem.limit &&
                    c.load_residual <= 1e-12;
  return {outcome_of(c), "residual", kept ? c.residual : nan, tolerance};
}

void loads(const StabilityTable& table) {
  for (double load : {1e-5, 1e-3, 0.1, 10.0, 1e3, 1e5})
    for (const char* scene : {"smooth", "rough"})
      table.answered(fmt::format("{} spheres, {:g} N", scene, load), "loads over ten decades", [&] {
        Pressed p(contact_scene(scene, 64));
        p.load = load;
        return residual(p);
      });
  for (double load : {1e-300, 1e100})
    table.answered(fmt::format("smooth spheres, {:g} N", load), "far beyond any load", [&] {
      Pressed p(contact_scene("smooth", 64));
      p.load = load;
      return residual(p);
    });
  for (double load : {0.0, -1.0, 1e305, infinity, nan})
    table.refused(fmt::format("a load of {:g} N", load), "no load", [&] {
      Pressed p(contact_scene("smooth", 32));
      p.load = load;
      p.contact();
    });
}

void limits(const StabilityTable& table) {
  for (double factor : {1.0, 1.001, 1.1, 2.0, 5.0, 20.0, 1e6, infinity})
    table.answered(fmt::format("rough spheres, limit {:g} x mean pressure", factor),
                   factor < 2 ? "nearly every cell at its limit" : "limit pressure over decades", [&] {
                     Pressed p(contact_scene("rough", 64));
                     p.limit = factor * p.mean_pressure();
                     return residual(p);
                   });
  for (double factor : {0.999, 0.0, -1.0, nan})
    table.refused(fmt::format("limit {:g} x mean pressure", factor), "nothing carries the load", [&] {
      Pressed p(contact_scene("rough", 64));
      p.limit = factor * p.mean_pressure();
      p.contact();
    });
}

// p̄ + p* cos 2πx/L, p* = πE*D/L, on a wave of amplitude D that is pressed flat.
Finding westergaard() {
  Grid grid = square(64, 64, 1);
  grid.periodic = true;
  const double D = 1e-3, modulus = 1, flat = std::numbers::pi * D;
  Pressed p(grid,
            sample(grid, [&](double x, double) { return D * (1 - std::cos(2 * std::numbers::pi * x)); }));
  p.modulus = modulus, p.load = 1.001 * flat;
  const Contact c = p.contact();
  const Field exact =
      sample(grid, [&](double x, double) { return p.load + flat * std::cos(2 * std::numbers::pi * x); });
  return {outcome_of(c), "error of p", (c.pressure - exact).abs().maxCoeff() / flat, 1e-10};
}

void extents(const StabilityTable& table) {
  table.answered("wave pressed flat, 1.001 x full contact", "full contact, 1e-3 from its end", westergaard);
  table.answered("self-affine, 90 % in contact", "nearly full contact",
                 [] { return residual(Pressed(contact_scene("C90", 64))); });
  table.answered("flat on flat", "every cell, the pressure infinite at the edge",
                 [] { return residual(Pressed(square(64, 64), Field::Zero(64, 64))); });
  table.answered("flat on flat, periodic", "nothing varies", [] {
    Grid grid = square(64, 64);
    grid.periodic = true;
    return residual(Pressed(grid, Field::Zero(64, 64)));
  });
  table.answered("one cell 1 m above the others", "one cell in contact", [] {
    Field gap = Field::Zero(64, 64);
    gap(20, 41) = -1;
    Pressed p(square(64, 64), gap);
    const Contact c = p.contact();
    const double exact = p.load / p.grid.cell_area() *
                         make_influence(p.grid, p.modulus)->self_influence();  // u of the cell itself
    return Finding{outcome_of(c), "error of u", std::abs(c.displacement(20, 41) / exact - 1), 1e-12};
  });
  table.answered("two equal peaks, 1 m high", "two cells in contact, symmetric", [] {
    Field gap = Field::Zero(64, 64);
    gap(10, 10) = gap(53, 53) = -1;
    const Contact c = Pressed(square(64, 64), gap).contact();
    return Finding{outcome_of(c), "difference of p", std::abs(c.pressure(10, 10) / c.pressure(53, 53) - 1),
                   1e-8};
  });
}

void grids(const StabilityTable& table) {
  auto spheres = [&](const char* name, const char* hard, const Grid& grid) {
    table.answered(name, hard, [&] { return residual(Pressed(grid, undeformed_gap(grid, scene_bodies))); });
  };
  spheres("1 x 128 cells", "one row", square(1, 128));
  spheres("128 x 1 cells", "one column", square(128, 1));
  spheres("1 x 1 cell", "one cell", square(1, 1));
  spheres("2 x 3 cells", "fewer than a stencil", square(2, 3));
  spheres("127 x 131 cells", "primes", square(127, 131));
  spheres("128 x 64 cells", "powers of two", square(128, 64));
  spheres("450 x 9 cells", "pixel aspect 50", square(450, 9));
  spheres("9 x 450 cells", "pixel aspect 1/50", square(9, 450));
  table.answered("noise on 90 x 90 cells", "pixel aspect 50, white heights", [] {
    const Grid grid{{90, 90}, 1e-6, 50e-6};
    Pressed p(grid, white(grid.shape, 1e-7));
    p.load = 10;
    return residual(p);
  });
}

void heights(const StabilityTable& table) {
  for (double rms : {1e-12, 1e-6, 1.0, 1e3})
    table.answered(fmt::format("white noise of {:g} m", rms), "scale of the heights", [&] {
      return residual(Pressed(square(64, 64), white({64, 64}, rms)));
    });
  table.answered("white noise of 1e-310 m", "denormal heights", [] {
    return residual(Pressed(square(64, 64), white({64, 64}, 1e-310)));
  });
  for (double offset : {0.4, 1e3})
    table.answered(fmt::format("rough spheres, offset {:g} m", offset),
                   offset < 1 ? "offset of 1e6 rms" : "offset of 2.5e9 rms", [&] {
                     Pressed p(contact_scene("rough", 64));
                     const Field plain = p.contact().pressure;
                     p.gap += offset;
                     const Contact c = p.contact();
                     // The gap itself is rounded to ε of the offset.
                     return Finding{outcome_of(c), "change of p_max",
                                    std::abs(c.max_pressure / plain.maxCoeff() - 1),
                                    offset < 1 ? 1e-6 : 1e-3};
                   });
  for (double height : {infinity, -infinity, nan})
    table.refused(fmt::format("a height of {}", height), "no height", [&] {
      Pressed p(contact_scene("rough", 32));
      p.gap(3, 4) = height;
      p.contact();
    });
}

void bodies(const StabilityTable& table) {
  auto hertz_of = [&](const char* name, const char* hard, const Bodies& b) {
    table.answered(name, hard, [&] {
      const Hertz exact = hertz(b, scene_load);
      const Grid grid = square(64, 64, 3 * exact.radius);
      Pressed p(grid, undeformed_gap(grid, b));
      p.modulus = b.composite_modulus();
      const Contact c = p.contact();
      return Finding{outcome_of(c), "error of p_max", std::abs(c.max_pressure / exact.pressure - 1), 1e-3};
    });
  };
  Bodies b = scene_bodies;
  b.young = {infinity, 208e9};
  hertz_of("one body rigid", "infinite modulus", b);
  b.young = {1.0, 1e15};
  hertz_of("1 Pa against 1e15 Pa", "moduli fifteen decades apart", b);
  b = scene_bodies;
  b.poisson = {0.0, 0.5};
  hertz_of("nu = 0 and 0.5", "the ends of its range", b);
  b.radius = {-50.001e-3, 50e-3};
  hertz_of("ball in a socket", "curvatures cancel but for 2e-5", b);
  auto not_bodies = [&](const char* name, const char* hard, auto set) {
    table.refused(name, hard, [&] {
      Bodies wrong = scene_bodies;
      set(wrong);
      wrong.check();
    });
  };
  not_bodies("both bodies rigid", "nothing yields", [](Bodies& w) { w.young = {infinity, infinity}; });
  not_bodies("nu = 0.51", "beyond incompressible", [](Bodies& w) { w.poisson = {0.51, 0.3}; });
  not_bodies("nu = NaN", "no number", [](Bodies& w) { w.poisson = {nan, 0.3}; });
  not_bodies("a ball larger than its socket", "composite curvature negative", [](Bodies& w) {
    w.radius = {-49e-3, 50e-3};
  });
}

}  // namespace

void contact_stability() {
  const StabilityTable table("contact");
  loads(table);
  limits(table);
  extents(table);
  grids(table);
  heights(table);
  bodies(table);
}

}  // namespace asperity
