#include "acf/search.hpp"

#include <algorithm>
#include <cmath>

#include "acf/appraisal.hpp"
#include "acf/conjugate_gradient.hpp"
#include "acf/fixed_point.hpp"
#include "acf/kernel_cost.hpp"
#include "acf/least_change.hpp"
#include "acf/least_squares.hpp"
#include "acf/newton_krylov.hpp"
#include "acf/projections.hpp"
#include "acf/wording.hpp"

namespace asperity {
namespace {

constexpr double hopeless_share = 0.1;  // of the spectrum, negative
constexpr double round_off = 1e-10;     // of the windowed spectrum
constexpr double negligible_change = 1e-6;
// A spectrum this close to zero, of its maximum, is that of a smooth target: Newton's matrix is singular there, the
// root of the spectrum on a wider torus nearly exact. Somewhat below zero the latter is worth trying at once.
constexpr double smooth_spectrum = 1e-12, nearly_smooth = -1e-4;

// Products that find a kernel whose spectrum changes sign, if there is one: a second at any size.
long modest_budget(Index unknowns) { return std::clamp<long>(4'000'000 / unknowns, 100, 3000); }
// Products of least squares that were asked for.
long large_budget(Index unknowns) { return std::clamp<long>(100'000'000 / unknowns, 500, 20000); }

// The torus of projections, over the lags, and its most points: a step then takes a second.
constexpr Index least_torus = 4;
constexpr double most_points = 1 << 24;
Index wider(Index torus) { return torus * 3 / 2; }

// Half the tolerance inside, so that the residual recomputed by other sums stays below the whole.
NewtonOptions options_for(const KernelRequest& request, Formulation formulation, Index unknowns) {
  NewtonOptions options;
  options.tolerance = request.tolerance / 2;
  if (formulation == Formulation::patir) {
    options.krylov_dimension = 60;
    options.restarts = 1;
    options.forcing = 1e-2;
  }
  // Small systems spend more on the room for directions than on the few that they need.
  options.krylov_dimension = static_cast<int>(std::clamp<Index>(unknowns / 4, 10, options.krylov_dimension));
  return options;
}

// A system whose solver does not tell its steps: each begins with a linearisation.
class Watched {
 public:
  Watched(IterationObserver told, int most_steps) : told_(std::move(told)), most_steps_(most_steps) {}

  NonlinearSystem system(NonlinearSystem system) {
    if (!told_) return system;
    system.residual = [this, evaluate = system.residual](auto u, auto f) {
      const bool inside = evaluate(u, f);
      now_.residual = 0;
      for (double value : f) now_.residual = std::max(now_.residual, std::abs(value));
      return inside;
    };
    system.jacobian = [this, multiply = system.jacobian](auto v, auto out) {
      ++now_.products;
      multiply(v, out);
    };
    system.linearize = [this, prepare = system.linearize](auto u) {
      told_(now_);
      now_.spent = static_cast<double>(++now_.step) / most_steps_;
      prepare(u);
    };
    return system;
  }

  // Where the last step has come to.
  void end() const {
    if (told_ && now_.step > 0) told_(now_);
  }

