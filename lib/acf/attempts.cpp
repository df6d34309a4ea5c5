#include "acf/attempts.hpp"

#include <algorithm>
#include <cmath>

#include "acf/kernel.hpp"
#include "acf/kernel_evaluation.hpp"
#include "acf/newton_krylov.hpp"
#include "acf/wider_kernel.hpp"
#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

// Of the spectrum of a cut target: the negative share above which no iteration is tried, the round-off of
// the windowed spectrum over its maximum, and the |least| over the maximum below which a target is smooth, so
// that Newton's matrix is singular and the spectral root nearly exact (validation/acf_error_time).
constexpr double hopeless_share = 0.1, round_off = 1e-10, smooth_spectrum = 1e-12;

// The torus of projections relative to the lags, its growth, and its largest size: one second per step.
constexpr Index least_widening = 4;
constexpr Index wider_still(Index torus) { return torus * 3 / 2; }
constexpr double most_torus_points = 1 << 24;

// Share of the tolerance, so that the residual recomputed by other sums stays below the whole.
constexpr double inside = 0.5;

NewtonOptions newton_options(const KernelProblem& problem) {
  NewtonOptions options;
  options.tolerance = inside * problem.request.tolerance;
  options.on_step = problem.observer("Newton-Krylov");
  if (!problem.zero_phase) {
    options.krylov_dimension = 60;
    options.restarts = 1;
    options.forcing = 1e-2;
  }
  // Small systems spend more on the room for directions than on the few that they need.
  options.krylov_dimension =
      static_cast<int>(std::clamp<Index>(problem.equations->count() / 4, 10, options.krylov_dimension));
  return options;
}

// Why no torus of this size is tried, or nothing.
std::string beyond_limits(const KernelProblem& problem, Index torus) {
  const double memory = wider_kernel_cost(problem.lags, torus).memory;
  if (memory > problem.request.memory)
    return "a wide enough kernel needs some " + number(memory / 1e6) + "MB, more than memory allows";
  const double points = static_cast<double>(torus * torus) * static_cast<double>(problem.lags.cells());
  return points > most_torus_points ? "a wide enough kernel needs more than 2^24 points" : "";
}

// The kernel that a torus leads to, and what the torus itself leaves of the change.
std::pair<std::optional<Kernel>, double> widen(const KernelProblem& problem, Index torus) {
  const KernelRequest& request = problem.request;
  const double goal = inside * problem.enough;
  const NearestKernel nearest =
      nearest_kernel(request.target, problem.lags, problem.oriented,
                     {.tolerance = goal, .torus = torus, .on_step = problem.observer("projections")});
  if (problem.enough > request.tolerance)
    return {problem.evaluate(nearest.values, Answer::nearest), nearest.change};
  const Field improved = minimum_norm_newton(nearest.values, request.target, problem.lags, problem.oriented,
                                             goal, problem.observer("least change"));
  return {problem.evaluate(improved, Answer::nearest), nearest.change};
}

// Without what is not needed of the ends of a kernel that is near enough: a fifth of its length at a time.
Kernel trimmed(const KernelProblem& problem, Kernel kernel) {
  auto shorter = [](Index n, Index least) { return std::max(least, n * 4 / 10) * 2 + 1; };
  while (!problem.solved_by(kernel) && kernel.report.residual <= problem.enough) {
    const Field& whole = kernel.values;
    const Index rows = std::min(whole.rows(), shorter(whole.rows(), problem.lags.nx)),
                columns = std::min(whole.cols(), shorter(whole.cols(), problem.lags.ny));
    if (rows == whole.rows() && columns == whole.cols()) break;
    const Field middle = whole.block((whole.rows() - rows) / 2, (whole.cols() - columns) / 2, rows, columns);
    auto next = evaluate_kernel(problem.request.target, problem.lags, problem.formulation,
                                middle / std::sqrt(middle.square().sum()));
    if (!next || next->report.residual > problem.enough) break;
    next->report.answer = kernel.report.answer;
    kernel = std::move(*next);
  }
  return kernel;
}

}  // namespace

// ---- the problem ----

