#include "acf/kernel.hpp"
#include "acf/table.hpp"
#include "core/error.hpp"
#include "support.hpp"

using namespace asperity;
using namespace asperity::test;

namespace {

// The steps of all iterations until the memory was refused; -1 where it was not.
int steps_until_refused(KernelRequest request) {
  int steps = 0;
  request.progress = [&](const KernelProgress&) { ++steps; };
  try {
    solve_kernel(request);
  } catch (const ParameterError& e) {
    CHECK(e.name == "memory");
    return steps;
  }
  return -1;
}

KernelRequest exponential(double length) {
  EllipticTarget model;
  model.length_x = model.length_y = length;
  KernelRequest request;
  request.target = model.target();
  return request;
}

}  // namespace

// 590 MB were written, and a minute spent, before anybody said a word.
TEST_CASE("a kernel that takes more memory than there shall be is refused before any step",
          "[kernel][contract]") {
  KernelRequest request = exponential(9);
  request.memory = kernel_cost(first_lags(request)).memory;
  CHECK(steps_until_refused(request) == -1);
  request.memory -= 1;
  CHECK(steps_until_refused(request) == 0);
  request.lags = {30, 30};
  CHECK(steps_until_refused(request) == 0);
  Field white = Field::Zero(20, 20);
  white(0, 0) = 1;
  request.lags = {};
  request.target = target_of_table(half_plane_of_quadrant(white));
  request.memory = kernel_cost({20, 20}).memory - 1;
  CHECK(steps_until_refused(request) == 0);
}

// An exponential that has fallen to 10 % at the last of 31 lags has no kernel of 31 × 31.
TEST_CASE("a kernel wider than its lags is refused where it takes more memory than there shall be",
          "[kernel][contract]") {
  KernelRequest request = exponential(31);
  request.lags = {31, 31};
  request.memory = wider_kernel_cost(request.lags).memory;
  CHECK(solve_kernel(request).report.answer == Answer::wider);
  request.memory = kernel_cost(request.lags).memory;
  CHECK(steps_until_refused(request) >= 0);
}

// It lies on a torus of four times the lags each way: 165 MB where 114 were allowed.
TEST_CASE("the root of a spectrum is refused where its torus takes more memory than there shall be",
          "[kernel][contract]") {
  KernelRequest request = exponential(9);
  request.method = Method::spectral;
  request.memory = wider_kernel_cost(first_lags(request)).memory;
  CHECK(steps_until_refused(request) == -1);
  request.memory -= 1;
  CHECK(steps_until_refused(request) == 0);
}

TEST_CASE("a search begins with the lags prescribed, those of its table, or those that the tolerance takes",
          "[kernel][exact]") {
  KernelRequest request = exponential(10);
  const Shape open = first_lags(request);  // where 5e-3 are left: 10 log10(200) = 23.01
  CHECK(open == Shape{24, 24});
  request.lags = {3, 4};
  CHECK(first_lags(request) == Shape{3, 4});
}
