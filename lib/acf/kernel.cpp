#include "acf/kernel.hpp"

#include <algorithm>
#include <cmath>

#include "acf/attempts.hpp"
#include "acf/kernel_evaluation.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

// validation/acf_error_time and validation/stability_kernel show the effect of these constants on targets
// from feasible to hopeless, under each policy; the original fits were not recorded.

// From here to 0 a spectrum, relative to its maximum, is barely negative, and its root is tried first.
constexpr double nearly_smooth = -1e-4;
// No surface has a target whose negative spectrum keeps the fraction `still_negative` from truncation at
// `nearer` to truncation at `farther`; of a negative part due to truncation less than a tenth remains.
constexpr double nearer = 1e-4, farther = 1e-6, still_negative = 0.5;

// Accepted changes of a target without request [σ²]: the largest, and the one below which nothing is widened.
constexpr double largest_change = 1e-2, negligible_change = 1e-6;

// The choice of lags: the target at the cut over the error by the cut, and the growth of the lags per trial.
constexpr double cut_over_error = 5, growth = 1.2;
constexpr int most_trials = 10;
constexpr double most_unknowns = 1 << 24;  // a workstation holds 40 such vectors

// ---- the search at given lags ----

class KernelSolver {
 public:
  // As KernelProblem's; makes the attempts of the method requested.
  KernelSolver(const KernelRequest& request, Shape lags, bool of_no_surface = false)
      : problem_(request, lags, of_no_surface) {
    run();
  }

  bool solved() const { return best_ && (problem_.solved_by(*best_) || method() == Method::spectral); }
  const Kernel& best() const { return *best_; }

  // The best kernel and its report, after the answer to an infeasible target if it is one.
  Kernel finish() {
    if (method() == Method::newton_krylov && !solved()) {
      answer();
      const bool bounded = problem_.request.infeasible == InfeasiblePolicy::automatic;
      if (bounded && !(best_ && best_->report.residual <= bound())) problem_.refuse(excuse() + closest());
    }
    if (!best_) problem_.refuse("no finite kernel was found (" + effort_.reason + ")");
    complete(best_->report);
    return *std::move(best_);
  }

 private:
  Method method() const { return problem_.request.method; }

  void run() {
    if (method() == Method::spectral || problem_.of_no_surface) return choose(spectral_root(problem_));
    const bool may_widen =
        problem_.zero_phase && !problem_.recognised && problem_.request.infeasible != InfeasiblePolicy::error;
    auto barely_negative = [this] {
      const bool no_start = effort_.steps == 0 && !effort_.converged;
      return !problem_.smooth && (no_start || problem_.feasibility.least > nearly_smooth);
    };
    try_in_turn({[&] { return may_widen && problem_.smooth ? wider() : Attempt{}; },
                 [&] { return newton(problem_); },
                 [&] { return may_widen && barely_negative() ? wider() : Attempt{}; }});
  }

  void try_in_turn(const std::vector<std::function<Attempt()>>& attempts) {
    for (const auto& attempt : attempts)
      if (!solved()) choose(attempt());
  }

  void choose(Attempt attempt) {
    IterationResult& effort = attempt.effort;
    effort_.converged = effort.converged;
    effort_.steps += effort.steps;
    effort_.residuals += effort.residuals;
    effort_.jacobian_products += effort.jacobian_products;
    effort_.preconditionings += effort.preconditionings;
    effort_.equation_seconds += effort.equation_seconds;
    if (!effort.reason.empty()) effort_.reason = std::move(effort.reason);
    if (attempt.candidate && (!best_ || problem_.better(*attempt.candidate, *best_)))
      best_ = std::move(attempt.candidate);
  }

  // Once: a second time it would come to the same.
  Attempt wider() {
    Attempt attempt;
    if (widened_)
      attempt.effort.reason = *widened_;
    else
      widened_ = (attempt = wider_kernel(problem_, best_)).effort.reason;
    return attempt;
  }

  // What the policy makes of equations that no attempt has solved.
  void answer() {
    const InfeasiblePolicy policy = problem_.request.infeasible;
    if (policy == InfeasiblePolicy::error || !problem_.zero_phase) problem_.refuse(excuse());
    const bool close =
        policy == InfeasiblePolicy::automatic && best_ && best_->report.residual <= negligible_change;
    if (!close && !problem_.of_no_surface) choose(wider());
  }

