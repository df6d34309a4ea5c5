#include "contact/sweep.hpp"

#include "contact/flattening.hpp"
#include "grid/error.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::vector<Contact> sweep(const Grid& grid, const Field& gap, ContactParameters parameters,
                           const std::vector<double>& loads) {
  const auto influence = make_influence(grid, modulus);
  std::vector<Contact> out;
  press_in_turn(grid, gap, *influence, parameters, loads, [&](const Contact& c) { out.push_back(c); });
  return out;
}

std::string refusal(const std::vector<double>& loads, ContactParameters parameters = {}) {
  const Grid grid = square(32);
  try {
    sweep(grid, undeformed_gap(grid, spheres), parameters, loads);
  } catch (const ParameterError& error) {
    return error.name;
  }
  return "";
}

}  // namespace

TEST_CASE("geometric loads begin and end where they should and keep their ratio", "[sweep][exact]") {
  const std::vector<double> loads = geometric_loads(10, 5000, 20);
  REQUIRE(loads.size() == 20);
  CHECK(loads.front() == 10);
  CHECK(loads.back() == 5000);
  for (std::size_t i = 1; i < loads.size(); ++i)
    CHECK(relative_error(loads[i] / loads[i - 1], std::pow(500, 1 / 19.0)) <= 20 * epsilon);
}

// A polynomial of degree four or less in ln Q; round-off is ε times the sum of the weights' magnitudes.
TEST_CASE("the stiffness is exact where the approach is a polynomial in the load's logarithm",
          "[sweep][exact]") {
  const std::vector<double> all{1, 2, 3, 7, 10, 30, 40};
  for (std::size_t n = 2; n <= all.size(); ++n) {
    const std::vector<double> loads(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n));
    const double power = std::min(static_cast<double>(n) - 1, 4.0);
    std::vector<double> approaches;
    for (double q : loads) approaches.push_back(3 + std::pow(1 + std::log(q), power));
    const std::vector<double> found = stiffness(loads, approaches);
    for (std::size_t i = 0; i < n; ++i) {
      const double exact = loads[i] / (power * std::pow(1 + std::log(loads[i]), power - 1));
      CAPTURE(n, i);
      CHECK(relative_error(found[i], exact) <= 1e-11);
    }
  }
  CHECK(std::isnan(stiffness({5}, {1}).front()));
}

// δ ~ Q^⅔: the truncation errors of (1), of which the constants are 1/30 between, 1/20 beside and 1/5 at the ends.
TEST_CASE("the stiffness of Hertz's approach errs as the header says", "[sweep][order]") {
  const std::vector<double> loads = geometric_loads(10, 1e4, 25);
  std::vector<double> approaches;
  for (double q : loads) approaches.push_back(hertz(spheres, q).approach);
  const std::vector<double> found = stiffness(loads, approaches);
  const double step = 2.0 / 3 * std::log(loads[1] / loads[0]);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const std::size_t end = std::min(i, loads.size() - 1 - i);
    const double truncation = std::pow(step, 4) / (end == 0 ? 5 : end == 1 ? 20 : 30);
    const double exact = 2 * modulus * hertz(spheres, loads[i]).radius;
    CAPTURE(i, truncation);
    CHECK(relative_error(found[i], exact) <= 1.5 * truncation);
  }
}

// The grid errs in δ by some 0.05 (Δx/a)², a staircase whose steps the derivative shows; its truncation is (2s/3)⁴/5
// and less.
TEST_CASE("the stiffness of spheres pressed in turn is 2 E* a", "[sweep][exact]") {
  const Grid grid = square(128);
  const std::vector<double> loads = geometric_loads(500, 5000, 9);
  std::vector<double> approaches;
  for (const Contact& c : sweep(grid, undeformed_gap(grid, spheres), {}, loads))
    approaches.push_back(c.approach);
  const std::vector<double> found = stiffness(loads, approaches);
  const double truncation = std::pow(2.0 / 3 * std::log(loads[1] / loads[0]), 4) / 5;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double a = hertz(spheres, loads[i]).radius;
    CAPTURE(i, found[i] / (2 * modulus * a) - 1);
    CHECK(relative_error(found[i], 2 * modulus * a) <= 0.5 * std::pow(grid.dx / a, 2) + truncation);
  }
}

TEST_CASE("loads pressed in turn end in the solutions of each alone, the first alone from coarser grids",
          "[sweep][law]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  for (double cap : {std::numeric_limits<double>::infinity(), 3.6e9}) {
    const ContactParameters parameters{.limit_pressure = cap, .tolerance = 1e-10};
    const std::vector<double> loads = geometric_loads(100, 5000, 12);
    const std::vector<Contact> turns = sweep(grid, gap, parameters, loads);
    REQUIRE(turns.size() == loads.size());
    for (std::size_t i = 0; i < loads.size(); ++i) {
      ContactParameters alone = parameters;
      alone.load = loads[i];
      const Contact single = solve_contact(grid, gap, modulus, alone);
      CHECK(turns[i].converged);
      CHECK(turns[i].load_error <= 1e-12);
      CHECK(turns[i].area == single.area);
      CHECK((turns[i].pressure - single.pressure).abs().maxCoeff() <= 1e-7 * single.max_pressure);
      CHECK(turns[i].levels == (i == 0 ? single.levels : 1));
    }
  }
}

TEST_CASE("loads that do not increase or that nothing carries are refused before the first",
          "[sweep][contract]") {
  CHECK(refusal({10, 10}) == "loads");
  CHECK(refusal({10, 5}) == "loads");
  CHECK(refusal({10, INFINITY}) == "loads");
  CHECK(refusal({10, 5000}, {.limit_pressure = 1e8}) == "loads");
  CHECK(refusal({-1, 5}) == "load");
  CHECK(refusal({10, 500}, {.limit_pressure = 1e8}).empty());
}

// The former pressure and approach satisfy the conditions of the elastic contact of the flattened bodies; ε
// of both bounds the difference as that of any two solutions (laws.cpp).
TEST_CASE("a flattened surface carries its load again, elastically and under the same pressure",
          "[flattening][exact]") {
  Grid wavy = square(64);
  wavy.periodic = true;
  const Field waves = -1e-6 * random_waves(wavy.shape, 3);
  for (const Grid& grid : {square(64), wavy}) {
    const Field gap = grid.periodic ? waves : rough_gap(grid);
    const double limit = grid.periodic ? 0.8e9 : 3.6e9;
    const Contact plastic = press(grid, gap, {.limit_pressure = limit, .tolerance = 1e-10});
    REQUIRE(plastic.plastic_area > 0);
    const Field flattened = plastic_flattening(plastic);
    CHECK(flattened.minCoeff() == 0);
    CHECK(flattened.maxCoeff() > 1e-9);
    CHECK((flattened > 0).count() <= (plastic.pressure == limit).count());
    const Contact again = press(grid, gap + flattened, {.tolerance = 1e-10});
    CAPTURE(grid.periodic);
    CHECK(again.max_pressure <= limit * (1 + 1e-7));
    CHECK((again.pressure - plastic.pressure).abs().maxCoeff() <= 1e-7 * limit);
    CHECK(relative_error(again.approach, plastic.approach) <= 1e-8);
  }
}

TEST_CASE("an elastic contact leaves no flattening", "[flattening][law]") {
  const Grid grid = square(32);
  CHECK((plastic_flattening(press(grid, rough_gap(grid))) == 0).all());
}
