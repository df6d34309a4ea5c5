// dQ/dδ of single solutions. Once it came from differences of loads in ln Q, and was below 0 in 28 of 40
// rough sweeps.
#include "contact/stiffness.hpp"

#include "contact/sweep.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

Contact press_stiff(const Grid& grid, const Field& gap, ContactParameters parameters) {
  parameters.stiffness = true;
  parameters.tolerance = std::min(parameters.tolerance, 1e-10);
  return solve_contact(grid, gap, modulus, parameters);
}

Contact sink_stiff(const Grid& grid, const Field& gap, double approach, double limit) {
  return press_stiff(grid, gap, {.approach = approach, .limit_pressure = limit, .tolerance = 1e-12});
}

struct Scene {
  const char* name;
  Grid grid;
  Field gap;
  double load, limit = infinity;
};

std::vector<Scene> scenes() {
  const Grid grid = square(64), oblong{{48, 80}, 8e-5, 2e-5}, wavy = periodic(square(64));
  const Field waves = -1e-6 * random_waves(grid.shape, 3);
  return {{"smooth", grid, undeformed_gap(grid, spheres), 1000},
          {"rough", grid, rough_gap(grid), load},
          {"limited", grid, rough_gap(grid), load, 3e9},
          {"oblong", oblong, rough_gap(oblong), 500},
          {"periodic", wavy, waves, 50},
          {"periodic and limited", wavy, waves, 300, 1e9}};
}

}  // namespace

// C lies between circles of a ± Δx/√2, the half diagonal of a cell, and the capacity grows with C;
// collocation takes off less than the cells' edge.
TEST_CASE("the stiffness of spheres is 2 a E* at a single load", "[stiffness][exact]") {
  for (Index n : {64, 128})
    for (double q : {10.0, 100.0, 1000.0, 5000.0}) {
      const Grid grid = square(n);
      const double a = hertz(spheres, q).radius, exact = 2 * a * modulus;
      const Contact contact = press_stiff(grid, undeformed_gap(grid, spheres), {.load = q});
      CAPTURE(n, q, contact.stiffness / exact - 1, grid.dx / a);
      CHECK(contact.converged);
      CHECK(contact.stiffness_residual <= stiffness_tolerance);
      CHECK(relative_error(contact.stiffness, exact) <= std::sqrt(0.5) * grid.dx / a);
    }
}

// The punch's problem is linear: Q = S δ. ε = 1e-10 leaves δ an error of some ten times that.
TEST_CASE("a flat punch, round or square, has the stiffness Q over its approach", "[stiffness][exact]") {
  const double a = 0.8e-3;
  for (const Grid& grid : {square(64), Grid{{48, 96}, 6e-5, 2e-5}}) {
    const Field round = sample(grid, [&](double x, double y) { return std::hypot(x, y) <= a ? 0 : 1e-3; }),
                square_punch = Field::Zero(grid.shape.nx, grid.shape.ny);
    for (const Field& gap : {round, square_punch}) {
      const Contact contact = press_stiff(grid, gap, {.load = load});
      CHECK(relative_error(contact.stiffness, load / contact.approach) <= 1e-9);
    }
  }
  const Grid grid = square(128);
  const Contact contact =
      press_stiff(grid, sample(grid, [&](double x, double y) { return std::hypot(x, y) <= a ? 0 : 1e-3; }),
                  {.load = load});
  CHECK(relative_error(contact.stiffness, 2 * a * modulus) <= 0.2 * grid.dx / a);  // as closed_forms.cpp
}

