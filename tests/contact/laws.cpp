#include <string>

#include "core/error.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double energy(const Grid& grid, const Field& gap, const Contact& c) {
  return ((c.displacement / 2 + gap) * c.pressure).sum() * grid.cell_area();
}

// ε of two solutions bounds their pressures' difference by some 10 ε of the maximum pressure.
void check_same_pressure(const Field& p, const Field& q) {
  CHECK((p - q).abs().maxCoeff() <= 1e-6 * p.maxCoeff());
}

}  // namespace

TEST_CASE("no pressure is negative or above the limit, and the load is carried to 1e-12",
          "[contact][contract]") {
  const Grid grid = square(64);
  const Contact contact = press(grid, rough_gap(grid), {.limit_pressure = limit});
  CHECK(contact.converged);
  CHECK(contact.residual <= 1e-8);
  CHECK(contact.load_residual <= 1e-12);
  CHECK(contact.pressure.minCoeff() >= 0);
  CHECK(contact.pressure.maxCoeff() == limit);
  CHECK(contact.plastic_area > 0);
}

TEST_CASE("the gap is open, closed or flattened as the state of its cell says", "[contact][contract]") {
  const Grid grid = square(64);
  const Contact contact = press(grid, rough_gap(grid), {.limit_pressure = limit});
  const double slack = 1e-8 * (contact.displacement.maxCoeff() - contact.displacement.minCoeff());
  for (Index i = 0; i < grid.shape.cells(); ++i) {
    const double p = contact.pressure.data()[i], gap = contact.gap.data()[i];
    switch (contact.state[static_cast<std::size_t>(i)]) {
      case Contact::open:
        REQUIRE((p == 0 && gap >= -slack));
        break;
      case Contact::elastic:
        REQUIRE((p > 0 && p < limit && std::abs(gap) <= slack));
        break;
      default:
        REQUIRE((p == limit && gap <= slack));
    }
  }
}

// E(Q) is convex with E' = δ; the central difference over ±hQ errs by h²/6 δ''Q²/δ ≤ h²/27 for δ ~ Q^⅔, and
// by the few cells that join the contact between.
TEST_CASE("the derivative of the energy by the load is the approach", "[contact][law]") {
  const Grid grid = square(64);
  const double h = 0.01;
  for (double cap : {limit, infinity}) {
    const Field gap = rough_gap(grid);
    auto solve = [&](double q) {
      return press(grid, gap, {.load = q, .limit_pressure = cap, .tolerance = 1e-10});
    };
    const Contact less = solve(load * (1 - h)), more = solve(load * (1 + h)), here = solve(load);
    const double slope = (energy(grid, gap, more) - energy(grid, gap, less)) / (2 * h * load);
    CHECK(relative_error(slope, here.approach) <= 1e-5);
  }
}

TEST_CASE("contact area and approach grow with the load", "[contact][law]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  double area = 0, approach = -1;
  for (double q : {1.0, 10.0, 100.0, 1000.0, 5000.0, 20000.0}) {
    const Contact contact = press(grid, gap, {.load = q});
    CAPTURE(q);
    CHECK(contact.area > area);
    CHECK(contact.approach > approach);
    area = contact.area;
    approach = contact.approach;
  }
}

// A shift of 1 mm leaves ε·1 mm = 2e-19 m of round-off in gaps, 1e-14 of their range.
TEST_CASE("a shift of the heights shifts the approach and nothing else", "[contact][law]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  const Contact here = press(grid, gap), shifted = press(grid, gap + 1e-3);
  check_same_pressure(here.pressure, shifted.pressure);
  CHECK(here.area == shifted.area);
  CHECK(shifted.approach - 1e-3 == Approx(here.approach).epsilon(1e-8));
}

TEST_CASE("the solution of the mirrored and of the transposed gap is mirrored and transposed",
          "[contact][law]") {
  const Grid grid{{64, 96}, 3e-3 / 64, 3e-3 / 96}, turned{{96, 64}, grid.dy, grid.dx};
  const Field gap = rough_gap(grid);
  const Contact here = press(grid, gap);
  check_same_pressure(here.pressure, press(grid, gap.rowwise().reverse()).pressure.rowwise().reverse());
  check_same_pressure(here.pressure, press(grid, gap.colwise().reverse()).pressure.colwise().reverse());
  check_same_pressure(here.pressure, press(turned, gap.transpose()).pressure.transpose());
}

