#include "acf/newton_krylov.hpp"

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// u_i² = c_i, with the exact inverse of the diagonal Jacobian as preconditioner.
struct Squares {
  std::vector<double> c, u;

  NonlinearSystem system() {
    NonlinearSystem s;
    s.residual = [this](std::span<const double> at, std::span<double> f) {
      for (std::size_t i = 0; i < f.size(); ++i) f[i] = at[i] * at[i] - c[i];
      return true;
    };
    s.linearize = [this](std::span<const double> at) { u.assign(at.begin(), at.end()); };
    s.jacobian = [this](std::span<const double> v, std::span<double> out) {
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = 2 * u[i] * v[i];
    };
    s.precondition = [this](std::span<double> v) {
      for (std::size_t i = 0; i < v.size(); ++i) v[i] /= 2 * u[i];
    };
    s.scale.assign(c.size(), 1.0);
    return s;
  }
};

}  // namespace

// |u² - c| ≤ tol gives |u - √c| ≤ tol/(2√c) ≤ tol/2 for c ≥ 1.
TEST_CASE("square roots are found to the tolerance asked for", "[newton][exact]") {
  Squares squares{{1, 2, 9, 16}, {}};
  std::vector<double> u{3, 3, 3, 3};
  const IterationResult result = solve_newton_krylov(squares.system(), u, {.tolerance = 1e-12});
  CHECK(result.converged);
  CHECK(result.steps <=
        7);  // Newton's 3 → √c from 1.5 to 3 away: e ← e²/2u, four to six halvings of the exponent
  for (std::size_t i = 0; i < u.size(); ++i) CHECK(std::abs(u[i] - std::sqrt(squares.c[i])) <= 1e-12);
}

TEST_CASE("with the exact inverse as preconditioner a Newton step takes one product", "[newton][law]") {
  Squares squares{{2, 5, 7}, {}};
  std::vector<double> u{2, 2, 2};
  const IterationResult result = solve_newton_krylov(squares.system(), u, {});
  CHECK(result.converged);
  // One in GMRES and one more for the slope that the line search asks for.
  CHECK(result.jacobian_products <= 2 * result.steps);
}

TEST_CASE("an equation without a root ends within the steps allowed, at a finite iterate",
          "[newton][contract]") {
  Squares squares{{-1}, {}};
  std::vector<double> u{1.7};
  const IterationResult result =
      solve_newton_krylov(squares.system(), u, {.max_steps = 12, .max_products = 40});
  CHECK_FALSE(result.converged);
  CHECK_FALSE(result.reason.empty());
  CHECK(result.steps <= 12);
  CHECK(std::isfinite(u[0]));
}

TEST_CASE("an iteration that cannot leave the edge of the domain says so and stays inside",
          "[newton][contract]") {
  Squares squares{{1}, {}};
  NonlinearSystem system = squares.system();
  const auto everywhere = system.residual;
  system.residual = [&](std::span<const double> u, std::span<double> f) {
    return everywhere(u, f) && u[0] >= 3;
  };
  std::vector<double> u{3};
  const IterationResult result = solve_newton_krylov(system, u, {});
  CHECK_FALSE(result.converged);
  CHECK(result.reason == "every shorter step leaves the domain of the equations");
  CHECK(u[0] == 3);
}

TEST_CASE("an exception thrown by the equations comes out of the solver as it was", "[newton][contract]") {
  struct Broken {};
  Squares squares{{2, 3}, {}};
  std::vector<double> u{1, 1};
  SECTION("by the residual") {
    NonlinearSystem system = squares.system();
    system.residual = [](auto, auto) -> bool { throw Broken{}; };
    CHECK_THROWS_AS(solve_newton_krylov(system, u, {}), Broken);
  }
  SECTION("by the product") {
    NonlinearSystem system = squares.system();
    system.jacobian = [](auto, auto) { throw Broken{}; };
    CHECK_THROWS_AS(solve_newton_krylov(system, u, {}), Broken);
  }
  SECTION("by the preconditioner") {
    NonlinearSystem system = squares.system();
    system.linearize = [](auto) { throw Broken{}; };
    CHECK_THROWS_AS(solve_newton_krylov(system, u, {}), Broken);
  }
}
