#include "acf/kernel.hpp"

#include <algorithm>
#include <cmath>

#include "acf/equations.hpp"
#include "acf/kernel_cost.hpp"
#include "acf/kernel_solver.hpp"
#include "acf/wording.hpp"
#include "core/calibration.hpp"
#include "core/enum_words.hpp"
#include "core/stopwatch.hpp"

namespace asperity {
namespace {

namespace solver = calibration::acf;

constexpr EnumWords<3> formulations{"symmetric", "oriented", "patir"};
constexpr EnumWords<4> methods{"newton-krylov", "fixed-point", "conjugate-gradient", "spectral"};
constexpr EnumWords<4> policies{"auto", "error", "nearest", "least-squares"};
constexpr EnumWords<6> answers{"exact", "wider", "nearest", "least-squares", "spectral", "best"};

double unknowns(Shape lags) { return static_cast<double>(lags.nx) * static_cast<double>(lags.ny); }

std::string too_many(Shape lags) {
  return text(lags) + ": more than " + std::to_string(static_cast<long>(solver::most_unknowns)) + " in all";
}

// ---- the choice of lags ----

Shape more(Shape lags) {
  auto grown = [](Index n) { return static_cast<Index>(std::ceil(solver::growth * static_cast<double>(n))); };
  return {grown(lags.nx), grown(lags.ny)};
}

void refuse_too_many(const KernelRequest& request, Shape lags) {
  if (unknowns(lags) > solver::most_unknowns)
    throw ParameterError("acf-tolerance", number(request.acf_tolerance) + ": would take lags of " +
                                              too_many(lags) + "; lags may ask for fewer");
}

// Whether the spectrum of a target is negative however many lags it is taken from.
bool belongs_to_no_surface(const KernelRequest& request) {
  if (request.formulation == Formulation::patir) return false;
  auto least = [&](double fallen) {
    const Shape lags = request.target.reach(fallen);
    if (unknowns(lags) > solver::most_unknowns) return 0.0;
    return ZeroPhaseEquations(request.target, lags, request.target.oriented).feasibility().least;
  };
  const double near = least(solver::near);
  return near < 0 && least(solver::far) < solver::still_negative * near;
}

Kernel solve_at(const KernelRequest& request, Shape lags, bool of_no_surface = false) {
  KernelSolver solver(request, lags, of_no_surface);
  solver.run();
  return solver.finish();
}

// Such a target has no kernel, and more lags are no remedy: the nearest one is sought where it has fallen to the
// tolerance.
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
    search.run();
    if (trial == 1 && !search.solved() && request.method == Method::newton_krylov &&
        belongs_to_no_surface(request))
      return solve_at_fallen(request);
    const bool enough = search.solved() && search.best().report.error <= request.acf_tolerance;
    const bool hopeful = request.formulation != Formulation::patir &&
                         (search.solved() || request.method == Method::newton_krylov);
    const bool last = trial == solver::most_trials || unknowns(more(lags)) > solver::most_unknowns ||
                      kernel_cost(more(lags)).memory > request.memory;
    if (enough || !hopeful || last) return search.finish();
  }
}

void scale(Kernel& kernel, double rms) {
  kernel.rms = rms;
  kernel.values *= rms;
  kernel.acf_target *= rms * rms;
  kernel.acf_achieved *= rms * rms;
}

}  // namespace

bool allows(InfeasiblePolicy policy, double change) {
  if (policy == InfeasiblePolicy::automatic) return change <= solver::largest_change;
  return policy != InfeasiblePolicy::error || change == 0;
}

std::string_view name_of(Formulation formulation) { return word_of(formulations, formulation); }
std::string_view name_of(Method method) { return word_of(methods, method); }
std::string_view name_of(InfeasiblePolicy policy) { return word_of(policies, policy); }
std::string_view name_of(Answer answer) { return word_of(answers, answer); }

Formulation formulation_named(std::string_view name) {
  return enum_named<Formulation>(formulations, name, "formulation");
}
Method method_named(std::string_view name) { return enum_named<Method>(methods, name, "method"); }
InfeasiblePolicy infeasible_named(std::string_view name) {
  return enum_named<InfeasiblePolicy>(policies, name, "infeasible");
}

void check_rms(double rms) {
  if (!(rms >= 1e-100 && rms <= 1e100))
    throw ParameterError("rq", number(rms) + ": must lie in 1e-100 ... 1e100");
}

void KernelRequest::check() const {
  const bool open = lags == Shape{};
  if (!open && (lags.nx < 1 || lags.ny < 1)) throw ParameterError("lags", text(lags) + ": at least 1x1");
  if (unknowns(lags) > solver::most_unknowns) throw ParameterError("lags", too_many(lags));
  check_rms(rms);
  if (!(tolerance >= 1e-13 && tolerance <= 1e-2))
    throw ParameterError("tolerance", number(tolerance) + " does not lie in 1e-13 ... 1e-2");
  if (!(acf_tolerance >= 1e-8 && acf_tolerance <= 0.5))
    throw ParameterError("acf-tolerance", number(acf_tolerance) + " does not lie in 1e-8 ... 0.5");
  if (!target) throw ParameterError("target", "there is none");
  if (!(std::abs(target(0, 0) - 1) <= 1e-12))
    throw ParameterError("target", number(target(0, 0)) + " at lag (0,0): must be 1");
  if (target.known && (lags.nx > target.known->nx || lags.ny > target.known->ny))
    throw ParameterError("lags",
                         text(lags) + ": the table of the autocorrelation has " + text(*target.known));
  if (formulation == Formulation::symmetric && target.oriented)
    throw ParameterError("formulation",
                         "symmetric: R(p,-q) differs from R(p,q), which takes the oriented one");
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