// Doubling E* and Q leaves h and every displacement as it is: all pressures double, to round-off of the
// iteration.
TEST_CASE("twice the modulus carries twice the load with the same gap", "[contact][law]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  const Contact soft = solve_contact(grid, gap, modulus, {.load = load, .tolerance = 1e-8});
  const Contact hard = solve_contact(grid, gap, 2 * modulus, {.load = 2 * load, .tolerance = 1e-8});
  check_same_pressure(2 * soft.pressure, hard.pressure);
  CHECK(soft.area == hard.area);
}

TEST_CASE("a start on coarser grids ends in the solution of a flat start", "[contact][law]") {
  const Grid grid = square(128);
  const Field gap = rough_gap(grid);
  const Contact nested = press(grid, gap, {.limit_pressure = limit});
  const Contact flat = press(grid, gap, {.limit_pressure = limit, .nested_start = false});
  check_same_pressure(nested.pressure, flat.pressure);
  CHECK(nested.area == flat.area);
  CHECK(nested.levels == 3);
  CHECK(flat.levels == 1);
}

TEST_CASE("the solution does not depend on the number of threads, to the last bit", "[contact][law]") {
  const Grid grid = square(512);
  const Field gap = rough_gap(grid);
  const ContactParameters rough{.load = load, .tolerance = 1e-3};
  ContactParameters threaded = rough;
  threaded.threads = 3;
  const Contact one = solve_contact(grid, gap, modulus, rough),
                three = solve_contact(grid, gap, modulus, threaded);
  CHECK((one.pressure == three.pressure).all());
  CHECK((one.gap == three.gap).all());
}

TEST_CASE("every load up to the limit pressure on the whole domain is carried", "[plastic][law]") {
  const Grid grid = square(64);
  const double area = grid.size_x() * grid.size_y();
  for (double share : {0.5, 0.9, 0.999, 1.0}) {
    const double cap = load / (share * area);
    const Contact contact = press(grid, undeformed_gap(grid, spheres), {.limit_pressure = cap});
    CAPTURE(share, contact.reason);
    CHECK(contact.residual <= 1e-8);
    CHECK(contact.load_residual <= 1e-12);
    CHECK(contact.pressure.maxCoeff() <= cap);
    CHECK(contact.plastic_area >= 0.9 * share * area);
  }
}

// At 1 kPa the bodies hardly yield: the cells fill up to the limit in the order of their gaps, and one is
// left over. (A pressure one bit below the limit once counted as free and held the iteration up.)
TEST_CASE("hardly any pressure fills the cells in the order of their gaps", "[plastic][exact]") {
  const Grid grid = square(64);
  const double cap = 1e3, share = 0.9922;
  const Contact contact = press(grid, rough_gap(grid), {.load = share * cap * 9e-6, .limit_pressure = cap});
  CHECK(contact.converged);
  CHECK((contact.pressure == cap).count() == 4064);  // of 0.9922 · 4096 = 4064.05
  CHECK((contact.pressure > 0).count() == 4065);
}

TEST_CASE("at the largest load every cell is at the limit, exactly", "[plastic][exact]") {
  const Grid grid = square(64);
  const double cap = load / (grid.size_x() * grid.size_y());
  const Contact contact = press(grid, rough_gap(grid), {.limit_pressure = cap});
  CHECK((contact.pressure == cap).all());
  CHECK(contact.residual <= 1e-14);  // the round-off of δ
}

TEST_CASE("a load beyond the limit pressure on the whole domain names the largest load",
          "[contact][contract]") {
  const Grid grid = square(32);
  try {
    press(grid, undeformed_gap(grid, spheres), {.limit_pressure = 1e8});
    FAIL("no error");
  } catch (const ParameterError& error) {
    CHECK(error.name == "load");
    CHECK(std::string(error.what()).find("900") != std::string::npos);
  }
}

TEST_CASE("parameters out of their bounds are refused by name", "[contact][contract]") {
  const Grid grid = square(32);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto refused = [&](const ContactParameters& parameters) -> std::string {
    try {
      solve_contact(grid, undeformed_gap(grid, spheres), modulus, parameters);
    } catch (const ParameterError& error) {
      return error.name;
    }
    return "";
  };
  for (double q : {0.0, -1.0, nan, infinity}) CHECK(refused({.load = q}) == "load");
  CHECK(refused({.load = 1, .limit_pressure = -1}) == "limit-pressure");
  CHECK(refused({.load = 1, .tolerance = 0}) == "tolerance");
  CHECK(refused({.load = 1, .max_convolutions = 0}) == "max-convolutions");

  auto body = [](const Bodies& bodies) -> std::string {
    try {
      bodies.check();
    } catch (const ParameterError& error) {
      return error.name;
    }
    return "";
  };
  CHECK(body({.radius = {0, 1}}) == "radius");
  CHECK(body({.radius = {nan, 1}}) == "radius");
  CHECK(body({.young = {208e9, -1}}) == "young");
  CHECK(body({.poisson = {0.3, 0.51}}) == "poisson");
  CHECK(body(spheres) == "");
}