 private:
  IterationObserver told_;
  int most_steps_;
  IterationStep now_;
};

}  // namespace

Search::Search(const KernelRequest& request, Shape lags)
    : request_(request),
      lags_(lags),
      formulation_(request.formulation.value_or(request.target.oriented ? Formulation::oriented
                                                                        : Formulation::symmetric)) {
  check_memory(request, lags, kernel_cost(lags));
  auto zero_phase = std::make_unique<ZeroPhaseEquations>(request.target, lags, oriented());
  for (double r : zero_phase->target()) {
    if (!std::isfinite(r)) refuse("the autocorrelation is not finite at one of the " + text(lags) + " lags");
    exceeds_variance_ = exceeds_variance_ || std::abs(r) > 1 + 1e-12;
  }
  feasibility_ = zero_phase->feasibility();
  if (formulation_ == Formulation::patir) {
    equations_ = std::make_unique<PatirEquations>(request.target, lags);
  } else {
    zero_phase_ = zero_phase.get();
    equations_ = std::move(zero_phase);
  }
}

void Search::take_root(std::string answer) {
  check_memory(request_, lags_, wider_kernel_cost(lags_));
  consider(nearest_kernel(request_.target, lags_, oriented(), {.max_iterations = 0}).values,
           std::move(answer));
}

void Search::clip() {
  infeasible_ = hopeless_ = true;
  reason_ = "its spectrum is negative whatever the lags";
  take_root("nearest");
}

void Search::run() {
  if (spectral()) {
    reason_ = "the root of the spectrum";
    return take_root("spectral");
  }
  if (request_.method == Method::newton_krylov) return newton();
  if (zero_phase_) zero_phase_->guard = false;
  std::vector<double> u = equations_->start();
  if (request_.method == Method::fixed_point)
    fixed_point(u);
  else
    count(solve_conjugate_gradient(
        *equations_, u, {.tolerance = request_.tolerance / 2, .told = observer("conjugate gradients")}));
  consider(u);
}

void Search::fixed_point(std::vector<double>& u) {
  const FixedPointOptions options{.tolerance = request_.tolerance / 2};
  Watched watched(observer("fixed point"), options.max_iterations);
  count(solve_fixed_point(watched.system(equations_->system()), u, options));
  watched.end();
}

void Search::newton() {
  infeasible_ = true;
  std::vector<double> u = equations_->start();
  if (recognised()) {
    reason_ = "recognised before any iteration";
    return;
  }
  const bool smooth = zero_phase_ && std::abs(feasibility_.least) < smooth_spectrum;
  if (smooth && wide_enough()) return;
  const NewtonOptions options = options_for(request_, formulation_, equations_->count());
  Watched watched(observer("Newton-Krylov"), options.max_steps);
  const Report result = solve_newton_krylov(watched.system(equations_->system()), u, options);
  watched.end();
  count(result);
  if (result.converged) consider(u);
  infeasible_ = !solved();
  const bool no_start = result.steps == 0 && !result.converged;
  if (no_start) reason_ = "its windowed root is no start";
  if (infeasible_ && zero_phase_ && !smooth && (no_start || feasibility_.least > nearly_smooth))
    wide_enough();
}

// Passes on, with its name, what an iteration tells.
IterationObserver Search::observer(std::string_view iteration) const {
  if (!request_.progress) return {};
  return [this, iteration](const IterationStep& step) { request_.progress({step, lags_, iteration}); };
}

// Whether a wider kernel solves the equations, where one may be the answer.
bool Search::wide_enough() {
  if (request_.infeasible != Infeasible::error && request_.infeasible != Infeasible::least_squares) widen();
  return best_ && solved();
}

bool Search::recognised() const {
  return zero_phase_ && (hopeless_ || exceeds_variance_ || feasibility_.windowed < -round_off ||
                         feasibility_.negative_share > hopeless_share);
}

// ---- candidates ----

void Search::count(const Report& result) {
  counts_.newton_steps += result.steps;
  counts_.equation_seconds += result.system_seconds;
  counts_.residuals += result.residuals;
  counts_.jacobian_products += result.jacobian_products;
  counts_.preconditionings += result.preconditionings;
  reason_ = result.reason;
}

void Search::consider(const std::vector<double>& u) { consider(equations_->kernel(u), "exact"); }

// With the variance set right when it is no solution.
void Search::consider(const Field& values, std::string answer) {
  auto candidate = appraise(request_.target, lags_, formulation_, values);
  if (candidate && !(candidate->report.residual <= request_.tolerance))
    candidate = appraise(request_.target, lags_, formulation_,
                         candidate->values / std::sqrt(candidate->values.square().sum()));
  if (!candidate || !better(*candidate)) return;
  candidate->report.answer = std::move(answer);
  best_ = std::move(candidate);
}

bool Search::better(const Kernel& candidate) const {
  const bool everywhere = zero_phase_ && !request_.target.known;
  const auto measured = everywhere ? &KernelReport::error : &KernelReport::residual;
  return !best_ || candidate.report.*measured < best_->report.*measured;
}

// ---- what has no kernel of positive spectrum ----

void Search::answer() {
  descend(recognised() ? 0 : modest_budget(equations_->count()));
  if (solved()) {
    infeasible_ = false;
    return;
  }
  switch (request_.infeasible) {
    case Infeasible::error:
      return refuse(excuse());
    case Infeasible::least_squares:
      return descend(large_budget(equations_->count()));
    case Infeasible::nearest:
      return zero_phase_ ? widen() : descend(large_budget(equations_->count()));
    case Infeasible::automatic:
      if (!zero_phase_)
        descend(large_budget(equations_->count()));
      else if (!best_ || !(best_->report.residual <= negligible_change))
        widen();
      if (!best_ || !(best_->report.residual <= bound())) refuse(excuse() + closest());
  }
}

// By least squares; from the present best where there is one.
void Search::descend(long budget) {
  if (budget == 0) return;
  if (zero_phase_) zero_phase_->guard = false;
  if (descent_.empty()) descent_ = equations_->start();
  const std::string reason = reason_;
  count(minimise_squares(*equations_, descent_, {.max_products = budget, .told = observer("least squares")}));
  reason_ = reason;
  consider(equations_->kernel(descent_), "least-squares");
  if (best_ && solved()) best_->report.answer = "exact";
}

// By a kernel of twice the lags; of more where these are a table that is met within what is tolerated, and the kernel has
// lost too much beyond its ends. Where equations are to be met exactly, the least change makes up for that.
void Search::widen() {
  if (hopeless_) return;
  check_memory(request_, lags_, wider_kernel_cost(lags_));
  Index torus = least_torus;
  for (double change = widen(torus); best_ && lost_more_than(change); change = widen(torus)) {
    torus = wider(torus);
    const std::string limit = beyond_limits(torus);
    if (limit.empty()) continue;
    reason_ = limit;
    break;
  }
  if (best_ && best_->report.answer == "nearest" && solved()) best_->report.answer = "wider";
  trim();
}

// Why no torus of this size is tried, or nothing.
std::string Search::beyond_limits(Index torus) const {
  const double memory = wider_kernel_cost(lags_, torus).memory;
  if (memory > request_.memory)
    return "a kernel wide enough takes some " + number(memory / 1e6) + "MB, more than --memory";
  if (static_cast<double>(torus * torus) * static_cast<double>(lags_.cells()) > most_points)
    return "a kernel wide enough takes more than 2^24 points";
  return {};
}

// Whether the ends of the kernel, and not the target, keep it from what is asked for.
bool Search::lost_more_than(double change) const {
  return enough() > request_.tolerance && best_->report.residual > enough() &&
         best_->report.residual > 2 * change;
}

// Returns what the torus itself leaves of the change.
double Search::widen(Index torus) {
  const double goal = enough() / 2;
  const NearestKernel nearest =
      nearest_kernel(request_.target, lags_, oriented(),
                     {.tolerance = goal, .torus = torus, .told = observer("projections")});
  if (enough() > request_.tolerance)
    consider(nearest.values, "nearest");
  else
    consider(with_least_change(nearest.values, request_.target, lags_, oriented(),
                               {.tolerance = goal, .told = observer("least change")}),
             "nearest");
  return nearest.change;
}

// Of a change to the lags prescribed: of a table at open lags, what is tolerated over all of it.
double Search::enough() const {
  return request_.lags == Shape{} && request_.target.known
             ? std::max(request_.tolerance, request_.acf_tolerance)
             : request_.tolerance;
}

// What is not needed of the ends of a kernel that is near enough without them: a fifth of its length at a time.
void Search::trim() {
  auto shorter = [](Index n, Index least) { return std::max(least, n * 4 / 10) * 2 + 1; };
  while (best_ && best_->report.residual > request_.tolerance && best_->report.residual <= enough()) {
    const Field& whole = best_->values;
    const Index rows = std::min(whole.rows(), shorter(whole.rows(), lags_.nx)),
                columns = std::min(whole.cols(), shorter(whole.cols(), lags_.ny));
    if (rows == whole.rows() && columns == whole.cols()) return;
    const Field middle = whole.block((whole.rows() - rows) / 2, (whole.cols() - columns) / 2, rows, columns);
    auto trimmed = appraise(request_.target, lags_, formulation_, middle / std::sqrt(middle.square().sum()));
    if (!trimmed || trimmed->report.residual > enough()) return;
    trimmed->report.answer = best_->report.answer;
    best_ = std::move(trimmed);
  }
}

std::string Search::closest() const {
  if (!best_) return "; nothing close to it was found";
  return "; the closest one found changes it by " + number(best_->report.residual) +
         " of the variance, more than " + number(bound()) + " (see --infeasible, --acf-tolerance" +
         (request_.target.known ? "; asperity-acf --biased estimates one that a surface has)" : ")");
}

std::string Search::excuse() const {
  const Shape twice{2 * lags_.nx, 2 * lags_.ny};
  std::string words = "no kernel of " + text(lags_) + " lags has this autocorrelation (" + reason_;
  if (feasibility_.least < 0)
    words += "; its spectrum falls to " + number(feasibility_.least) + " of its maximum";
  return words + ")" + (request_.target.known || hopeless_ ? "" : ": take more, such as " + text(twice));
}

double Search::bound() const { return std::max(largest_change, request_.acf_tolerance); }

void Search::refuse(const std::string& message) const {
  if (request_.target.known) throw DataError("acf", message);
  throw ParameterError("lags", message);
}

Kernel Search::finish() {
  if (infeasible_ && !(best_ && solved())) answer();
  if (!best_) refuse("no finite kernel was found (" + reason_ + ")");
  Kernel kernel = std::move(best_).value();
  KernelReport& report = kernel.report;
  if (!(infeasible_ || spectral() || report.residual <= request_.tolerance)) report.answer = "best";
  if (report.answer != "exact") report.change = report.residual;
  report.reason = report.answer == "exact" ? "solved" : infeasible_ ? excuse() : reason_;
  judge(report, request_);
  report.feasibility = feasibility_.least;
  report.newton_steps = counts_.newton_steps;
  report.equation_seconds = counts_.equation_seconds;
  report.residuals = counts_.residuals;
  report.jacobian_products = counts_.jacobian_products;
  report.preconditionings = counts_.preconditionings;
  return kernel;
}

}  // namespace asperity