// While no cell changes its state Q is linear in δ. ε = 1e-12 leaves δ some 1e-12 of u, 20 µm or less: 1e-7
// of 2 η, and Q as much.
TEST_CASE("the stiffness is the central difference of two contacts of the same cells", "[stiffness][law]") {
  const double eta = 1e-10;
  for (const Scene& s : scenes()) {
    const Contact middle = press_stiff(s.grid, s.gap,
                                       {.load = s.load, .limit_pressure = s.limit, .tolerance = 1e-12}),
                  less = sink_stiff(s.grid, s.gap, middle.approach - eta, s.limit),
                  more = sink_stiff(s.grid, s.gap, middle.approach + eta, s.limit);
    CAPTURE(s.name, middle.residual, less.residual, more.residual, middle.stiffness_residual);
    REQUIRE((less.state == middle.state && more.state == middle.state));
    REQUIRE((std::isinf(s.limit) || middle.plastic_area > 0));
    CHECK(relative_error((more.load - less.load) / (more.approach - less.approach), middle.stiffness) <=
          2e-7);
  }
}

// Elastic Q(δ) is convex: a chord lies between the slopes at its ends. ε = 1e-10 errs in δ by 1e-9 of u or
// so, and steps in δ are a tenth of u and more.
TEST_CASE("in forty rough sweeps stiffness is above 0 and its chords lie between that of their ends",
          "[stiffness][law]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Grid grid = seed % 4 == 3 ? periodic(square(32)) : square(32, seed % 2 == 1 ? 0.5e-3 : 3e-3);
    const Field gap = grid.periodic.both() ? -1e-7 * random_waves(grid.shape, seed) : rough_gap(grid, seed);
    const auto influence = make_influence(grid, modulus);
    std::vector<Contact> turns;
    solve_load_sequence(grid, gap, *influence, {.tolerance = 1e-10, .stiffness = true},
                        std::array{0.1, 1.0, 5.0, 30.0}, [&](const Contact& c) { turns.push_back(c); });
    for (std::size_t i = 0; i < turns.size(); ++i) {
      CAPTURE(seed, i, turns[i].stiffness, turns[i].reason);
      CHECK(turns[i].converged);
      CHECK(turns[i].stiffness > 0);
      if (i == 0) continue;
      const Contact &less = turns[i - 1], &more = turns[i];
      const double chord = (more.load - less.load) / (more.approach - less.approach);
      CHECK(less.stiffness <= chord * (1 + 1e-7));
      CHECK(chord <= more.stiffness * (1 + 1e-7));
    }
  }
}

// Strips of half-width a on a period L, by the capacity sin(πa/L) of an arc:  S/A = πE* / (2L ln
// 1/sin(πa/L)). Cells have their outline within half a cell.
TEST_CASE("the stiffness of a wavy surface in partial contact is that of strips", "[stiffness][exact]") {
  const double L = 1e-3;
  const Grid grid{{128, 4}, L / 128, L / 128, true};
  const Field gap = sample(grid, [&](double x, double) { return 1e-6 * (1 - std::cos(2 * pi * x / L)); });
  const double full = pi * modulus * 1e-6 / L, domain = grid.size_x() * grid.size_y();
  auto strips = [&](double a) { return domain * pi * modulus / (2 * L * -std::log(std::sin(pi * a / L))); };
  for (double share : {0.1, 0.5, 0.9}) {
    const Contact contact = press_stiff(grid, gap, {.load = share * full * domain});
    const double half_width = contact.area / grid.size_y() / 2;
    CAPTURE(share, contact.stiffness / strips(half_width));
    CHECK(contact.stiffness >= strips(half_width - grid.dx / 2));
    CHECK(contact.stiffness <= strips(half_width + grid.dx / 2));
  }
}

// K has no answer to a constant pressure. With a single cell open, S = n² M₀₀ ΔxΔy (M of the operator: K's
// pseudo-inverse), which grows as n; round-off is ε n K̂ S/ΔxΔy.
TEST_CASE("a periodic surface in full contact is infinitely stiff, but for one open cell it is not",
          "[stiffness][exact]") {
  const Grid grid = periodic(square(64));
  const Contact all = press_stiff(grid, 1e-9 * random_waves(grid.shape, 3), {.load = 5000});
  REQUIRE(all.area == Approx(grid.size_x() * grid.size_y()));
  CHECK(all.stiffness == infinity);
  CHECK(all.converged);
  const auto influence = make_influence(grid, modulus);
  Field pressure = Field::Ones(64, 64), unit = Field::Zero(64, 64);
  pressure(10, 20) = 0, unit(10, 20) = 1;
  influence->precondition(unit, unit);
  const Stiffness found = contact_stiffness(*influence, pressure, infinity, grid.cell_area(), 1000);
  CAPTURE(found.residual, found.convolutions);
  CHECK(relative_error(found.value, 64.0 * 64 * 64 * 64 * unit(10, 20) * grid.cell_area()) <= 1e-8);
}

