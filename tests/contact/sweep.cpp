#include "contact/sweep.hpp"

#include <numbers>

#include "contact/energy.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

std::vector<Contact> sweep(const Grid& grid, const Field& gap, ContactParameters parameters,
                           const std::vector<double>& loads) {
  const auto influence = make_influence(grid, modulus);
  std::vector<Contact> out;
  solve_load_sequence(grid, gap, *influence, parameters, loads, [&](const Contact& c) { out.push_back(c); });
  return out;
}

std::string refusal(const std::vector<double>& loads, ContactParameters parameters = {}) {
  const Grid grid = square(32);
  return test::refusal([&] { sweep(grid, undeformed_gap(grid, spheres), parameters, loads); });
}

}  // namespace

TEST_CASE("loads pressed in turn end in the solutions of each alone, the first alone from coarser grids",
          "[sweep][law]") {
  const Grid grid = square(64);
  const Field gap = rough_gap(grid);
  for (double cap : {infinity, limit}) {
    const ContactParameters parameters{.limit_pressure = cap, .tolerance = 1e-10};
    std::vector<double> loads;
    for (int i = 0; i < 12; ++i) loads.push_back(100 * std::pow(50, i / 11.0));
    const std::vector<Contact> turns = sweep(grid, gap, parameters, loads);
    REQUIRE(turns.size() == loads.size());
    for (std::size_t i = 0; i < loads.size(); ++i) {
      ContactParameters alone = parameters;
      alone.load = loads[i];
      const Contact single = solve_contact(grid, gap, modulus, alone);
      CHECK(turns[i].converged);
      CHECK(turns[i].load_residual <= 1e-12);
      CHECK(turns[i].area == single.area);
      CHECK((turns[i].pressure - single.pressure).abs().maxCoeff() <= 1e-7 * single.max_pressure);
      CHECK(turns[i].levels == (i == 0 ? single.levels : 1));
    }
  }
}

TEST_CASE("a load that equals the one before it or that nothing carries is refused before the first",
          "[sweep][contract]") {
  CHECK(refusal({10, 10}).starts_with("sweep: "));
  CHECK(refusal({10, 5}).empty());
  CHECK(refusal({10, 0}).starts_with("sweep: "));
  CHECK(refusal({5000, 10}, {.limit_pressure = 1e8}).starts_with("sweep: "));
  CHECK(refusal({10, INFINITY}).starts_with("sweep: "));
  CHECK(refusal({10, 5000}, {.limit_pressure = 1e8}).starts_with("sweep: "));
  CHECK(refusal({-1, 5}).starts_with("load: "));
  CHECK(refusal({10, 500}, {.limit_pressure = 1e8}).empty());
}

// The former pressure and approach satisfy the conditions of the elastic contact of the flattened bodies; ε
// of both bounds the difference as that of any two solutions (laws.cpp).
TEST_CASE("a flattened surface carries its load again, elastically and under the same pressure",
          "[flattening][exact]") {
  const Grid wavy = periodic(square(64));
  const Field waves = -1e-6 * random_waves(wavy.shape, 3);
  for (const Grid& grid : {square(64), wavy}) {
    const Field gap = grid.periodic.both() ? waves : rough_gap(grid);
    const double yielding = grid.periodic.both() ? 0.8e9 : limit;
    const Contact plastic = press(grid, gap, {.limit_pressure = yielding, .tolerance = 1e-10});
    REQUIRE(plastic.plastic_area > 0);
    const Field flattened = plastic_flattening(plastic);
    CHECK(flattened.minCoeff() == 0);
    CHECK(flattened.maxCoeff() > 1e-9);
    CHECK((flattened > 0).count() <= (plastic.pressure == yielding).count());
    const Contact again = press(grid, gap + flattened, {.tolerance = 1e-10});
    CAPTURE(grid.periodic.both());
    CHECK(again.max_pressure <= yielding * (1 + 1e-7));
    CHECK((again.pressure - plastic.pressure).abs().maxCoeff() <= 1e-7 * yielding);
    CHECK(relative_error(again.approach, plastic.approach) <= 1e-8);
  }
}

// ε bounds the difference as that of any two solutions (laws.cpp).
TEST_CASE("an elastic way back passes the contacts of the way up", "[sweep][law]") {
  const Grid grid = square(64);
  const std::vector<Contact> turns =
      sweep(grid, rough_gap(grid), {.tolerance = 1e-10}, {100, 400, 1600, 5000, 1600, 400, 100, 1600});
  for (const auto& [up, down] : {std::pair{2, 4}, {1, 5}, {0, 6}, {2, 7}}) {
    const Contact &one = turns[static_cast<std::size_t>(up)], &other = turns[static_cast<std::size_t>(down)];
    CAPTURE(up, down);
    CHECK(other.converged);
    CHECK(other.area == one.area);
    CHECK((other.pressure - one.pressure).abs().maxCoeff() <= 1e-7 * one.max_pressure);
    CHECK(other.flattening.size() == 0);
    CHECK(other.flattening_load == 0);
  }
}

