#include "acf/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "acf/equations.hpp"
#include "acf/kernel_cost.hpp"
#include "acf/search.hpp"
#include "acf/wording.hpp"
#include "core/stopwatch.hpp"

namespace asperity {
namespace {

// Unknowns for which 40 vectors still fit into the memory of a workstation.
constexpr double most_unknowns = 1 << 24;

// The words of an enumeration, in the order of its values.
constexpr std::array formulations{"symmetric", "oriented", "patir"};
constexpr std::array methods{"newton-krylov", "fixed-point", "conjugate-gradient", "spectral"};
constexpr std::array answers_to_infeasible{"auto", "error", "nearest", "least-squares"};

template <std::size_t n, class Choice>
std::string_view text_of(const std::array<const char*, n>& words, Choice choice) {
  return words[static_cast<std::size_t>(choice)];
}

// The value that `name` stands for, as the result's type.
template <std::size_t n>
struct Named {
  const std::array<const char*, n>& words;
  const char* option;
  std::string_view name;

  template <class Choice>
  operator Choice() const {
    std::string all;
    for (std::size_t i = 0; i < n; ++i) {
      if (name == words[i]) return static_cast<Choice>(i);
      all += (i == 0 ? "" : i + 1 == n ? " and " : ", ") + std::string(words[i]);
    }
    throw ParameterError(option, "'" + std::string(name) + "' is none of " + all);
  }
};

template <std::size_t n>
Named<n> named(const std::array<const char*, n>& words, const char* option, std::string_view name) {
  return {words, option, name};
}

double unknowns(Shape lags) { return static_cast<double>(lags.nx) * static_cast<double>(lags.ny); }

std::string too_many(Shape lags) {
  return text(lags) + ": more than " + std::to_string(static_cast<long>(most_unknowns)) + " in all";
}

// ---- the choice of lags ----

constexpr double growth = 1.2;
constexpr int most_trials = 10;

Shape more(Shape lags) {
  auto grown = [](Index n) { return static_cast<Index>(std::ceil(growth * static_cast<double>(n))); };
  return {grown(lags.nx), grown(lags.ny)};
}

void refuse_too_many(const KernelRequest& request, Shape lags) {
  if (unknowns(lags) > most_unknowns)
    throw ParameterError("acf-tolerance", number(request.acf_tolerance) + ": would take lags of " +
                                              too_many(lags) + "; --lags takes fewer");
}

// Whether the spectrum of a target is negative however many lags it is taken from: at those where it has fallen to 1e-6
// it still is by half of what it was at 1e-4, while of a cut alone less than a tenth would be left.
bool belongs_to_no_surface(const KernelRequest& request) {
  if (request.formulation == Formulation::patir) return false;
  auto least = [&](double fallen) {
    const Shape lags = request.target.reach(fallen);
    if (unknowns(lags) > most_unknowns) return 0.0;
    return ZeroPhaseEquations(request.target, lags, request.target.oriented).feasibility().least;
  };
  const double near = least(1e-4);
  return near < 0 && least(1e-6) < near / 2;
}

// Such a target has no kernel, and more lags are no remedy: the nearest one is sought where it has fallen to the
// tolerance.
Kernel solve_at_fallen(const KernelRequest& request) {
  const Shape lags = request.target.reach(std::min(request.acf_tolerance, 0.5));
  refuse_too_many(request, lags);
  Search search(request, lags);
  search.clip();
  return search.finish();
}

Kernel solve_at(const KernelRequest& request, Shape lags) {
  Search search(request, lags);
  search.run();
  return search.finish();
}

// More and more lags until the error over all of them is small enough. What can be had is answered by the
// last of them.
Kernel solve_at_open_lags(const KernelRequest& request) {
  Shape lags = first_lags(request);
  for (int trial = 1;; ++trial, lags = more(lags)) {
    refuse_too_many(request, lags);
    Search search(request, lags);
    search.run();
    if (trial == 1 && !search.solved() && request.method == Method::newton_krylov &&
        belongs_to_no_surface(request))
      return solve_at_fallen(request);
    const bool enough = search.solved() && search.best().report.error <= request.acf_tolerance;
    const bool hopeful = search.formulation() != Formulation::patir &&
                         (search.solved() || request.method == Method::newton_krylov);
    const bool last = trial == most_trials || unknowns(more(lags)) > most_unknowns ||
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

bool allows(Infeasible answer, double change) {
  if (answer == Infeasible::automatic) return change <= Search::largest_change;
  return answer != Infeasible::error || change == 0;
}

std::string_view name_of(Formulation formulation) { return text_of(formulations, formulation); }
std::string_view name_of(Method method) { return text_of(methods, method); }
std::string_view name_of(Infeasible infeasible) { return text_of(answers_to_infeasible, infeasible); }

Formulation formulation_named(std::string_view name) { return named(formulations, "formulation", name); }
Method method_named(std::string_view name) { return named(methods, "method", name); }
Infeasible infeasible_named(std::string_view name) {
  return named(answers_to_infeasible, "infeasible", name);
}

void check_rms(double rms) {
  if (!(rms >= 1e-100 && rms <= 1e100))
    throw ParameterError("rq", number(rms) + ": must lie in 1e-100 ... 1e100");
}

void KernelRequest::check() const {
  const bool open = lags == Shape{};
  if (!open && (lags.nx < 1 || lags.ny < 1)) throw ParameterError("lags", text(lags) + ": at least 1x1");
  if (unknowns(lags) > most_unknowns) throw ParameterError("lags", too_many(lags));
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

Field autocorrelation(const Field& kernel, Index rows, Index columns) {
  const Shape torus{fast_length(2 * kernel.rows() - 1), fast_length(2 * kernel.cols() - 1, 2)};
  const RealTransform2D transform(torus);
  AlignedVector<double> field(static_cast<std::size_t>(torus.cells()));
  AlignedVector<Complex> spectrum(static_cast<std::size_t>(transform.spectrum_size()));
  Eigen::Map<Field> plane(field.data(), torus.nx, torus.ny);
  plane.topLeftCorner(kernel.rows(), kernel.cols()) = kernel;
  transform.forward(field.data(), spectrum.data());
  for (Complex& a : spectrum) a = std::norm(a);
  transform.inverse(spectrum.data(), field.data());
  return Field::NullaryExpr(rows, columns,
                            [&, cells = static_cast<double>(torus.cells())](Index p, Index column) {
                              const Index q = column - columns / 2;
                              if (p >= kernel.rows() || std::abs(q) >= kernel.cols()) return 0.0;
                              return plane(p, q < 0 ? q + torus.ny : q) / cells;
                            });
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
