#include "acf/least_squares.hpp"

#include <gsl/gsl_errno.h>

#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

int calls = 0;
void count_call(const char*, const char*, int, int) { ++calls; }

// σ² exp(-(r/10)^2.3) cut at 7 × 7 lags: of no surface.
ZeroPhaseEquations infeasible() {
  return ZeroPhaseEquations(
      Target([](double p, double q) { return std::exp(-std::pow(std::hypot(p, q) / 10, 2.3)); }), {7, 7},
      false);
}

}  // namespace

// The handler, one for the process, was set off meanwhile and put back: of two threads one could leave it off
// for good.
TEST_CASE("least squares leave GSL's error handler alone and never call it, however they end",
          "[least-squares][contract]") {
  gsl_error_handler_t* const former = gsl_set_error_handler(&count_call);
  calls = 0;
  bool seen = true;
  auto on_step = [&](const IterationStep&) {
    gsl_error_handler_t* const present = gsl_set_error_handler(&count_call);
    seen = seen && present == &count_call;
  };
  for (const double scale : {1.0, 0.0, 1e150}) {
    CAPTURE(scale);
    ZeroPhaseEquations equations = infeasible();
    std::vector<double> u = equations.start();
    for (double& x : u) x *= scale;
    minimise_squares(equations, u, {.max_iterations = 20, .max_products = 500, .on_step = on_step});
  }
  ZeroPhaseEquations equations = infeasible();
  std::vector<double> u = equations.start();
  const IterationResult exhausted = minimise_squares(equations, u, {.max_products = 1, .on_step = on_step});
  CHECK(!exhausted.converged);
  const IterationResult whole =
      minimise_squares(equations, u, {.step_tolerance = 1e-300, .gradient_tolerance = 0});
  CHECK(whole.steps >= 1);
  CHECK(seen);
  CHECK(calls == 0);
  CHECK(gsl_set_error_handler(former) == &count_call);
}
