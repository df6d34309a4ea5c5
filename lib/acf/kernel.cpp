#include "acf/kernel.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "acf/equations.hpp"
#include "acf/newton_krylov.hpp"
#include "grid/stopwatch.hpp"

namespace asperity {
namespace {

// Unknowns for which 35 vectors still fit into the memory of a workstation.
constexpr Index most_unknowns = Index{1} << 24;

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

std::string text(Shape s) { return std::to_string(s.nx) + "x" + std::to_string(s.ny); }

std::string number(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

Field quadrant(const KernelRequest& request) {
  return Field::NullaryExpr(request.lags.nx, request.lags.ny, [&](Index p, Index q) {
    return request.target(static_cast<double>(p), static_cast<double>(q));
  });
}

// The target over the half plane, one lag beyond the end of every achievable autocorrelation.
Field half_plane(const KernelRequest& request) {
  const auto [n, m] = request.lags;
  return Field::NullaryExpr(2 * n, 4 * m - 1, [&, middle = 2 * m - 1](Index p, Index q) {
    return request.target(static_cast<double>(p), static_cast<double>(q - middle));
  });
}

// Largest error in four parts of the half plane.
void measure(const Kernel& kernel, KernelReport& report) {
  const Field error = (kernel.acf_achieved - kernel.acf_target).abs();
  const auto [n, m] = kernel.lags;
  const Index middle = -kernel.first_q();
  const bool both_sides = kernel.formulation == Formulation::symmetric;
  report.residual = error.block(0, middle, n, m).maxCoeff();
  report.mirrored_error = n > 1 && m > 1 ? error.block(1, middle - m + 1, n - 1, m - 1).maxCoeff() : 0.0;
  if (both_sides) report.residual = std::max(report.residual, report.mirrored_error);
  report.error = error.maxCoeff();
  report.tail = 0;
  for (Index p = 0; p < error.rows(); ++p)
    for (Index q = 0; q < error.cols(); ++q)
      if (p >= n || std::abs(q - middle) >= m) report.tail = std::max(report.tail, error(p, q));
}

// A kernel of unit variance with everything that can be said about it; none when a coefficient is not finite.
std::optional<Kernel> examine(const KernelRequest& request, const Field& target, Field values) {
  const double sum = values.square().sum();
  if (!std::isfinite(sum) || !(sum > 0)) return std::nullopt;
  if (values.sum() < 0) values = -values;
  Kernel kernel;
  kernel.formulation = request.formulation.value_or(Formulation::symmetric);
  kernel.lags = request.lags;
  kernel.values = std::move(values);
  kernel.acf_target = target;
  kernel.acf_achieved = autocorrelation(kernel.values, kernel.acf_target.rows(), kernel.acf_target.cols());
  measure(kernel, kernel.report);
  return kernel;
}

// The search for the best kernel: each attempt starts somewhere, and the best end is kept.
class Search {
 public:
  explicit Search(const KernelRequest& request) : request_(request), target_(half_plane(request)) {}

  // Takes the iterate u as a candidate, with the variance set right when it is no solution.
  template <class Equations>
  void consider(const Equations& equations, const std::vector<double>& u) {
    auto candidate = examine(request_, target_, equations.kernel(u));
    if (candidate && !(candidate->report.residual <= request_.tolerance))
      candidate = examine(request_, target_, candidate->values / std::sqrt(candidate->values.square().sum()));
    if (candidate && better(*candidate)) best_ = std::move(candidate);
  }

  template <class Equations>
  bool iterate(Equations& equations, std::vector<double> u, const NewtonOptions& options) {
    const NewtonResult result = solve_newton_krylov(equations.system(), u, options);
    counts_.newton_steps += result.steps;
    counts_.jacobian_products += result.jacobian_products;
    counts_.preconditionings += result.preconditionings;
    reason_ = result.reason;
    consider(equations, u);
    return solved();
  }

  // A solution before any other; else the least error over all lags, or over the equations in Patir's
  // formulation, which knows no other lags.
  bool better(const Kernel& candidate) const {
    const auto measured =
        request_.formulation != Formulation::patir ? &KernelReport::error : &KernelReport::residual;
    if (!best_ || candidate.report.residual <= request_.tolerance) return true;
    return candidate.report.*measured < best_->report.*measured;
  }
  bool solved() const { return best_ && best_->report.residual <= request_.tolerance; }

  Kernel finish(double feasibility) {
    Kernel kernel = std::move(best_).value();
    KernelReport& report = kernel.report;
    report.converged = report.residual <= request_.tolerance;
    report.reason = report.converged ? "solved" : excuse(feasibility);
    report.feasibility = feasibility;
    report.newton_steps = counts_.newton_steps;
    report.jacobian_products = counts_.jacobian_products;
    report.preconditionings = counts_.preconditionings;
    return kernel;
  }

 private:
  std::string excuse(double feasibility) const {
    const Shape more{2 * request_.lags.nx, 2 * request_.lags.ny};
    std::string words = "no kernel found for the target cut at " + text(request_.lags) + " lags (" + reason_;
    if (feasibility < 0) words += "; its spectrum falls to " + number(feasibility) + " of its maximum";
    return words + "): take more lags, such as " + text(more);
  }

  const KernelRequest& request_;
  Field target_;
  std::optional<Kernel> best_;
  KernelReport counts_;
  std::string reason_;
};

// Half the tolerance inside, so that the residual recomputed by other sums stays below the whole.
NewtonOptions options_for(const KernelRequest& request) {
  NewtonOptions options;
  options.tolerance = request.tolerance / 2;
  return options;
}

void solve_symmetric(const KernelRequest& request, SymmetricEquations& equations, Search& search) {
  const std::vector<double> start = equations.start();
  std::vector<double> f(start.size());
  if (equations.residual(start, f) && search.iterate(equations, start, options_for(request))) return;
  search.consider(equations, start);
  // A few infeasible-looking cuts have a solution whose spectrum changes sign: one bounded attempt at it.
  equations.guard = false;
  NewtonOptions options = options_for(request);
  options.max_products = 100;
  options.krylov_dimension = 60;
  options.restarts = 0;
  search.iterate(equations, start, options);
}

void solve_patir(const KernelRequest& request, PatirEquations& equations, Search& search) {
  const std::vector<double> start = equations.start();
  NewtonOptions options = options_for(request);
  options.krylov_dimension = 60;
  options.restarts = 1;
  options.forcing = 1e-2;
  if (!search.iterate(equations, start, options)) search.consider(equations, start);
}

void scale(Kernel& kernel, double rms) {
  kernel.rms = rms;
  kernel.values *= rms;
  kernel.acf_target *= rms * rms;
  kernel.acf_achieved *= rms * rms;
}

}  // namespace

std::string_view name_of(Formulation formulation) { return text_of(formulations, formulation); }
std::string_view name_of(Method method) { return text_of(methods, method); }
std::string_view name_of(Infeasible infeasible) { return text_of(answers_to_infeasible, infeasible); }

Formulation formulation_named(std::string_view name) { return named(formulations, "formulation", name); }
Method method_named(std::string_view name) { return named(methods, "method", name); }
Infeasible infeasible_named(std::string_view name) {
  return named(answers_to_infeasible, "infeasible", name);
}

void KernelRequest::check() const {
  if (lags.nx < 1 || lags.ny < 1) throw ParameterError("lags", text(lags) + ": at least 1x1");
  if (lags.nx > most_unknowns / lags.ny)
    throw ParameterError("lags", text(lags) + ": more than " + std::to_string(most_unknowns) + " in all");
  if (!(rms > 0 && std::isfinite(rms)))
    throw ParameterError("rq", number(rms) + ": must be positive and finite");
  if (!(tolerance >= 1e-13 && tolerance <= 1e-2))
    throw ParameterError("tolerance", number(tolerance) + " does not lie in 1e-13 ... 1e-2");
  if (!target) throw ParameterError("target", "there is none");
  if (!(std::abs(target(0, 0) - 1) <= 1e-12))
    throw ParameterError("target", number(target(0, 0)) + " at lag (0,0): must be 1");
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
  const Field target = quadrant(request);
  SymmetricEquations symmetric(target);
  Search search(request);
  const double feasibility = symmetric.feasibility();
  if (request.formulation != Formulation::patir) {
    solve_symmetric(request, symmetric, search);
  } else {
    PatirEquations patir(target);
    solve_patir(request, patir, search);
  }
  Kernel kernel = search.finish(feasibility);
  scale(kernel, request.rms);
  kernel.report.seconds = watch.seconds();
  return kernel;
}

}  // namespace asperity
