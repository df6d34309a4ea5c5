/// Error of the moving-average kernel against its cost, and what becomes of the extreme targets.
///
/// Targets of the first two tables: the exponential that has fallen to e⁻ᶜ at the last of n × m lags,
/// oriented ones drawn out 3 : 1 and turned by 30°. `error` is the largest over all lags of the plane,
/// `mirrored` that over the quadrant (p,-q), both against the true, uncut target; `ratio` is the time of the
/// whole solve, plans, tables and report included, over that of its transforms: those of its residuals,
/// products and preconditionings as they ran, and the few others timed alone.
///
/// The third table is the stability of the search: `outcome` is the report's answer, or "refused" and why, or,
/// where there is no exact kernel, what least squares come to; targets of more than 4 LARGEST_N² lags are left out.
///
///     acf_error_time [LARGEST_N]         lags a side, 63 unless given
#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "acf/equations.hpp"
#include "acf/kernel.hpp"
#include "acf_yardsticks.hpp"
#include "reference/exponential_target.hpp"
#include "timing.hpp"

using namespace asperity;

namespace {

KernelRequest cut(Shape lags, double c, Formulation formulation, Method method = Method::newton_krylov) {
  EllipticTarget target;
  target.length_x = static_cast<double>(lags.nx);
  target.length_y = static_cast<double>(lags.ny);
  target.level = std::exp(-c);
  if (formulation == Formulation::oriented) {
    target.length_y /= 3;
    target.angle = std::numbers::pi / 6;
  }
  KernelRequest request;
  request.target = target.target();
  request.lags = lags;
  request.formulation = formulation;
  request.method = method;
  return request;
}

Seconds zero_phase_seconds(Shape lags, Shape torus, bool oriented) {
  const auto transform = zero_phase_transform(lags, torus, oriented);
  std::vector<double> part(transform->multiplicity().size(), 1.0), out(part);
  return seconds_of([&] { transform->filter(part, out, [](Index, std::span<double>) {}); });
}

// What is not Newton's iteration: the look at the target's spectrum, the start, the last autocorrelation.
double other_transform_seconds(const KernelRequest& request) {
  const auto [n, m] = request.lags;
  const bool patir = request.formulation == Formulation::patir,
             oriented = request.formulation == Formulation::oriented;
  const double spectrum = 0.5 * zero_phase_seconds({n, m}, ZeroPhaseEquations::least_torus({n, m}), oriented);
  return patir ? spectrum + 2 * real_transform_seconds({2 * n, 2 * m})
               : 3 * spectrum + zero_phase_seconds({2 * n - 1, 2 * m - 1}, {4 * n - 2, 4 * m - 2}, oriented);
}

using Solve = KernelReport (*)(const KernelRequest&);

KernelReport by_the_library(const KernelRequest& request) { return solve_kernel(request).report; }

void row(std::string_view method, const KernelRequest& request, double c, Solve solve = by_the_library) {
  KernelReport r;
  const Seconds seconds = seconds_of([&] {
    if (const KernelReport report = solve(request); r.seconds == 0 || report.seconds < r.seconds) r = report;
  });
  const std::string ratio =
      r.equation_seconds > 0
          ? fmt::format("{:.2f}", r.seconds / (r.equation_seconds + other_transform_seconds(request)))
          : "-";
  fmt::print("{}\t{}\t{}x{}\t{}\t{:.2e}\t{:.2e}\t{:.2e}\t{:.2e}\t{}\t{}\t{}\t{}\n", method,
             name_of(*request.formulation), request.lags.nx, request.lags.ny, c, r.error, r.mirrored_error,
             seconds, r.residual, r.steps, r.jacobian_products, ratio,
             r.converged ? name_of(r.answer) : "best");
}

void head(const char* title) {
  fmt::print(
      "\n# {}\n# method\tformulation\tlags\tc\terror\tmirrored\tseconds\tseconds_spread\tresidual\t"
      "steps\tproducts\tratio\tanswer\n",
      title);
}

// ---- stability ----

struct Extreme {
  const char* name;
  const char* difficulty;
  Target target;
  Shape lags;
};

Target radial(double (*rho)(double), double length) {
  return [=](double p, double q) { return rho(std::hypot(p, q) / length); };
}

// A table as an estimate from one surface leaves it: the exponential under noise that does not fall.
Target noisy(Shape lags, double noise) {
  Target target = [=](double p, double q) {
    const double r = std::hypot(p, q);
    const double ripple = noise * std::sin(12.9898 * p + 78.233 * q + 3 * std::cos(7.1 * p - 3.3 * q));
    return r == 0 ? 1 : std::exp(-r / 6) + (p == 0 || q == 0 ? 0.5 : 1) * ripple;
  };
  target.known = lags;
  return target;
}

std::vector<Extreme> extremes() {
  auto exponential = [](double x, double y, double c) { return ExponentialTarget{x, y, std::exp(-c)}; };
  auto gaussian = [](double r) { return std::exp(-r * r); };
  auto delta = [](double p, double q) { return p == 0 && q == 0 ? 1.0 : 0.0; };
  return {
      {"10 % cut, 7x4", "spectrum negative", exponential(7, 4, 2.3), {7, 4}},
      {"10 % cut, 13x13", "kernel's spectrum changes sign", exponential(13, 13, 2.3), {13, 13}},
      {"10 % cut, 17x14", "no kernel of its size", exponential(17, 14, 2.3), {17, 14}},
      {"10 % cut, 31x31", "no kernel of its size", exponential(31, 31, 2.3), {31, 31}},
      {"1 % cut, 191x191", "no kernel of its size", exponential(191, 191, 4.6), {191, 191}},
      {"Gaussian, e^-4.6", "cut spectrum negative", radial(gaussian, 31 / std::sqrt(4.6)), {31, 31}},
      {"Gaussian, e^-14", "spectrum below round-off", radial(gaussian, 31 / std::sqrt(14)), {31, 31}},
      {"Gaussian, e^-30", "spectrum below round-off", radial(gaussian, 31 / std::sqrt(30)), {31, 31}},
      {"profile 1024x1", "one row", exponential(1024, 1, 4.6), {1024, 1}},
      {"profile 1x64", "one column", exponential(1, 64, 4.6), {1, 64}},
      {"strip 1024x2", "two columns", exponential(1024, 2, 4.6), {1024, 2}},
      {"gamma = 100", "600 x 6 lags", exponential(600, 6, 4.6), {600, 6}},
      {"delta, 1x1", "nothing to solve", delta, {1, 1}},
      {"delta, 31x31", "the start is the solution", delta, {31, 31}},
      {"constant", "does not fall at all", [](double, double) { return 1.0; }, {31, 31}},
      {"length of 1e6 samples", "nearly constant", exponential(1e6, 1e6, 1), {31, 31}},
      {"J0(r/4)", "a ring of a spectrum", radial([](double r) { return ::j0(r); }, 4), {31, 31}},
      {"exp(-r) cos(4r), radial",
       "no autocorrelation",
       radial([](double r) { return std::exp(-r) * std::cos(4 * r); }, 6),
       {31, 31}},
      {"table, noise of 1e-3", "as estimated", noisy({24, 24}, 1e-3), {24, 24}},
      {"table, noise of 3e-2", "as estimated", noisy({24, 24}, 3e-2), {24, 24}},
      {"table, R(1) = -0.9",
       "no autocorrelation",
       [] {
         Target t = [](double p, double q) { return q != 0 ? 0.0 : p == 0 ? 1.0 : p < 3 ? -0.9 : 0.0; };
         t.known = Shape{8, 2};
         return t;
       }(),
       {8, 2}},
  };
}

// Whether a kernel of these lags was found.
bool outcome(const Extreme& extreme, InfeasiblePolicy infeasible) {
  KernelRequest request;
  request.target = extreme.target;
  request.lags = extreme.lags;
  request.infeasible = infeasible;
  fmt::print("{}\t{}\t{}\t", extreme.name, extreme.difficulty, name_of(infeasible));
  auto refusal = [&]() -> std::string {
    try {
      solve_kernel(request);
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  const std::string refused = refusal();
  const Seconds seconds = seconds_of(refusal);
  if (refused != "") {
    fmt::print("refused: {}\t-\t-\t-\t-\t{:.2e}\n", refused, seconds);
    return false;
  }
  const Kernel k = solve_kernel(request);
  const KernelReport& r = k.report;
  fmt::print("{}\t{:.1e}\t{:.1e}\t{:.1e}\t{}x{}\t{:.2e}\n", name_of(r.answer), r.residual, r.error,
             r.feasibility, k.values.rows(), k.values.cols(), seconds);
  return r.answer == Answer::exact;
}

void outcome_of_least_squares(const Extreme& extreme) {
  KernelRequest request;
  request.target = extreme.target;
  request.lags = extreme.lags;
  request.formulation = Formulation::symmetric;
  const KernelReport r = least_squares(request);
  const Seconds seconds = seconds_of([&] { least_squares(request); });
  fmt::print("{}\t{}\tleast-squares\t{}\t{:.1e}\t{:.1e}\t-\t{}x{}\t{:.2e}\n", extreme.name,
             extreme.difficulty, r.converged ? "exact" : "least-squares", r.residual, r.error,
             2 * extreme.lags.nx - 1, 2 * extreme.lags.ny - 1, seconds);
}

}  // namespace

int main(int argc, char** argv) {
  print_conditions();
  const Index largest = argc > 1 ? std::atol(argv[1]) : 63;
  const std::string_view newton = name_of(Method::newton_krylov);
  head("Newton-Krylov");
  for (Formulation f : {Formulation::symmetric, Formulation::oriented, Formulation::patir})
    for (Index n = 7; n <= largest; n = 2 * n + 1)
      for (double c : {4.6, 6.0, 7.0, 9.0, 11.5, 14.0})
        if (f != Formulation::patir || c == 4.6 || c == 7.0)
          if (f != Formulation::patir || c == 7.0 || n <= 64) row(newton, cut({n, n}, c, f), c);
  for (Shape lags : {Shape{7, 4}, Shape{3, 3}, Shape{17, 4}, Shape{17, 14}, Shape{13, 13}})
    for (Formulation f : {Formulation::symmetric, Formulation::patir}) row(newton, cut(lags, 4.6, f), 4.6);
  head("The other methods");
  for (Formulation f : {Formulation::symmetric, Formulation::oriented, Formulation::patir})
    for (Index n : {7, 15, 31}) row("fixed-point", cut({n, n}, 4.6, f), 4.6, anderson_fixed_point);
  for (Formulation f : {Formulation::symmetric, Formulation::oriented})
    for (Index n : {7, 15, 31}) row("conjugate-gradient", cut({n, n}, 4.6, f), 4.6, conjugate_gradient);
  for (Formulation f : {Formulation::symmetric, Formulation::oriented, Formulation::patir})
    for (Index n : {7, 15, 31}) row(name_of(Method::spectral), cut({n, n}, 4.6, f, Method::spectral), 4.6);
  fmt::print(
      "\n# Stability\n# "
      "case\tdifficulty\tinfeasible\toutcome\tresidual\terror\tfeasibility\tkernel\tseconds\tseconds_"
      "spread\n");
  for (const Extreme& extreme : extremes())
    if (extreme.lags.cells() <= 4 * largest * largest) {
      const bool solved = outcome(extreme, InfeasiblePolicy::automatic);
      outcome(extreme, InfeasiblePolicy::nearest);
      if (!solved) outcome_of_least_squares(extreme);
    }
  return 0;
}
