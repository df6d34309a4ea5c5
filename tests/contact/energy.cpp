#include "contact/energy.hpp"

#include <numbers>

#include "contact/flattening.hpp"
#include "contact/sweep.hpp"
#include "scenes.hpp"

using namespace asperity;
using namespace asperity::test;

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
