#include "acf/kernel_problem.hpp"

#include <algorithm>
#include <cmath>

#include "acf/kernel_cost.hpp"
#include "acf/kernel_evaluation.hpp"
#include "acf/solver_constants.hpp"
#include "acf/wording.hpp"

namespace asperity {

KernelProblem::KernelProblem(const KernelRequest& request, Shape lags, bool of_no_surface)
    : request_(request),
      lags_(lags),
      of_no_surface_(of_no_surface),
      formulation_(request.formulation.value_or(request.target.oriented ? Formulation::oriented
                                                                        : Formulation::symmetric)) {
  check_memory(request, lags, kernel_cost(lags));
  auto equations = std::make_unique<ZeroPhaseEquations>(request.target, lags, oriented());
  const std::vector<double>& target = equations->target();
  if (!std::ranges::all_of(target, [](double r) { return std::isfinite(r); }))
    refuse("the autocorrelation is not finite at one of the " + text(lags) + " lags");
  exceeds_variance_ = std::ranges::any_of(target, [](double r) { return std::abs(r) > 1 + 1e-12; });
  feasibility_ = equations->feasibility();
  if (zero_phase())
    equations_ = std::move(equations);
  else
    equations_ = std::make_unique<PatirEquations>(request.target, lags);
}

bool KernelProblem::recognised() const {
  return zero_phase() && (of_no_surface_ || exceeds_variance_ || feasibility_.windowed < -solver::round_off ||
                          feasibility_.negative_share > solver::hopeless_share);
}

bool KernelProblem::smooth() const {
  return zero_phase() && std::abs(feasibility_.least) < solver::smooth_spectrum;
}

double KernelProblem::enough() const {
  const bool whole_table = request_.lags == Shape{} && request_.target.known;
  return whole_table ? std::max(request_.tolerance, request_.acf_tolerance) : request_.tolerance;
}

std::optional<Kernel> KernelProblem::evaluate(const Field& values, Answer answer) const {
  auto kernel = evaluate_kernel(request_.target, lags_, formulation_, values);
  if (kernel && !solved_by(*kernel))
    kernel = evaluate_kernel(request_.target, lags_, formulation_,
                             kernel->values / std::sqrt(kernel->values.square().sum()));
  if (kernel) kernel->report.answer = answer;
  return kernel;
}

bool KernelProblem::better(const Kernel& a, const Kernel& b) const {
  const bool everywhere = zero_phase() && !request_.target.known;
  const auto measured = everywhere ? &KernelReport::error : &KernelReport::residual;
  return a.report.*measured < b.report.*measured;
}

IterationObserver KernelProblem::observer(std::string_view iteration) const {
  if (!request_.progress) return {};
  return [this, iteration](const IterationStep& step) { request_.progress({step, lags_, iteration}); };
}

void KernelProblem::refuse(const std::string& message) const {
  if (request_.target.known) throw DataError("acf", message);
  throw ParameterError("lags", message);
}

}  // namespace asperity