TEST_CASE("one cell in contact has the stiffness of its own influence, and none at the limit has any",
          "[stiffness][exact]") {
  const Grid grid{{32, 48}, 5e-5, 2e-5};
  Field gap = rough_gap(grid);
  const double touch = gap.minCoeff();
  const Contact one = press_stiff(grid, gap, {.approach = touch + 1e-12});
  REQUIRE(one.area == grid.cell_area());
  const double alone = grid.cell_area() / make_influence(grid, modulus)->self_influence();
  CHECK(relative_error(one.stiffness, alone) <= 1e-12);
  const double domain = grid.size_x() * grid.size_y();
  const Contact flowing = press_stiff(grid, gap, {.load = 1e9 * domain, .limit_pressure = 1e9});
  REQUIRE((flowing.pressure == 1e9).all());
  CHECK(flowing.stiffness == 0);
  CHECK(flowing.stiffness_residual == 0);
}

TEST_CASE("the stiffness does not depend on the number of threads, to the last bit", "[stiffness][law]") {
  const Grid grid = square(520);
  const Field pressure = (random_waves({65, 65}, 5).replicate(8, 8) > 0.5).cast<double>();
  double of[2] = {};
  for (int threads : {1, 3})
    of[threads / 3] = contact_stiffness(*make_influence(grid, modulus, threads), pressure, infinity,
                                        grid.cell_area(), 3, threads)
                          .residual;
  CHECK(of[0] == of[1]);
  const Contact one = press_stiff(square(64), rough_gap(square(64)), {.load = load}),
                three = press_stiff(square(64), rough_gap(square(64)), {.load = load, .threads = 3});
  CHECK(one.stiffness == three.stiffness);
}

TEST_CASE("a stiffness that is cut short is not a number", "[stiffness][contract]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  const Contact solved = press_stiff(grid, gap, {.load = load});
  ContactParameters cut{.load = load, .tolerance = 1e-8, .max_convolutions = 2, .stiffness = true};
  cut.start = solved.pressure;
  const Contact again = solve_contact(grid, gap, modulus, cut);
  CHECK(again.residual <= cut.tolerance);
  CHECK(again.converged);
  CHECK(std::isnan(again.stiffness));
  CHECK(again.stiffness_residual > stiffness_tolerance);
  const Contact unsolved =
      solve_contact(grid, gap, modulus, {.load = load, .max_convolutions = 2, .stiffness = true});
  CHECK_FALSE(unsolved.converged);
  CHECK(std::isnan(unsolved.stiffness));
  CHECK(std::isnan(solve_contact(grid, gap, modulus, {.load = load}).stiffness));
}

// The steps of K are in single precision from 256 x 256 cells on: near full contact, where q is large
// and K q is not, they alone left a residual of 1e-5.
TEST_CASE("the stiffness converges near full contact too", "[stiffness][exact]") {
  const Grid grid = periodic(square(384, 1e-3));
  constexpr double depth = 1e-6;
  const Field gap = sample(grid, [](double x, double y) {
    return -depth * std::cos(2 * pi * x / 1e-3) * std::cos(2 * pi * y / 1e-3);
  });
  const double full = std::sqrt(2.0) * pi * modulus * depth / 1e-3;
  const Contact contact = press(grid, gap, {.load = 0.95 * full * 1e-6, .stiffness = true});
  CHECK(contact.stiffness_residual <= 1e-6);
  CHECK(contact.stiffness > 0);
}
