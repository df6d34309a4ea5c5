#include "acf/kernel_solver.hpp"

#include <algorithm>

#include "acf/kernel_evaluation.hpp"
#include "acf/solver_constants.hpp"
#include "acf/wording.hpp"

namespace asperity {
namespace {

// Of the change that the automatic answer makes.
double bound(const KernelRequest& request) { return std::max(solver::largest_change, request.acf_tolerance); }

}  // namespace

void KernelSolver::run() {
  if (problem_.of_no_surface()) return try_in_turn({&KernelSolver::root});
  switch (method()) {
    case Method::spectral:
      return try_in_turn({&KernelSolver::root});
    case Method::fixed_point:
      return try_in_turn({&KernelSolver::by_fixed_point});
    case Method::conjugate_gradient:
      return try_in_turn({&KernelSolver::by_conjugate_gradient});
    case Method::newton_krylov:
      return try_in_turn({&KernelSolver::wider_of_smooth, &KernelSolver::by_newton,
                          &KernelSolver::wider_of_barely_negative});
  }
}

// What has no kernel of positive spectrum.
void KernelSolver::answer() {
  try_in_turn({&KernelSolver::modest_squares, &KernelSolver::by_policy});
  const KernelRequest& request = problem_.request();
  if (request.infeasible == InfeasiblePolicy::automatic &&
      !(best_ && best_->report.residual <= bound(request)))
    problem_.refuse(excuse() + closest());
}

void KernelSolver::try_in_turn(std::initializer_list<Step> steps) {
  for (Step step : steps)
    if (!solved()) choose((this->*step)());
}

void KernelSolver::choose(Attempt attempt) {
  IterationResult& effort = attempt.effort;
  effort_.converged = effort.converged;
  effort_.steps += effort.steps;
  effort_.residuals += effort.residuals;
  effort_.jacobian_products += effort.jacobian_products;
  effort_.preconditionings += effort.preconditionings;
  effort_.system_seconds += effort.system_seconds;
  if (!effort.reason.empty()) effort_.reason = std::move(effort.reason);
  if (!attempt.unknowns.empty()) unknowns_ = std::move(attempt.unknowns);
  if (attempt.candidate && (!best_ || problem_.better(*attempt.candidate, *best_)))
    best_ = std::move(attempt.candidate);
}

// ---- attempts, where they are of use ----

Attempt KernelSolver::root() {
  return spectral_root(problem_, problem_.of_no_surface() ? Answer::nearest : Answer::spectral);
}

Attempt KernelSolver::by_newton() {
  if (!problem_.recognised()) return newton(problem_);
  Attempt none;
  none.effort.reason = "recognised before any iteration";
  return none;
}

Attempt KernelSolver::wider_of_smooth() { return may_widen() && problem_.smooth() ? wider() : Attempt{}; }

Attempt KernelSolver::wider_of_barely_negative() {
  const bool no_start = effort_.steps == 0 && !effort_.converged,
             barely_negative = problem_.feasibility().least > solver::nearly_smooth;
  return may_widen() && !problem_.smooth() && (no_start || barely_negative) ? wider() : Attempt{};
}

Attempt KernelSolver::modest_squares() {
  if (problem_.recognised()) return {};
  return least_squares(problem_, unknowns_, solver::modest_budget(problem_.equations().count()));
}

Attempt KernelSolver::large_squares() {
  return least_squares(problem_, unknowns_, solver::large_budget(problem_.equations().count()));
}

Attempt KernelSolver::by_policy() {
  const InfeasiblePolicy policy = problem_.request().infeasible;
  if (policy == InfeasiblePolicy::error) problem_.refuse(excuse());
  if (policy == InfeasiblePolicy::least_squares || !problem_.zero_phase()) return large_squares();
  const bool close =
      policy == InfeasiblePolicy::automatic && best_ && best_->report.residual <= solver::negligible_change;
  return close || problem_.of_no_surface() ? Attempt{} : wider();
}

// Once: the second time it would come to the same.
Attempt KernelSolver::wider() {
  Attempt attempt;
  if (widened_)
    attempt.effort.reason = *widened_;
  else
    widened_ = (attempt = wider_kernel(problem_, best_)).effort.reason;
  return attempt;
}

bool KernelSolver::may_widen() const {
  const InfeasiblePolicy policy = problem_.request().infeasible;
  return problem_.zero_phase() && !problem_.recognised() && policy != InfeasiblePolicy::error &&
         policy != InfeasiblePolicy::least_squares;
}

// ---- in words ----

// Why there is no kernel, and what can be done.
std::string KernelSolver::excuse() const {
  const Shape lags = problem_.lags();
  const double least = problem_.feasibility().least;
  std::string words = "no kernel of " + text(lags) + " lags has this autocorrelation (" + effort_.reason;
  if (least < 0) words += "; its spectrum falls to " + number(least) + " of its maximum";
  const bool more = !problem_.request().target.known && !problem_.of_no_surface();
  return words + ")" + (more ? ": take more, such as " + text({2 * lags.nx, 2 * lags.ny}) : "");
}

std::string KernelSolver::closest() const {
  if (!best_) return "; nothing close to it was found";
  const KernelRequest& request = problem_.request();
  return "; the closest one found changes it by " + number(best_->report.residual) +
         " of the variance, more than " + number(bound(request)) + " (see infeasible, acf-tolerance" +
         (request.target.known ? "; a biased estimate is one that a surface has)" : ")");
}

// ---- the answer ----

void KernelSolver::complete(KernelReport& report) const {
  const bool other = method() == Method::fixed_point || method() == Method::conjugate_gradient;
  if (other && !(report.residual <= problem_.request().tolerance)) report.answer = Answer::best;
  const bool exact = report.answer == Answer::exact,
             as_asked = report.answer == Answer::spectral || report.answer == Answer::best;
  if (!exact) report.change = report.residual;
  report.reason = exact ? "solved" : as_asked ? effort_.reason : excuse();
  judge(report, problem_.request());
  report.feasibility = problem_.feasibility().least;
  report.newton_steps = effort_.steps;
  report.equation_seconds = effort_.system_seconds;
  report.residuals = effort_.residuals;
  report.jacobian_products = effort_.jacobian_products;
  report.preconditionings = effort_.preconditionings;
}

Kernel KernelSolver::finish() {
  if (method() == Method::newton_krylov && !solved()) answer();
  if (!best_) problem_.refuse("no finite kernel was found (" + effort_.reason + ")");
  complete(best_->report);
  return *std::move(best_);
}

}  // namespace asperity
