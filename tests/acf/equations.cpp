#include "acf/equations.hpp"

#include <algorithm>

#include "acf/target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

using Values = std::vector<double>;

Field exponential(Shape lags) {
  const ExponentialTarget target{static_cast<double>(lags.nx), static_cast<double>(lags.ny), std::exp(-4.6)};
  return Field::NullaryExpr(lags.nx, lags.ny, [&](Index p, Index q) {
    return target(static_cast<double>(p), static_cast<double>(q));
  });
}

Values random_values(Shape lags, unsigned seed) {
  const Field f = random_field(lags, seed);
  return {f.data(), f.data() + f.size()};
}

double absolute_sum(const Field& kernel) { return kernel.abs().sum(); }

// R(p,q) of a kernel by the double sum of its definition.
double direct(const Field& kernel, Index p, Index q) {
  double sum = 0;
  for (Index k = 0; k + p < kernel.rows(); ++k)
    for (Index l = std::max<Index>(0, -q); l < kernel.cols() && l + q < kernel.cols(); ++l)
      sum += kernel(k, l) * kernel(k + p, l + q);
  return sum;
}

template <class Equations>
Values residual(Equations& equations, const Values& u) {
  Values f(u.size());
  equations.residual(u, f);
  return f;
}

template <class Equations>
Values product(Equations& equations, const Values& u, const Values& v) {
  Values out(v.size());
  equations.linearize(u);
  equations.jacobian(v, out);
  return out;
}

const std::vector<Shape> shapes{{1, 1}, {1, 6}, {7, 1}, {2, 2}, {3, 5}, {13, 4}, {16, 17}};

// Runs `claim` on both formulations; the guard is off, for random vectors have spectra of either sign.
template <class Claim>
void for_both_formulations(Shape lags, Claim claim) {
  CAPTURE(lags.nx, lags.ny);
  SymmetricEquations symmetric(exponential(lags));
  symmetric.guard = false;
  claim(symmetric);
  PatirEquations patir(exponential(lags));
  claim(patir);
}

}  // namespace

// Each lag is a sum of products bounded by (Σ|kernel|)²; the two transforms add a few ε of that.
TEST_CASE("both residuals equal the double sum of the definition for every shape", "[equations][exact]") {
  for (Shape lags : shapes) {
    const Field target = exponential(lags);
    const Values u = random_values(lags, 1);
    for_both_formulations(lags, [&](auto& equations) {
      const Field kernel = equations.kernel(u);
      const Values f = residual(equations, u);
      const double bound = 8 * epsilon * std::pow(1 + absolute_sum(kernel), 2);
      for (Index p = 0; p < lags.nx; ++p)
        for (Index q = 0; q < lags.ny; ++q)
          CHECK(std::abs(f[static_cast<std::size_t>(p * lags.ny + q)] + target(p, q) -
                         direct(kernel, p, q)) <= bound);
    });
  }
}

// F is quadratic, F(u) = Q(u,u) - R, so F(u+v) - F(u) - J(u)v = Q(v,v) = F(v) + R, exactly and not only to an
// order.
TEST_CASE("the Jacobian leaves exactly the quadratic part of the residual", "[equations][law]") {
  for (Shape lags : shapes) {
    const Field target = exponential(lags);
    const Values u = random_values(lags, 2), v = random_values(lags, 3);
    Values sum = u;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += v[i];
    for_both_formulations(lags, [&](auto& equations) {
      const Values both = residual(equations, sum), first = residual(equations, u),
                   second = residual(equations, v);
      const Values linear = product(equations, u, v);
      const double size = 1 + absolute_sum(equations.kernel(u)) + absolute_sum(equations.kernel(v));
      for (std::size_t i = 0; i < u.size(); ++i) {
        const double left_over = both[i] - first[i] - linear[i] - second[i] - target.data()[i];
        CHECK(std::abs(left_over) <= 16 * epsilon * size * size);
      }
    });
  }
}

TEST_CASE("the symmetric Jacobian is self-adjoint in the inner product of the multiplicities",
          "[equations][law]") {
  for (Shape lags : shapes) {
    SymmetricEquations equations(exponential(lags));
    const Values a = random_values(lags, 4), u = random_values(lags, 5), v = random_values(lags, 6);
    auto inner = [&](const Values& x, const Values& y) {
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) sum += equations.multiplicity()[i] * x[i] * y[i];
      return sum;
    };
    const double left = inner(product(equations, a, u), v), right = inner(u, product(equations, a, v));
    // |⟨J u, v⟩| ≤ 2 max|a^| ‖u‖ ‖v‖ ≤ 2 Σ|a| ‖u‖ ‖v‖
    const double size = 2 * absolute_sum(equations.kernel(a)) * std::sqrt(inner(u, u) * inner(v, v));
    CAPTURE(lags.nx, lags.ny);
    CHECK(std::abs(left - right) <= 8 * epsilon * size);
  }
}

// For a = δ both Jacobians are diagonal: 2 for the even kernel; 1, and 2 at lag zero, for Patir's.
TEST_CASE("at white noise the preconditioner is the exact inverse of the Jacobian", "[equations][exact]") {
  for (Shape lags : shapes) {
    Values delta(static_cast<std::size_t>(lags.cells()), 0.0);
    delta[0] = 1;
    const Values v = random_values(lags, 7);
    for_both_formulations(lags, [&](auto& equations) {
      Values back = product(equations, delta, v);
      equations.precondition(back);
      const double bound = 16 * epsilon * (1 + absolute_sum(equations.kernel(v)));
      for (std::size_t i = 0; i < v.size(); ++i) CHECK(std::abs(back[i] - v[i]) <= bound);
    });
  }
}

TEST_CASE("the guard refuses a kernel whose spectrum changes sign and lets the start pass",
          "[equations][contract]") {
  SymmetricEquations equations(exponential({13, 4}));
  const Values start = equations.start();
  Values f(start.size()), negative(start.size(), 0.0);
  CHECK(equations.residual(start, f));
  negative[0] = -1;
  CHECK_FALSE(equations.residual(negative, f));
  equations.guard = false;
  CHECK(equations.residual(negative, f));
}

// Symmetric multiplicities: 1 at the centre, 2 on the axes, 4 elsewhere; both starts carry R(0,0) = 1 to
// round-off.
TEST_CASE("both starts have the variance of the target", "[equations][exact]") {
  for (Shape lags : shapes)
    for_both_formulations(lags, [&](auto& equations) {
      const double variance = equations.kernel(equations.start()).square().sum();
      CHECK(std::abs(variance - 1) <= epsilon * static_cast<double>(4 * lags.cells()));
    });
}
