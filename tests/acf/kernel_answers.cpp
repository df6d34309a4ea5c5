// The answers where there is no kernel of the requested size.
#include "acf/kernel.hpp"
#include "reference/exponential_target.hpp"
#include "requests.hpp"

using namespace asperity;
using namespace asperity::test;

// n_max ≈ 0.3 c eᶜ is 7 for c = 2.3: narrow or small kernels have positive spectra. Newton's iteration finds
// none of 13 × 13 and 17 × 14 lags, and wider ones meet all the equations.
TEST_CASE("every 10 % cut of the paper is met in full by a kernel of its size, or by a wider one",
          "[kernel][exact]") {
  for (Shape lags : paper) {
    const Kernel k = solve_kernel(cut(lags.nx, lags.ny, std::log(10)));
    CAPTURE(lags.nx, lags.ny, k.report.reason);
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-10);
    CHECK(k.report.answer == (std::min(lags.nx, lags.ny) > 10 ? Answer::wider : Answer::exact));
    CHECK(std::abs(k.values.square().sum() - 1) <= 2e-10);
  }
}

// Patir's equations have no wider kernel.
TEST_CASE("of the 10 % cuts in Patir's formulation one is solved and four are refused, whatever the policy",
          "[kernel][contract]") {
  auto patir = [](Shape lags) { return cut(lags.nx, lags.ny, std::log(10), Formulation::patir); };
  const Kernel solved = solve_kernel(patir({3, 3}));
  CHECK(solved.report.answer == Answer::exact);
  CHECK(solved.report.converged);
  CHECK(solved.report.residual <= 1e-10);
  CHECK(solved.report.change == 0);
  for (Shape lags : {Shape{7, 4}, Shape{17, 4}, Shape{17, 14}, Shape{13, 13}})
    for (InfeasiblePolicy policy :
         {InfeasiblePolicy::automatic, InfeasiblePolicy::nearest, InfeasiblePolicy::error}) {
      CAPTURE(lags.nx, lags.ny, name_of(policy));
      KernelRequest request = patir(lags);
      request.infeasible = policy;
      try {
        solve_kernel(request);
        FAIL_CHECK("not refused");
      } catch (const ParameterError& e) {
        CHECK(e.name == "lags");
        CHECK_THAT(e.what(), ContainsSubstring("no kernel of " + std::to_string(lags.nx) + "x" +
                                               std::to_string(lags.ny) + " lags"));
      }
    }
}

// The paper's larger problem, under a cut that has no kernel of its size.
TEST_CASE("what is infeasible is answered as asked", "[kernel][contract]") {
  KernelRequest request = cut(31, 31, 2.3);
  request.infeasible = InfeasiblePolicy::error;
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel wider = solve_kernel(request);
  CHECK(wider.report.answer == Answer::wider);
  CHECK(wider.report.change <= 1e-10);
  CHECK(wider.values.rows() > 61);
}

// exp(-(r/10)^2.3) belongs to no surface: its slopes would have the variance -R''(0) = 0. Clipping the
// spectrum is the least change in the mean square over the plane, and the same from many lags as from those
// where 1e-3 is left.
TEST_CASE("a target that no number of lags gives a kernel is clipped at once, as near as with many lags",
          "[kernel][law]") {
  KernelRequest request;
  auto fall = [](double p, double q) { return std::exp(-std::pow(std::hypot(p, q) / 10, 2.3)); };
  request.target = fall;
  request.target.reach = [](double t) {
    const auto n = static_cast<Index>(std::ceil(10 * std::pow(-std::log(t), 1 / 2.3)));
    return Shape{n, n};
  };
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);  // changed by more than 1e-2
  request.infeasible = InfeasiblePolicy::nearest;
  const Kernel kernel = solve_kernel(request);
  CHECK(kernel.report.answer == Answer::nearest);
  CHECK(kernel.report.steps <= 20);  // of the one trial that asks
  CHECK(kernel.lags == request.target.reach(1e-3));
  CHECK(kernel.report.change > 1e-5);
  CHECK_FALSE(kernel.report.converged);
  request.method = Method::spectral;
  request.lags = {80, 80};
  CHECK(std::abs(solve_kernel(request).report.error - kernel.report.error) <=
        0.05 * kernel.report.error + 1e-4);
  request.method = Method::newton_krylov;
  request.lags = {};
  request.infeasible = InfeasiblePolicy::error;
  CHECK_THROWS_AS(solve_kernel(request), ParameterError);
}

TEST_CASE("targets at the limits end in a kernel with its error, or in a refusal", "[kernel][contract]") {
  auto outcome = [](Target target, Shape lags) {
    KernelRequest request;
    request.target = std::move(target);
    request.lags = lags;
    return solve_kernel(request);
  };
  auto gaussian = [](double c) {
    return [c](double p, double q) { return std::exp(-c * (p * p + q * q) / 961); };
  };
  const auto delta = [](double p, double q) { return p == 0 && q == 0 ? 1.0 : 0.0; };
  CHECK(outcome(delta, {1, 1}).report.residual == 0);
  CHECK(outcome(delta, {9, 5}).report.residual <= 4 * epsilon);
  for (double c : {4.6, 14.0, 30.0}) {  // spectra from -1e-3 to round-off
    const Kernel k = outcome(gaussian(c), {31, 31});
    CAPTURE(c, name_of(k.report.answer));
    CHECK(k.report.converged);
    CHECK(k.report.residual <= 1e-6);
    CHECK(k.values.isFinite().all());
  }
  CHECK_THROWS_AS(outcome([](double, double) { return 1.0; }, {31, 31}), ParameterError);
  const Kernel thin = outcome(ExponentialTarget{300, 3}, {600, 6});  // γ = 100
  CHECK(thin.report.residual <= 1e-10);
  CHECK(outcome(ExponentialTarget{20, 1e-3}, {50, 1}).report.residual <= 1e-10);
}

// e^-18.4 at the edge of its torus is far below; the root's own tail is cut.
TEST_CASE("the root of the spectrum takes no steps and meets the target nearly everywhere", "[kernel][law]") {
  KernelRequest request = cut(63, 63, 4.6);
  request.method = Method::spectral;
  const Kernel root = solve_kernel(request);
  CHECK(root.report.answer == Answer::spectral);
  CHECK(root.report.steps == 0);
  CHECK(root.report.error <= 2e-4);
}
