#include "math/fixed_point.hpp"

#include <cmath>
#include <vector>

#include "support.hpp"

using namespace asperity;

namespace {

// g = A u + b with A symmetric of eigenvalues 0.99 … 0, the kth along the kth axis.
FixedPoint solve_linear(std::vector<double>& u, const FixedPointOptions& options) {
  const auto n = static_cast<double>(u.size());
  const FixedPointMap map = [n](std::span<const double> x, std::span<double> g) {
    for (std::size_t k = 0; k < x.size(); ++k) g[k] = 0.99 * (1 - static_cast<double>(k) / n) * x[k] + 1;
  };
  return solve_fixed_point(map, u, std::vector<double>(u.size(), 1.0), options);
}

}  // namespace

// A contraction by 0.99 shrinks the residual, 1 at first, by 0.99 a step: ln(1e-6)/ln(0.99) = 1375 of them.
TEST_CASE("Anderson's acceleration finds a fixed point in a tenth of the evaluations", "[kinsol][law]") {
  std::vector<double> plain(20, 0), fast(20, 0);
  const FixedPoint slow = solve_linear(plain, {1e-6, 0, 5000}), found = solve_linear(fast, {1e-6, 5, 5000});
  REQUIRE(slow.converged);
  REQUIRE(found.converged);
  CHECK(std::abs(slow.evaluations - 1375) <= 2);
  CHECK(found.evaluations <= 137);
  for (std::size_t k = 0; k < fast.size(); ++k)
    CHECK(std::abs(fast[k] - 1 / (1 - 0.99 * (1 - static_cast<double>(k) / 20))) <= 1e-6 * 100);
}

TEST_CASE("a fixed point that is not reached is left at the last evaluation, with its residual",
          "[kinsol][contract]") {
  std::vector<double> u(20, 0);
  const FixedPoint found = solve_linear(u, {1e-6, 0, 10});
  CHECK_FALSE(found.converged);
  CHECK(found.evaluations == 10);
  CHECK(found.residual == Approx(std::pow(0.99, 9)).epsilon(1e-12));
}

TEST_CASE("an exception in the map leaves the solver as it is", "[kinsol][contract]") {
  std::vector<double> u(3, 0);
  const FixedPointMap map = [](std::span<const double>, std::span<double>) {
    throw std::runtime_error("stop");
  };
  CHECK_THROWS_WITH(solve_fixed_point(map, u, u, {}), "stop");
}