TEST_CASE("a load below the greatest presses what that has flattened, and one above flattens on",
          "[sweep][law]") {
  const Grid wavy = periodic(square(64));
  for (const Grid& grid : {square(64), wavy}) {
    const Field gap = grid.periodic.both() ? Field(-1e-6 * random_waves(wavy.shape, 3)) : rough_gap(grid);
    const double yielding = grid.periodic.both() ? 0.8e9 : limit;
    const ContactParameters parameters{.limit_pressure = yielding, .tolerance = 1e-10};
    const std::vector<Contact> turns = sweep(grid, gap, parameters, {1000, 5000, 20, 1000, 2500, 6000, 2500});
    for (const auto& [greatest, back] : {std::pair{1, 2}, {1, 3}, {1, 4}, {5, 6}}) {
      const Contact &at = turns[static_cast<std::size_t>(greatest)],
                    &c = turns[static_cast<std::size_t>(back)];
      const Field left = plastic_flattening(at);
      const Contact alone = press(grid, gap + left, {.load = c.load, .tolerance = 1e-10});
      CAPTURE(grid.periodic.both(), back);
      REQUIRE(at.plastic_area > 0);
      CHECK(c.converged);
      CHECK(relative_error(c.flattening_load, at.load) <= 1e-12);
      CHECK((c.pressure - alone.pressure).abs().maxCoeff() <= 1e-7 * yielding);
      CHECK((plastic_flattening(c) - left).abs().maxCoeff() <= 1e-7 * left.maxCoeff());
    }
    const Contact first = press(grid, gap, {.load = 6000, .limit_pressure = yielding, .tolerance = 1e-10});
    CHECK((turns[5].pressure - first.pressure).abs().maxCoeff() <= 1e-7 * yielding);
    CHECK(turns[5].flattening.size() == 0);
    CHECK(turns[3].approach > turns[0].approach);
  }
}

TEST_CASE("an elastic contact leaves no flattening", "[flattening][law]") {
  const Grid grid = square(32);
  CHECK((plastic_flattening(press(grid, rough_gap(grid))) == 0).all());
}

// ∫Q dδ = 8/15 E* √R δ^{5/2} = 2/5 Q δ. At n cells across δ errs by 0.05 and p0 by 0.22 (Δx/a)²
// (contact/solver.hpp): the energy, like Q δ, by less than their sum.
TEST_CASE("the elastic energy of Hertz's contact is 2/5 of load times approach", "[energy][exact]") {
  const Hertz smooth = hertz(spheres, load);
  for (Index n : {64, 128}) {
    const Grid grid = square(n);
    const Contact contact = press(grid, undeformed_gap(grid, spheres));
    const double exact = 0.4 * load * smooth.approach;
    CHECK(relative_error(elastic_energy(grid, contact), exact) <=
          0.27 * std::pow(grid.dx / smooth.radius, 2));
    CHECK(plastic_work(grid, contact, infinity) == 0);
  }
}

// Simpson's rule over 2 m equal steps of the approach errs by (h⁴/180) H max|Q⁗|; 8 to 16 steps show its
// fall, at order 3 or so where cells join: the bound is the change from 8 to 16 steps.
TEST_CASE("elastic energy and work of flattening are the work of the load along its way", "[energy][law]") {
  const Grid free = square(32), wavy = periodic(square(32, 1e-3));
  for (const Grid& grid : {free, wavy})
    for (const double cap : {infinity, grid.periodic.both() ? 0.8e9 : 2.5e9}) {
      const Field gap = grid.periodic.both() ? Field(-1e-6 * random_waves(grid.shape, 3)) : rough_gap(grid);
      const auto influence = make_influence(grid, modulus);
      const double touch = gap.minCoeff();
      const double deepest =
          press(grid, gap, {.load = grid.periodic.both() ? 100 : load, .limit_pressure = cap}).approach;
      Contact last;
      auto load_at = [&](double approach) {
        if (approach <= touch) return 0.0;
        last = solve_contact(grid, gap, *influence,
                             {.approach = approach, .limit_pressure = cap, .tolerance = 1e-9});
        return last.load;
      };
      auto work = [&](int steps) {
        const double h = (deepest - touch) / steps;
        double sum = 0;
        for (int k = 0; k <= steps; ++k)
          sum += (k == 0 || k == steps ? 1 : k % 2 ? 4 : 2) * load_at(touch + k * h);
        return sum * h / 3;
      };
      const double coarse = work(24), fine = work(48);
      const double stored = elastic_energy(grid, last) + plastic_work(grid, last, cap);
      CAPTURE(grid.periodic.both(), cap, coarse, fine, stored, last.plastic_area);
      CHECK((cap == infinity) == (last.plastic_area == 0));
      CHECK(std::abs(fine / stored - 1) <= std::abs(coarse / fine - 1) + 1e-9);
      CHECK(std::abs(fine / stored - 1) <= 1e-3);
    }
}

// Elastic ways down lie between the works of either load; the work of flattening is what a loop loses.
TEST_CASE("the way back gives the elastic energy back and keeps the work of flattening", "[energy][law]") {
  const Grid grid = square(32);
  const auto influence = make_influence(grid, modulus);
  std::vector<double> loads{load};
  while (loads.back() > 50) loads.push_back(0.8 * loads.back());
  std::vector<double> stored, lost, approach;
  solve_load_sequence(grid, rough_gap(grid), *influence, {.limit_pressure = 2.5e9, .tolerance = 1e-9}, loads,
                      [&](const Contact& c) {
                        stored.push_back(elastic_energy(grid, c));
                        lost.push_back(plastic_work(grid, c, 2.5e9));
                        approach.push_back(c.approach);
                      });
  REQUIRE(lost.front() > 0);
  for (std::size_t k = 1; k < loads.size(); ++k) {
    const double step = approach[k - 1] - approach[k], given = stored[k - 1] - stored[k];
    CHECK(given >= loads[k] * step);
    CHECK(given <= loads[k - 1] * step);
    CHECK(relative_error(lost[k], lost.front()) <= 1e-7);
  }
}