  // Of the change that the automatic answer makes.
  double bound() const { return std::max(largest_change, problem_.request.acf_tolerance); }

  // Why there is no kernel, and what can be done.
  std::string excuse() const {
    const Shape lags = problem_.lags;
    const double least = problem_.feasibility.least;
    std::string words = "no kernel of " + text(lags) + " lags has this autocorrelation (" + effort_.reason;
    if (least < 0) words += "; its spectrum falls to " + number(least) + " of its maximum";
    const bool more = !problem_.request.target.known && !problem_.of_no_surface;
    return words + ")" + (more ? ": take more, such as " + text({2 * lags.nx, 2 * lags.ny}) : "");
  }

  std::string closest() const {
    if (!best_) return "; nothing close to it was found";
    return "; the closest one found changes it by " + number(best_->report.residual) +
           " of the variance, more than " + number(bound()) + " (see `infeasible`, `acf-tolerance`" +
           (problem_.request.target.known ? "; that of a tapered field is always met)" : ")");
  }

  void complete(KernelReport& report) const {
    const bool exact = report.answer == Answer::exact;
    if (!exact) report.change = report.residual;
    static_cast<IterationResult&>(report) = effort_;
    if (exact)
      report.reason = "solved";
    else if (report.answer != Answer::spectral)
      report.reason = excuse();
    judge(report, problem_.request);
    report.feasibility = problem_.feasibility.least;
  }

  KernelProblem problem_;
  std::optional<Kernel> best_;
  IterationResult effort_;              // of all attempts; the reason is that of the last which had one
  std::optional<std::string> widened_;  // once there was a wider kernel: why none is wider still
};

double unknowns(Shape lags) { return static_cast<double>(lags.nx) * static_cast<double>(lags.ny); }

std::string too_many(Shape lags) {
  return text(lags) + ": more than " + std::to_string(static_cast<long>(most_unknowns)) + " in all";
}

// ---- the choice of lags ----

Shape more(Shape lags) {
  auto grown = [](Index n) { return static_cast<Index>(std::ceil(growth * static_cast<double>(n))); };
  return {grown(lags.nx), grown(lags.ny)};
}

void refuse_too_many(const KernelRequest& request, Shape lags) {
  if (unknowns(lags) > most_unknowns)
    throw ParameterError("acf-tolerance", number(request.acf_tolerance) + ": needs lags of " +
                                              too_many(lags) + "; prescribe fewer lags");
}

// Whether the spectrum of a target is negative however many lags it is taken from.
bool belongs_to_no_surface(const KernelRequest& request) {
  if (request.formulation == Formulation::patir) return false;
  auto least = [&](double fallen) {
    const Shape lags = request.target.reach(fallen);
    if (unknowns(lags) > most_unknowns) return 0.0;
    return ZeroPhaseEquations(request.target, lags, request.target.oriented).feasibility().least;
  };
  const double near = least(nearer);
  return near < 0 && least(farther) < still_negative * near;
}

Kernel solve_at(const KernelRequest& request, Shape lags, bool of_no_surface = false) {
  return KernelSolver(request, lags, of_no_surface).finish();
}

// Such a target has no kernel, and more lags are no remedy: the nearest one is sought where it has fallen to
// the tolerance.
Kernel solve_at_fallen(const KernelRequest& request) {
  const Shape lags = request.target.reach(std::min(request.acf_tolerance, 0.5));
  refuse_too_many(request, lags);
  return solve_at(request, lags, true);
}

// More and more lags until the error over all of them is small enough. What can be had is answered by the
// last of them.
Kernel solve_at_open_lags(const KernelRequest& request) {
  Shape lags = first_lags(request);
  for (int trial = 1;; ++trial, lags = more(lags)) {
    refuse_too_many(request, lags);
    KernelSolver search(request, lags);
    if (trial == 1 && !search.solved() && request.method == Method::newton_krylov &&
        belongs_to_no_surface(request))
      return solve_at_fallen(request);
    const bool enough = search.solved() && search.best().report.error <= request.acf_tolerance;
    const bool hopeful = request.formulation != Formulation::patir &&
                         (search.solved() || request.method == Method::newton_krylov);
    const bool last = trial == most_trials || unknowns(more(lags)) > most_unknowns ||
                      kernel_cost(more(lags)).memory > request.memory;
    if (enough || !hopeful || last) return search.finish();
  }
}