KernelProblem::KernelProblem(const KernelRequest& asked, Shape at, bool belongs_to_no_surface)
    : request(asked),
      lags(at),
      of_no_surface(belongs_to_no_surface),
      formulation(
          asked.formulation.value_or(asked.target.oriented ? Formulation::oriented : Formulation::symmetric)),
      oriented(formulation == Formulation::oriented),
      zero_phase(formulation != Formulation::patir),
      enough(asked.lags == Shape{} && asked.target.known ? std::max(asked.tolerance, asked.acf_tolerance)
                                                         : asked.tolerance) {
  check_memory(request, lags, kernel_cost(lags));
  auto even = std::make_unique<ZeroPhaseEquations>(request.target, lags, oriented);
  const double largest = largest_absolute(even->target());
  if (!std::isfinite(largest))
    refuse("the autocorrelation is not finite at one of the " + text(lags) + " lags");
  feasibility = even->feasibility();
  recognised = zero_phase && (of_no_surface || largest > 1 + 1e-12 || feasibility.windowed < -round_off ||
                              feasibility.negative_share > hopeless_share);
  smooth = zero_phase && std::abs(feasibility.least) < smooth_spectrum;
  if (zero_phase)
    equations = std::move(even);
  else
    equations = std::make_unique<PatirEquations>(request.target, lags);
}

bool KernelProblem::better(const Kernel& a, const Kernel& b) const {
  const auto measured = zero_phase && !request.target.known ? &KernelReport::error : &KernelReport::residual;
  return a.report.*measured < b.report.*measured;
}

std::optional<Kernel> KernelProblem::evaluate(const Field& values, Answer answer) const {
  auto kernel = evaluate_kernel(request.target, lags, formulation, values);
  if (kernel && !solved_by(*kernel))
    kernel = evaluate_kernel(request.target, lags, formulation,
                             kernel->values / std::sqrt(kernel->values.square().sum()));
  if (kernel) kernel->report.answer = answer;
  return kernel;
}

IterationObserver KernelProblem::observer(std::string_view iteration) const {
  if (!request.progress) return {};
  return [this, iteration](const IterationStep& step) { request.progress({step, lags, iteration}); };
}

void KernelProblem::refuse(const std::string& message) const {
  if (request.target.known) throw DataError("acf", message);
  throw ParameterError("lags", message);
}

// ---- the attempts ----

Attempt spectral_root(const KernelProblem& problem) {
  check_memory(problem.request, problem.lags, wider_kernel_cost(problem.lags));
  const NearestKernel root =
      nearest_kernel(problem.request.target, problem.lags, problem.oriented, {.max_iterations = 0});
  Attempt out;
  out.candidate = problem.evaluate(root.values, problem.of_no_surface ? Answer::nearest : Answer::spectral);
  out.effort.reason =
      problem.of_no_surface ? "its spectrum is negative whatever the lags" : "the root of the spectrum";
  return out;
}

Attempt newton(const KernelProblem& problem) {
  Attempt out;
  if (problem.recognised) {
    out.effort.reason = "detected before any iteration";
    return out;
  }
  std::vector<double> u = problem.equations->start();
  out.effort = solve_newton_krylov(*problem.equations, u, newton_options(problem));
  if (out.effort.converged)
    out.candidate = problem.evaluate(problem.equations->kernel(u), Answer::exact);
  else if (out.effort.steps == 0)
    out.effort.reason = "its windowed root is not a valid start";
  return out;
}

Attempt wider_kernel(const KernelProblem& problem, const std::optional<Kernel>& best) {
  check_memory(problem.request, problem.lags, wider_kernel_cost(problem.lags));
  Attempt out;
  // Whether the ends of the kernel, and not the target, keep it from what is requested.
  auto lost_more_than = [&](double change) {
    const double none = std::numeric_limits<double>::infinity(),
                 residual = std::min(out.candidate ? out.candidate->report.residual : none,
                                     best ? best->report.residual : none);
    return problem.enough > problem.request.tolerance && std::isfinite(residual) &&
           residual > problem.enough && residual > 2 * change;
  };
  for (Index torus = least_widening; out.effort.reason.empty();) {
    auto [widened, change] = widen(problem, torus);
    if (widened && (!out.candidate || problem.better(*widened, *out.candidate)))
      out.candidate = std::move(widened);
    if (!lost_more_than(change)) break;
    torus = wider_still(torus);
    out.effort.reason = beyond_limits(problem, torus);
  }
  if (!out.candidate) return out;
  if (problem.solved_by(*out.candidate)) out.candidate->report.answer = Answer::wider;
  out.candidate = trimmed(problem, std::move(*out.candidate));
  return out;
}

}  // namespace asperity
