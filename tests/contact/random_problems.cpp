#include <algorithm>

#include "core/error.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

struct Draw {
  std::mt19937_64 generator;
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(generator); }
  double decade(double a, double b) { return std::pow(10, uniform(a, b)); }
};

struct Problem {
  Grid grid;
  Field gap;
  ContactParameters parameters;
};

// Every fourth on cells of aspect 0.02 to 50, every sixth periodic; roughness of 10 nm to 10 µm on spheres of
// 3 mm to 1 m or, every fifth, on flats; loads of 0.01 N to 50 kN; three in five with a limit pressure, of
// 0.1 to 30 GPa or from just above the mean to ten times it.
Problem draw(unsigned k) {
  Draw draw{std::mt19937_64(1000 + k)};
  const Shape shape{k % 3 == 2 ? 64 : 32, k % 5 == 0 ? 32 : k % 7 == 0 ? 45 : 64};
  const double dx = 3e-3 / static_cast<double>(shape.nx), aspect = k % 4 == 1 ? draw.decade(-1.7, 1.7) : 1;
  const Grid grid{shape, dx, dx * aspect, k % 6 == 5};
  const double curvature = grid.periodic.both() || k % 5 == 1 ? 0 : 1 / draw.decade(-2.5, 0),
               rms = draw.decade(-8, -5);
  const Field round = sample(grid, [&](double x, double y) { return curvature / 2 * (x * x + y * y); });
  ContactParameters parameters{.load = draw.decade(-2, 4.7), .tolerance = 1e-8};
  const double mean = parameters.load / (grid.size_x() * grid.size_y());
  if (draw.uniform(0, 1) < 0.6)
    parameters.limit_pressure = k % 2 == 0 ? draw.decade(8, 10.5) : mean * (1 + draw.decade(-3, 1));
  return {grid, round - rms * random_waves(shape, k), parameters};
}

bool is_feasible(const Problem& p) {
  return p.parameters.load <= p.parameters.limit_pressure * p.grid.size_x() * p.grid.size_y();
}

}  // namespace

TEST_CASE("500 random problems end at a residual of 1e-8 within bounds and load, or name the largest load",
          "[contact][law][slow]") {
  std::vector<double> work;
  for (unsigned k = 0; k < 500; ++k) {
    const Problem problem = draw(k);
    const auto& [grid, gap, parameters] = problem;
    CAPTURE(k, grid.shape.nx, grid.shape.ny, grid.dy / grid.dx, grid.periodic.x, grid.periodic.y,
            parameters.load, parameters.limit_pressure);
    if (!is_feasible(problem)) {
      CHECK_THROWS_AS(solve_contact(grid, gap, modulus, parameters), ParameterError);
      continue;
    }
    const Contact contact = solve_contact(grid, gap, modulus, parameters);
    CAPTURE(contact.convolutions, contact.reason, contact.residual);
    CHECK(contact.converged);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.load_residual <= 1e-12);
    CHECK(contact.pressure.minCoeff() >= 0);
    CHECK(contact.pressure.maxCoeff() <= parameters.limit_pressure);
    work.push_back(contact.convolutions);
  }
  // What the solver is known for; a loss of either is a loss of its method.
  std::sort(work.begin(), work.end());
  const std::size_t n = work.size();
  CAPTURE(n, work[n / 2], work[9 * n / 10], work.back());
  CHECK(n >= 450);
  CHECK(work[n / 2] <= 12);
  CHECK(work[9 * n / 10] <= 36);
  CHECK(work.back() <= 400);
}

// The approach of the load that was drawn, given in its place: same contact.
TEST_CASE("80 random problems have the load that was pressed when sunk by the approach it had",
          "[contact][law]") {
  for (unsigned k = 0; k < 500; k += 6) {  // none periodic
    Problem problem = draw(k);
    if (!is_feasible(problem)) continue;
    const Contact loaded = solve_contact(problem.grid, problem.gap, modulus, problem.parameters);
    if (loaded.plastic_area >= 0.9999 * problem.grid.size_x() * problem.grid.size_y()) continue;  // δ is any
    problem.parameters.load = 0;
    problem.parameters.approach = loaded.approach;
    const Contact sunk = solve_contact(problem.grid, problem.gap, modulus, problem.parameters);
    CAPTURE(k, sunk.convolutions, loaded.convolutions, sunk.residual, sunk.reason, loaded.load, sunk.load);
    CHECK(sunk.converged);
    // ε of the range of displacements over the approach's own, for a body stiffer than its cells' own.
    CHECK(relative_error(sunk.load, loaded.load) <= 1e-5);
  }
}
