#include "acf/newton_krylov.hpp"

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// u_i² = c_i, with the exact inverse of the diagonal Jacobian as preconditioner.
struct Squares : Equations {
  std::vector<double> at;

  explicit Squares(std::vector<double> c) {
    target_ = std::move(c);
    multiplicity_.assign(target_.size(), 1.0);
  }
  bool residual(std::span<const double> u, std::span<double> f) override {
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = u[i] * u[i] - target_[i];
    return true;
  }
  void linearize(std::span<const double> u) override { at.assign(u.begin(), u.end()); }
  void jacobian(std::span<const double> v, std::span<double> out) override {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = 2 * at[i] * v[i];
  }
  void precondition(std::span<double> v) override {
    for (std::size_t i = 0; i < v.size(); ++i) v[i] /= 2 * at[i];
  }
  std::vector<double> start() override { return target_; }
  Field kernel(std::span<const double>) const override { return {}; }
};

}  // namespace

// |u² - c| ≤ tol gives |u - √c| ≤ tol/(2√c) ≤ tol/2 for c ≥ 1.
TEST_CASE("square roots are found to the tolerance asked for", "[newton][exact]") {
  Squares squares({1, 2, 9, 16});
  std::vector<double> u{3, 3, 3, 3};
  const IterationResult result = solve_newton_krylov(squares, u, {.tolerance = 1e-12});
  CHECK(result.converged);
  CHECK(result.steps <=
        7);  // Newton's 3 → √c from 1.5 to 3 away: e ← e²/2u, four to six halvings of the exponent
  for (std::size_t i = 0; i < u.size(); ++i) CHECK(std::abs(u[i] - std::sqrt(squares.target()[i])) <= 1e-12);
}

TEST_CASE("with the exact inverse as preconditioner a Newton step takes one product", "[newton][law]") {
  Squares squares({2, 5, 7});
  std::vector<double> u{2, 2, 2};
  const IterationResult result = solve_newton_krylov(squares, u, {});
  CHECK(result.converged);
  // One in GMRES and one more for the slope that the line search asks for.
  CHECK(result.jacobian_products <= 2 * result.steps);
}

TEST_CASE("an equation without a root ends within the steps allowed, at a finite iterate",
          "[newton][contract]") {
  Squares squares({-1});
  std::vector<double> u{1.7};
  const IterationResult result = solve_newton_krylov(squares, u, {.max_steps = 12, .max_products = 40});
  CHECK_FALSE(result.converged);
  CHECK_FALSE(result.reason.empty());
  CHECK(result.steps <= 12);
  CHECK(std::isfinite(u[0]));
}

TEST_CASE("an iteration that cannot leave the edge of the domain ends there at once", "[newton][contract]") {
  struct Bounded : Squares {
    using Squares::Squares;
    bool residual(std::span<const double> u, std::span<double> f) override {
      return Squares::residual(u, f) && u[0] >= 3;
    }
  } bounded({1});
  std::vector<double> u{3};
  const IterationResult result = solve_newton_krylov(bounded, u, {});
  CHECK_FALSE(result.converged);
  CHECK_FALSE(result.reason.empty());
  CHECK(result.steps <= 1);
  CHECK(u[0] == 3);
}

TEST_CASE("an exception thrown by the equations comes out of the solver as it was", "[newton][contract]") {
  struct Broken {};
  struct Faulty : Squares {
    using Squares::Squares;
    bool residual(std::span<const double> u, std::span<double> f) override {
      return fault == 'F' ? throw Broken{} : Squares::residual(u, f);
    }
    void jacobian(std::span<const double> v, std::span<double> out) override {
      fault == 'J' ? throw Broken{} : Squares::jacobian(v, out);
    }
    void linearize(std::span<const double> u) override {
      fault == 'M' ? throw Broken{} : Squares::linearize(u);
    }
    char fault = 0;
  } faulty({2, 3});
  for (const char fault : {'F', 'J', 'M'}) {  // of the residual, the product, the preconditioner
    CAPTURE(fault);
    faulty.fault = fault;
    std::vector<double> u{1, 1};
    CHECK_THROWS_AS(solve_newton_krylov(faulty, u, {}), Broken);
  }
}
