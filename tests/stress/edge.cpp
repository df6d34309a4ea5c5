/// The edge of a sliding contact, where its largest stress lies from some friction on.
#include "stress/edge.hpp"

#include <numbers>

#include "layer.hpp"
#include "stress/points.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

double von_mises_at(double x, double z, double nu, double mu) {
  return von_mises(hertz_stress(x, 0, z, nu, Friction{mu, 0}));
}

// The largest below the surface in the plane y = 0, where it is by symmetry, of Hamilton's field.
double deep_maximum(double nu, double mu) {
  double x = 0.3, z = 0.45, top = von_mises_at(x, z, nu, mu);
  for (double step = 0.05; step > 1e-5; step /= 2)
    for (bool moved = true; moved;) {
      moved = false;
      for (auto [dx, dz] :
           {std::pair{step, 0.0}, std::pair{-step, 0.0}, std::pair{0.0, step}, std::pair{0.0, -step}})
        if (const double v = von_mises_at(x + dx, z + dz, nu, mu); v > top && z + dz > 0.15)
          top = v, x += dx, z += dz, moved = true;
    }
  return top;
}

}  // namespace

// At the edge (-1, 0, 0) nothing presses or pulls: σxx = (1-2ν)/3 + πμ(4+ν)/8, σyy = -(1-2ν)/3 + 3πμν/8.
TEST_CASE("from edge_friction on the trailing edge bears more than the depth, below it less",
          "[edge][exact]") {
  for (double nu : {-0.25, -0.1, 0.0, 0.15, 0.25, 0.3, 0.35, 0.45, 0.5}) {
    const double mu = edge_friction(nu);
    auto excess = [&](double m) {
      const double k = (1 - 2 * nu) / 3, q = std::numbers::pi * m / 8;
      const double edge = von_mises({k + q * (4 + nu), -k + q * 3 * nu, 0, 0, 0, 0});
      return edge - deep_maximum(nu, m);
    };
    CAPTURE(nu, mu);
    CHECK(excess(mu + 2e-3) > 0);
    CHECK(excess(mu - 2e-3) < 0);
  }
  CHECK(edge_friction(-0.5) == 0);
  CHECK(edge_friction(-1) == 0);
}

// Hamilton's closed form at the edge, Smith & Liu's √J2/p0 to four digits.
TEST_CASE("the closed field has the published stress at the edge of a sliding contact", "[edge][exact]") {
  for (auto [mu, published] : {std::pair{0.4, 0.4646}, std::pair{0.5, 0.5523}})
    CHECK(std::abs(von_mises_at(-1, 0, 0.3, mu) / std::sqrt(3.0) - published) <= 5e-5);
  for (auto [mu, published] : {std::pair{0.0, 0.3580}, std::pair{0.25, 0.3739}})
    CHECK(std::abs(deep_maximum(0.3, mu) / std::sqrt(3.0) - published) <= 5e-5);
}

TEST_CASE("the stated error of a maximum at an edge holds, and those are told from deep ones",
          "[edge][order]") {
  for (double mu : {0.0, 0.2, 0.4, 0.5})
    for (Index n : {32, 64, 96}) {
      const LoadedBody body{hertz_grid(n), hertz_pressure(hertz_grid(n)), 0.3, {mu, 0}};
      const double nu = 0.3, tension = (1 - 2 * nu) / 3 + std::numbers::pi * mu * (4 + nu) / 8;
      const StressSolver solver(body);
      const StressMaximum pulled = maximum_stress(solver, {Criterion::principal, 0}),
                          top = maximum_stress(solver);
      CAPTURE(mu, n, pulled.value, tension, top.value);
      CHECK(std::abs(pulled.value - tension) <= edge_error(body, Criterion::principal));
      CHECK(is_at_edge(pulled, Criterion::principal, body));
      CHECK(is_at_edge(top, Criterion::von_mises, body) == (mu > 0.3));
      if (mu > 0.3)
        CHECK(std::abs(top.value - von_mises_at(-1, 0, nu, mu)) <= edge_error(body, Criterion::von_mises));
    }
}

TEST_CASE("a periodic load on every cell has no edge, one with an open cell or of a free domain has",
          "[edge][contract]") {
  Field p = Field::Ones(4, 3);
  CHECK_FALSE(has_edge({{{4, 3}, 1, 1, true}, p, 0.3}));
  CHECK(has_edge({{{4, 3}, 1, 1}, p, 0.3}));
  p(1, 1) = 0;
  CHECK(has_edge({{{4, 3}, 1, 1, true}, p, 0.3}));
}

// 3 × 3 cells of a unit side, and the corner (½, ½) of the middle one: twist 1 of the pressures about it.
TEST_CASE("points at the surface where constant cells have an infinite stress are told", "[edge][exact]") {
  const Grid grid{{3, 3}, 1, 1};
  Field p = Field::Ones(3, 3);
  p(2, 2) = 2;
  const StressPoints rests({grid, p, 0.3}), slides({grid, p, 0.3, {0.2, 0}}), soft({grid, p, 0.5}),
      repeated({{{3, 3}, 1, 1, true}, p, 0.3, {0.2, 0}});
  CHECK(rests.singular(0.5, 0.5, 0));
  CHECK(rests.singular(1.5, 1.5, 0));
  CHECK(rests.singular(-1.5, -1.5, 0));
  CHECK_FALSE(rests.singular(-0.5, -0.5, 0));  // equal cells
  CHECK_FALSE(rests.singular(0.5, 1, 0));      // a side
  CHECK_FALSE(rests.singular(0.5, 0.5, 1e-3));
  CHECK_FALSE(rests.singular(7.5, 0.5, 0));
  CHECK_FALSE(soft.singular(0.5, 0.5, 0));
  CHECK(slides.singular(0.5, 1, 0));
  CHECK(slides.singular(1, 0.5, 0));
  CHECK(slides.singular(1.5, 0, 0));  // the end of the load
  CHECK(slides.singular(0.5, 0.5, 0));
  CHECK_FALSE(slides.singular(0.5, 0, 0));
  CHECK_FALSE(slides.singular(0, 0, 0));
  CHECK_FALSE(repeated.singular(0.5, 1, 0));
}

// Ever nearer to a side that is singular the stress grows by the same amount a decade, elsewhere it stays.
TEST_CASE("towards a singular side of a cell the stress has the logarithm of the distance", "[edge][law]") {
  const Grid grid{{3, 3}, 1, 1};
  Field p = Field::Ones(3, 3);
  p(2, 2) = 2;
  const StressPoints slides({grid, p, 0.3, {0.2, 0}});
  auto xx = [&](double distance, double y) { return slides.at(0.5 - distance, y, 0)[stress::xx]; };
  const double decade = 2 * 0.2 * std::log(10.0) / std::numbers::pi;  // 2 q ln/π of a step of 1
  CHECK(std::abs(std::abs(xx(1e-6, 1) - xx(1e-5, 1)) - decade) <= 1e-4);
  CHECK(std::abs(xx(1e-6, 0) - xx(1e-5, 0)) <= 1e-4);
}