TEST_CASE("heights that are not finite or do not fit the grid are refused", "[contact][contract]") {
  const Grid grid = square(32);
  Field gap = undeformed_gap(grid, spheres);
  CHECK_THROWS_AS(press(square(16), gap), DataError);
  gap(3, 4) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(press(grid, gap), DataError);
}

// Its displacements, those of other cells, were taken for the grid's.
TEST_CASE("an operator of other cells than the grid's is refused", "[contact][contract]") {
  const Grid grid{{16, 24}, 1e-6, 2e-6, {true, false}};
  const Field gap = 1e-6 * random_field(grid.shape, 1);
  const auto pressed_with = [&](const Grid& other) {
    return solve_contact(grid, gap, *make_influence(other, modulus), {.load = 0.01});
  };
  CHECK_NOTHROW(pressed_with(grid));
  CHECK_NOTHROW(pressed_with({grid.shape, 1e-6 * (1 + 1e-15), 2e-6, grid.periodic}));
  for (const Grid& other :
       {Grid{{24, 16}, 1e-6, 2e-6, grid.periodic}, Grid{grid.shape, 2e-6, 2e-6, grid.periodic},
        Grid{grid.shape, 1e-6, 1e-6, grid.periodic}, Grid{grid.shape, 1e-6, 2e-6, false},
        Grid{grid.shape, 1e-6, 2e-6, {false, true}}})
    CHECK_THROWS_AS(pressed_with(other), DataError);
}

// Once 1e305 N was "converged" with pressures of NaN: their squares are infinite, and max|w| of NaN was 0.
TEST_CASE("a load or approach whose pressures or displacements no double holds is refused",
          "[contact][contract]") {
  const Grid grid = square(32);
  const Field gap = undeformed_gap(grid, spheres);
  CHECK_THROWS_AS(press(grid, gap, {.load = 1e305}), ParameterError);
  CHECK_THROWS_AS(press(grid, gap, {.load = 0, .approach = 1e305}), ParameterError);
  CHECK_THROWS_AS(solve_contact(grid, gap, 1e-300, {.load = load}), ParameterError);
  CHECK(press(grid, gap, {.load = 1e100}).residual <= 1e-6);
}

TEST_CASE("a solution cut short says so and still keeps bounds and load", "[contact][contract]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  const Contact contact = press(grid, gap, {.max_convolutions = 4});
  CHECK_FALSE(contact.converged);
  CHECK_FALSE(contact.reason.empty());
  CHECK(contact.convolutions >= 4);  // and those on coarser grids and windows
  CHECK(contact.convolutions < press(grid, gap, {}).convolutions);
  CHECK(contact.residual > 1e-8);
  CHECK(contact.load_residual <= 1e-12);
  CHECK(contact.pressure.minCoeff() >= 0);
}

TEST_CASE("a single cell and a flat periodic surface have their trivial solutions", "[contact][exact]") {
  const Grid cell{{1, 1}, 1e-3, 1e-3};
  CHECK(press(cell, Field::Zero(1, 1)).pressure(0, 0) == Approx(load / 1e-6));
  const Grid flat = periodic(square(32));
  const Contact contact = press(flat, Field::Zero(32, 32));
  CHECK(contact.converged);
  CHECK((contact.pressure / (load / 9e-6) - 1).abs().maxCoeff() <= 1e-12);
}

// A sphere of 3 mm on a domain of 3 mm × 146 mm stands 0.9 m back at the ends; plastic all over at some kPa
// it is displaced by 1e-11 m, which g = h + u of 0.9 m resolves to 1e-5.
TEST_CASE("displacements far below the round-off of the gap are resolved", "[contact][law]") {
  const Grid grid{{32, 64}, 3e-3 / 32, 48 * 3e-3 / 32};
  const Field gap = sample(grid, [](double x, double y) { return (x * x + y * y) / (2 * 3e-3); });
  const Contact contact = solve_contact(
      grid, gap, modulus, {.load = 1, .limit_pressure = 2 * 1 / (3e-3 * 0.288), .tolerance = 1e-8});
  CAPTURE(contact.convolutions);
  CHECK(contact.converged);
  CHECK(contact.approach > 1e8 * contact.displacement.maxCoeff());
}
