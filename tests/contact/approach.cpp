#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// A surface of its own for each kind of problem, and the load that is pressed on it.
struct Case {
  const char* name;
  Grid grid;
  Field gap;
  ContactParameters parameters;
};

std::vector<Case> cases() {
  const Grid grid = square(64);
  const Field waves = 1e-6 * random_waves(grid.shape, 3);
  return {{"smooth", grid, undeformed_gap(grid, spheres), {.load = load, .tolerance = 1e-10}},
          {"rough", grid, rough_gap(grid), {.load = load, .tolerance = 1e-10}},
          {"capped", grid, rough_gap(grid), {.load = load, .limit_pressure = limit, .tolerance = 1e-10}},
          {"periodic", periodic(grid), -waves, {.load = 500, .tolerance = 1e-10}},
          {"flat", grid, Field::Zero(64, 64), {.load = load, .tolerance = 1e-10}}};
}

Contact solve(const Case& c) { return solve_contact(c.grid, c.gap, modulus, c.parameters); }

Contact sink(const Case& c, double approach) {
  ContactParameters parameters = c.parameters;
  parameters.load = 0;
  parameters.approach = approach;
  return solve_contact(c.grid, c.gap, modulus, parameters);
}

std::string refusal(const Case& c, double approach) {
  return test::refusal([&] { sink(c, approach); });
}

}  // namespace

// ε leaves δ an error of ε (max u - min u) or so, and Q one of dQ/dδ times that: relative 3/2 ε and less for
// spheres, more by the ratio of max u to the few micrometres that waves are pressed in.
TEST_CASE("the approach that a load has, given in its place, has that load", "[contact][law]") {
  for (const Case& c : cases()) {
    const Contact loaded = solve(c), sunk = sink(c, loaded.approach);
    CAPTURE(c.name, loaded.convolutions, sunk.convolutions, sunk.reason);
    CHECK(sunk.converged);
    CHECK(relative_error(sunk.load, loaded.load) <= 1e-8);
    CHECK((sunk.pressure - loaded.pressure).abs().maxCoeff() <= 1e-6 * loaded.max_pressure);
    CHECK(sunk.area == loaded.area);
    CHECK(sunk.plastic_area == loaded.plastic_area);
    CHECK(sunk.pressure.minCoeff() >= 0);
    CHECK(sunk.pressure.maxCoeff() <= c.parameters.limit_pressure);
    CHECK(sunk.approach == loaded.approach);
  }
}

TEST_CASE("bodies sunk a hair beyond first touch carry a load on a single cell", "[contact][exact]") {
  const Case c = cases()[1];
  const double touch = c.gap.minCoeff(), depth = 1e-12;
  const Contact sunk = sink(c, touch + depth);
  const double k = make_influence(c.grid, modulus)->self_influence();
  CHECK(sunk.area == c.grid.cell_area());
  // δ holds its 1e-12 m to ε times its micrometres, 1e-9 of them.
  CHECK(sunk.load == Approx(depth / k * c.grid.cell_area()).epsilon(1e-8));
}

TEST_CASE("a periodic surface is sunk to just above full contact", "[contact][law]") {
  const Case c = cases()[3];
  const double mean = c.gap.mean(), touch = c.gap.minCoeff();
  double carried = 0;
  for (double part : {0.1, 0.5, 0.9, 0.99}) {
    const Contact sunk = sink(c, touch + part * (mean - touch));
    CAPTURE(part, sunk.convolutions, sunk.reason, sunk.residual);
    CHECK(sunk.converged);
    CHECK(sunk.load > carried);
    CHECK(sunk.mean_gap == Approx(mean - sunk.approach).epsilon(1e-6));  // u has no mean
    carried = sunk.load;
  }
}

TEST_CASE("an approach that no contact has is refused with the one where contact begins or ends",
          "[contact][contract]") {
  const std::vector<Case> all = cases();
  const Case &spheres_case = all[0], &periodic = all[3];
  CHECK(refusal(spheres_case, 0).find("approach: 0 m is not above") == 0);
  CHECK(refusal(spheres_case, -1e-6).find("first touch") != std::string::npos);
  CHECK(refusal(periodic, periodic.gap.mean()).find("full contact") != std::string::npos);
  CHECK(refusal(periodic, std::nan("")).find("not finite") != std::string::npos);
  ContactParameters both{.load = 1, .approach = 1e-6};
  CHECK_THROWS_AS(both.check(), ParameterError);
}

// With a limit pressure the whole surface may flow at it: then there is contact at any approach.
TEST_CASE("a periodic surface with a limit pressure may be sunk beyond its mean gap", "[plastic][exact]") {
  Case c = cases()[3];
  c.parameters.limit_pressure = 1e9;
  const Contact sunk = sink(c, c.gap.maxCoeff() + 1e-5);
  CHECK(sunk.converged);
  CHECK((sunk.pressure == 1e9).all());
}

TEST_CASE("a solution is its own start: no more than two convolutions confirm it", "[contact][exact]") {
  for (const Case& c : cases()) {
    const Contact first = solve(c);
    Case again = c;
    again.parameters.start = first.pressure;
    again.parameters.tolerance = 2 * c.parameters.tolerance;
    const Contact second = solve(again);
    CAPTURE(c.name);
    CHECK(second.converged);
    CHECK(second.convolutions <= 2);
    CHECK((second.pressure / first.max_pressure - first.pressure / first.max_pressure).abs().maxCoeff() <=
          1e-13);
  }
}

TEST_CASE("the pressure of a neighbouring load leads to the same solution as a nested start",
          "[contact][law]") {
  for (const Case& c : cases()) {
    Case less = c, warm = c;
    less.parameters.load *= 0.8;
    warm.parameters.start = solve(less).pressure;
    const Contact nested = solve(c), near = solve(warm);
    CAPTURE(c.name, near.convolutions, nested.convolutions);
    CHECK(near.converged);
    CHECK(near.levels == 1);
    CHECK(near.area == nested.area);
    CHECK((near.pressure - nested.pressure).abs().maxCoeff() <= 1e-6 * nested.max_pressure);
  }
}

TEST_CASE("a start that does not fit or is not finite is refused", "[contact][contract]") {
  Case c = cases()[0];
  c.parameters.start = Field::Ones(32, 32);
  CHECK_THROWS_AS(solve(c), DataError);
  c.parameters.start = Field::Constant(64, 64, std::nan(""));
  CHECK_THROWS_AS(solve(c), DataError);
}
