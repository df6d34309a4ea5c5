#include "acf/kernel_solver.hpp"

#include <algorithm>

#include "acf/kernel_evaluation.hpp"
#include "acf/wording.hpp"
#include "core/calibration.hpp"

namespace asperity {

namespace solver = calibration::acf;

void KernelSolver::run() {
  if (method() == Method::spectral || problem_.of_no_surface) return choose(spectral_root(problem_));
  if (method() == Method::fixed_point) return choose(fixed_point(problem_));
  if (method() == Method::conjugate_gradient) return choose(conjugate_gradient(problem_));
  const InfeasiblePolicy policy = problem_.request.infeasible;
  const bool may_widen = problem_.zero_phase && !problem_.recognised && policy != InfeasiblePolicy::error &&
                         policy != InfeasiblePolicy::least_squares;
  auto barely_negative = [this] {
    const bool no_start = effort_.steps == 0 && !effort_.converged;
    return !problem_.smooth && (no_start || problem_.feasibility.least > solver::nearly_smooth);
  };
  try_in_turn({[&] { return may_widen && problem_.smooth ? wider() : Attempt{}; },
               [&] { return newton(problem_); },
               [&] { return may_widen && barely_negative() ? wider() : Attempt{}; }});
}

void KernelSolver::try_in_turn(const std::vector<std::function<Attempt()>>& attempts) {
  for (const auto& attempt : attempts)
    if (!solved()) choose(attempt());
}

void KernelSolver::choose(Attempt attempt) {
  IterationResult& effort = attempt.effort;
  effort_.converged = effort.converged;
  effort_.steps += effort.steps;
  effort_.residuals += effort.residuals;
  effort_.jacobian_products += effort.jacobian_products;
  effort_.preconditionings += effort.preconditionings;
  effort_.equation_seconds += effort.equation_seconds;
  if (!effort.reason.empty()) effort_.reason = std::move(effort.reason);
  if (!attempt.unknowns.empty()) unknowns_ = std::move(attempt.unknowns);
  if (attempt.candidate && (!best_ || problem_.better(*attempt.candidate, *best_)))
    best_ = std::move(attempt.candidate);
}

// Once: a second time it would come to the same.
Attempt KernelSolver::wider() {
  Attempt attempt;
  if (widened_)
    attempt.effort.reason = *widened_;
  else
    widened_ = (attempt = wider_kernel(problem_, best_)).effort.reason;
  return attempt;
}

// What the policy makes of equations that no attempt has solved.
Attempt KernelSolver::answer() {
  const InfeasiblePolicy policy = problem_.request.infeasible;
  if (policy == InfeasiblePolicy::error) problem_.refuse(excuse());
  if (policy == InfeasiblePolicy::least_squares || !problem_.zero_phase)
    return least_squares(problem_, unknowns_, solver::large_budget(problem_.equations->count()));
  const bool close =
      policy == InfeasiblePolicy::automatic && best_ && best_->report.residual <= solver::negligible_change;
  return close || problem_.of_no_surface ? Attempt{} : wider();
}

// Of the change that the automatic answer makes.
double KernelSolver::bound() const {
  return std::max(solver::largest_change, problem_.request.acf_tolerance);
}

// ---- in words ----

// Why there is no kernel, and what can be done.
std::string KernelSolver::excuse() const {
  const Shape lags = problem_.lags;
  const double least = problem_.feasibility.least;
  std::string words = "no kernel of " + text(lags) + " lags has this autocorrelation (" + effort_.reason;
  if (least < 0) words += "; its spectrum falls to " + number(least) + " of its maximum";
  const bool more = !problem_.request.target.known && !problem_.of_no_surface;
  return words + ")" + (more ? ": take more, such as " + text({2 * lags.nx, 2 * lags.ny}) : "");
}

std::string KernelSolver::closest() const {
  if (!best_) return "; nothing close to it was found";
  return "; the closest one found changes it by " + number(best_->report.residual) +
         " of the variance, more than " + number(bound()) + " (see infeasible, acf-tolerance" +
         (problem_.request.target.known ? "; a biased estimate is one that a surface has)" : ")");
}

// ---- the answer ----

void KernelSolver::complete(KernelReport& report) const {
  const bool other = method() == Method::fixed_point || method() == Method::conjugate_gradient;
  if (other && !(report.residual <= problem_.request.tolerance)) report.answer = Answer::best;
  const bool exact = report.answer == Answer::exact,
             as_asked = report.answer == Answer::spectral || report.answer == Answer::best;
  if (!exact) report.change = report.residual;
  report.reason = exact ? "solved" : as_asked ? effort_.reason : excuse();
  judge(report, problem_.request);
  report.feasibility = problem_.feasibility.least;
  report.newton_steps = effort_.steps;
  report.equation_seconds = effort_.equation_seconds;
  report.residuals = effort_.residuals;
  report.jacobian_products = effort_.jacobian_products;
  report.preconditionings = effort_.preconditionings;
}

Kernel KernelSolver::finish() {
  if (method() == Method::newton_krylov && !solved()) {
    const long modest = solver::modest_budget(problem_.equations->count());
    try_in_turn({[&] { return problem_.recognised ? Attempt{} : least_squares(problem_, unknowns_, modest); },
                 [&] { return answer(); }});
    const bool bounded = problem_.request.infeasible == InfeasiblePolicy::automatic;
    if (bounded && !(best_ && best_->report.residual <= bound())) problem_.refuse(excuse() + closest());
  }
  if (!best_) problem_.refuse("no finite kernel was found (" + effort_.reason + ")");
  complete(best_->report);
  return *std::move(best_);
}

}  // namespace asperity