std::string megabytes(double bytes) {
  return (bytes < 1e7 ? number(bytes / 1e6) : std::to_string(std::llround(bytes / 1e6))) + "MB";
}

void scale(Kernel& kernel, double rms) {
  kernel.rms = rms;
  kernel.values *= rms;
  kernel.acf_target *= rms * rms;
  kernel.acf_achieved *= rms * rms;
}

}  // namespace

Shape first_lags(const KernelRequest& request) {
  if (request.lags != Shape{}) return request.lags;
  if (request.target.known) return *request.target.known;
  if (!request.target.reach)
    throw ParameterError("lags", "are required: the reach of this target is not known");
  return request.target.reach(std::min(cut_over_error * request.acf_tolerance, 0.5));
}

KernelCost kernel_cost(Shape lags) { return {1500 * unknowns(lags), 160 * unknowns(lags)}; }
KernelCost wider_kernel_cost(Shape lags, Index torus) {
  const double points = static_cast<double>(torus * torus) * unknowns(lags);
  return {250 * points, 40 * points};
}

KernelCost periodic_kernel_cost(Shape torus) { return {150 * unknowns(torus), 16 * unknowns(torus)}; }

KernelCost root_cost(Shape torus) { return {20 * unknowns(torus), 0}; }

void check_memory(KernelCost cost, double memory, Shape torus) {
  if (cost.memory > memory)
    throw ParameterError("memory", megabytes(memory) + ": the spectrum on a torus of " + text(torus) +
                                       " points takes some " + megabytes(cost.memory));
}

void check_memory(const KernelRequest& request, Shape lags, KernelCost cost) {
  if (cost.memory <= request.memory) return;
  throw ParameterError("memory", megabytes(request.memory) + ": a kernel of " + text(lags) +
                                     " lags needs some " + megabytes(cost.memory) +
                                     "; shorter lengths, wider samples, fewer lags or a "
                                     "larger `acf-tolerance` need less");
}

bool allows(InfeasiblePolicy policy, double change) {
  if (policy == InfeasiblePolicy::automatic) return change <= largest_change;
  return policy != InfeasiblePolicy::error || change == 0;
}

void check_rms(double rms) {
  check_parameter(rms >= 1e-100 && rms <= 1e100, "rq", number(rms) + ": must lie in 1e-100 ... 1e100");
}

void KernelRequest::check() const {
  check_parameter(lags == Shape{} || (lags.nx >= 1 && lags.ny >= 1), "lags", text(lags) + ": at least 1x1");
  check_parameter(unknowns(lags) <= most_unknowns, "lags", too_many(lags));
  check_rms(rms);
  check_parameter(tolerance >= 1e-13 && tolerance <= 1e-2, "tolerance",
                  number(tolerance) + " does not lie in 1e-13 ... 1e-2");
  check_parameter(acf_tolerance >= 1e-8 && acf_tolerance <= 0.5, "acf-tolerance",
                  number(acf_tolerance) + " does not lie in 1e-8 ... 0.5");
  check_parameter(static_cast<bool>(target), "target", "there is none");
  check_parameter(std::abs(target(0, 0) - 1) <= 1e-12, "target",
                  number(target(0, 0)) + " at lag (0,0): must be 1");
  const Shape known = target.known.value_or(lags);
  check_parameter(lags.nx <= known.nx && lags.ny <= known.ny, "lags",
                  text(lags) + ": the table of the autocorrelation has " + text(known));
  check_parameter(formulation != Formulation::symmetric || !target.oriented, "formulation",
                  "symmetric: R(p,-q) differs from R(p,q): choose oriented");
}

Kernel solve_kernel(const KernelRequest& request) {
  request.check();
  const Stopwatch watch;
  Kernel kernel;
  if (request.lags == Shape{} && !request.target.known)
    kernel = solve_at_open_lags(request);
  else  // of a table at open lags, all
    kernel = solve_at(request, request.lags == Shape{} ? *request.target.known : request.lags);
  scale(kernel, request.rms);
  kernel.report.seconds = watch.seconds();
  return kernel;
}

}  // namespace asperity
