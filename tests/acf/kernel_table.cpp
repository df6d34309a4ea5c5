// Tables that are whole, long, noisy or of no surface, and the projections that answer them.
#include <numbers>

#include "acf/kernel.hpp"
#include "acf/kernel_evaluation.hpp"
#include "acf/table.hpp"
#include "acf/wider_kernel.hpp"
#include "math/noise.hpp"
#include "reference/exponential_target.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

// What only a table knows: no autocorrelation of any surface, for R(1) = -0.9 would make a variance negative:
// E(z0 + z1 + z2)² = 3 + 4 R(1) + 2 R(2) < 0.
TEST_CASE("a table that no surface has is refused by its name, or answered by the nearest",
          "[kernel][contract]") {
  KernelRequest request;
  request.target = [](double p, double q) {
    return q != 0 ? 0.0 : p == 0 ? 1.0 : std::abs(p) < 3 ? -0.9 : 0.0;
  };
  request.target.known = Shape{8, 2};
  CHECK_THROWS_AS(solve_kernel(request), DataError);
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel k = solve_kernel(request);
  CHECK(k.report.answer == Answer::nearest);
  CHECK(k.report.change > 0.1);
  CHECK_FALSE(k.report.converged);
  CHECK(shape_of(k.acf_target) == shape_of(k.acf_achieved));
  CHECK(k.acf_achieved.rows() == k.values.rows() + 1);
  CHECK(shape_of(known_lags(k.acf_target)) == Shape{8, 3});
}

namespace {

// The biased autocorrelation of a field is an autocorrelation; its least lags are kept.
Target biased_table(const Field& z, Shape known) {
  Field table(known.nx, 2 * known.ny - 1);
  for (Index p = 0; p < known.nx; ++p)
    for (Index q = 1 - known.ny; q < known.ny; ++q) {
      const Index first = std::max<Index>(0, -q), count = z.cols() - std::abs(q);
      table(p, q + known.ny - 1) =
          (z.block(0, first, z.rows() - p, count) * z.block(p, first + q, z.rows() - p, count)).sum();
    }
  return target_of_table(table);
}

}  // namespace

// Waves with a lay, longer than the table, and nothing shorter than eight samples: hard for a kernel, whose
// spectrum is zero nearly everywhere. An earlier version kept the lags at which it came near to such a table,
// one by a few of them, and reported their error as that of the kernel, converged.
TEST_CASE("a table that a surface has is met as a whole within the tolerance, however long it is",
          "[kernel][contract]") {
  const Field waves = Field::NullaryExpr(64, 48, [](Index i, Index j) {
    const auto x = static_cast<double>(i), y = static_cast<double>(j);
    return std::sin(0.11 * x + 0.02 * y) + 0.6 * std::sin(0.23 * x - 0.05 * y + 1) +
           0.3 * std::cos(0.5 * y + 0.3 * x);
  });
  for (double tolerance : {1e-2, 1e-3}) {
    KernelRequest request;
    request.target = biased_table(waves, {20, 12});
    request.acf_tolerance = tolerance;
    const Kernel k = solve_kernel(request);
    CAPTURE(tolerance, name_of(k.report.answer), k.report.reason);
    CHECK(k.lags == Shape{20, 12});
    CHECK(k.report.converged);
    CHECK(k.report.error <= tolerance);
    const Field achieved = autocorrelation(k.values, 20, 23), asked = half_plane_of(request.target, {20, 12});
    CHECK((achieved - asked).abs().maxCoeff() <= k.report.error + 1e-12);
    // Stored to the kernel's reach: what the table leaves open is recorded, not cut.
    CHECK(k.acf_achieved.rows() == k.values.rows() + 1);
    CHECK(k.report.tail > 0.05);
  }
}

// 5 % of noise on every lag makes a table that no surface has. Its least lags alone would be met to
// round-off.
TEST_CASE("what is judged of a noisy table is the error over all of it", "[kernel][contract]") {
  Field table = half_plane_of(Target(ExponentialTarget{6, 6}), {12, 12});
  WhiteNoise noise(5);
  std::vector<double> row(23);
  for (Index p = 1; p < 12; ++p) {
    noise.row(p, row);
    for (Index q = 0; q < 23; ++q) table(p, q) += 0.05 * row[static_cast<std::size_t>(q)];
  }
  KernelRequest request;
  request.target = target_of_table(table);
  CHECK_THROWS_AS(solve_kernel(request), DataError);
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel k = solve_kernel(request);
  CHECK(k.lags == Shape{12, 12});
  CHECK(k.report.error > 0.02);
  CHECK(k.report.error == k.report.change);
  CHECK_FALSE(k.report.converged);
}

// The sets meet, and the iteration ends in a common point after finitely many steps.
TEST_CASE("projections extend a cut exponential to round-off", "[kernel][exact]") {
  for (Index n : {7, 13, 31}) {
    const ExponentialTarget cut{static_cast<double>(n), static_cast<double>(n)};
    const NearestKernel nearest =
        nearest_kernel(Target(cut), {n, n}, false, {.tolerance = 1e-14, .max_iterations = 100});
    CAPTURE(n, nearest.iterations);
    CHECK(nearest.change <= 1e-14);
  }
}

// R(1) = R(2) = -0.9 belongs to no surface. Three lags do if |r1| <= 1 and r2 >= 2 r1² - 1 (Toeplitz's
// determinant); the closest of these, in the mean square, is where 2 r1 (2 (2 r1² - 1 + 0.9)) + (r1 + 0.9) =
// 0. On a torus of 3f points the parabola is a polygon whose corners in r2 lie 2 (2π/3f) apart at most, and
// the closest point moves by half of that at most.
TEST_CASE("projections end in the closest autocorrelation where there is no extension", "[kernel][law]") {
  Target table([](double p, double q) { return q != 0 ? 0.0 : p == 0 ? 1.0 : -0.9; });
  table.known = Shape{3, 1};
  double low = -0.9, high = 0;
  for (int i = 0; i < 60; ++i) {
    const double r = (low + high) / 2;
    (4 * r * (2 * r * r - 0.1) + r + 0.9 > 0 ? high : low) = r;
  }
  const NearestKernel nearest =
      nearest_kernel(table, {3, 1}, false, {.tolerance = 1e-14, .max_iterations = 3000, .torus = 64});
  const double change = std::max(std::abs(low + 0.9), std::abs(2 * low * low - 0.1));
  CHECK(std::abs(nearest.change - change) <= 2 * std::numbers::pi / 192);
}
