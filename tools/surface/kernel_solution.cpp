#include "tools/surface/kernel_solution.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acf/periodic.hpp"
#include "core/words.hpp"
#include "marginal/predistortion.hpp"
#include "tools/cli/progress.hpp"
#include "tools/surface/periodic_kernel.hpp"

namespace asperity::cli {
namespace {

constexpr double rounding = 1e-12;  // of a correlation

// ---- the solution ----

// The target's lags up to half the torus: of a small corner others come around it, where it has no lags.
std::shared_ptr<const Field> lags_on_torus(const KernelProblem& problem) {
  const std::shared_ptr<const Field>& table = problem.request.target.table;
  const auto [nx, ny] = *problem.torus;
  const bool fits = table->rows() - 1 <= nx / 2 && table->cols() / 2 <= ny / 2;
  return fits ? table : std::make_shared<const Field>(periodic_sum(*table, *problem.torus));
}

// Why the root of a spectrum is not that of the target.
std::string no_such_surface(const KernelProblem& problem) {
  return std::string("no ") + (problem.corner ? "surface" : "surface of this period") +
         (problem.marginal ? " with this distribution of heights" : "") + " has this autocorrelation";
}

// On a torus, where there are no equations to solve.
SolvedKernel without_equations(KernelProblem& problem) {
  KernelRequest& request = problem.request;
  request.method = Method::spectral;
  SolvedKernel out;
  out.formulation = request.target.oriented ? Formulation::oriented : Formulation::symmetric;
  out.lags = *request.target.known;
  OnTorus found = on_torus(*lags_on_torus(problem), *problem.torus,
                           {.rms = request.rms,
                            .marginal = problem.marginal,
                            .lags = problem.lags_kept(),
                            .keeps_kernel = problem.keeps_kernel,
                            .memory = request.memory,
                            .threads = problem.threads});
  KernelReport& report = out.report;
  report.residual = report.change = report.error = found.error;
  report.answer = report.error <= request.tolerance ? Answer::exact : Answer::nearest;
  report.reason = problem.corner ? "the root of the spectrum on a torus around the surface"
                                 : "the root of the spectrum on the period";
  report.converged = report.error <= request.acf_tolerance;
  if (!report.converged) report.reason = no_such_surface(problem);
  if (!report.converged && !allows(request.infeasible, report.error))
    throw DataError(problem.extent, report.reason + "; that of the nearest one differs by up to " +
                                        number(report.error) +
                                        " of the variance (--infeasible nearest draws it)");
  out.values = std::move(found.tables.kernel);
  out.acf_target = std::move(found.tables.acf_target);
  out.acf_achieved = std::move(found.tables.acf_achieved);
  out.root = std::move(found.root);
  return out;
}

// Of a prescribed spectrum, where there are none either.
SolvedKernel band_limited(const KernelProblem& problem) {
  SolvedKernel out;
  const double rms = problem.request.rms;
  out.lags = {problem.period->nx / 2 + 1, problem.period->ny / 2 + 1};
  out.root = problem.band->root();
  if (problem.keeps_kernel) out.values = kernel_of(*out.root, problem.threads) * rms;
  const Field correlation = problem.band->correlation();
  const bool mirrored = (correlation - correlation.rowwise().reverse()).abs().maxCoeff() <= rounding;
  out.formulation = mirrored ? Formulation::symmetric : Formulation::oriented;
  out.acf_target = correlation * (rms * rms);
  out.acf_achieved = correlation_of(*out.root, problem.threads) * (rms * rms);
  out.report.residual = out.report.change = out.report.error =
      (out.acf_achieved - out.acf_target).abs().maxCoeff() / (rms * rms);
  out.report.reason = "the root of the spectrum, which is prescribed";
  out.report.converged = true;
  return out;
}

// Solved for the field below the heights.
SolvedKernel answer(KernelProblem& problem) {
  if (problem.band) return band_limited(problem);
  if (!problem.marginal)
    return problem.torus ? without_equations(problem) : SolvedKernel{solve_kernel(problem.request)};
  const Predistortion predistortion(problem.marginal->translation);
  SolvedKernel out =
      problem.torus ? without_equations(problem) : SolvedKernel{predistortion.solve(problem.request)};
  out.least_acf = predistortion.map().lowest();
  out.hermite_tail = predistortion.map().tail();
  return out;
}

// ---- its record ----

void record_target(Attributes& a, const KernelProblem& problem) {
  if (!problem.model)
    return a.set("kernel_target", std::string_view(problem.extent) == "psd" ? "spectrum" : "table");
  const EllipticTarget& model = *problem.model;
  record_model(a, model);
  if (!problem.band) return;
  const Band& band = problem.band->band();
  if (band.cuts()) a.set("kernel_cutoff", band.cutoff / model.spacing_x);
  if (band.levels())
    a.set_values("kernel_rolloff", Values(std::vector<double>{band.rolloff_x / model.spacing_x,
                                                              band.rolloff_y / model.spacing_y}));
}

void record_heights(Dataset& data, const Marginal& marginal, const SolvedKernel& kernel) {
  set_marginal(data, marginal);
  data.attributes.set("kernel_least_acf", kernel.least_acf);
  data.attributes.set("kernel_hermite_tail", kernel.hermite_tail);
}

// ---- what is reported ----

// "40x20 lags chosen: error over all lags 8.1e-4", of a table with what the kernel makes of the lags beyond
// it.
std::string achieved(const KernelProblem& problem, const Kernel& kernel) {
  const std::string error = number(kernel.report.error);
  if (problem.corner)
    return "a kernel of surfaces up to " + text(*problem.corner) + " points: error over all lags " + error;
  if (problem.period)
    return "a kernel of periodic surfaces of " + text(*problem.period) +
           " points (asperity-generate --periodic): error over all lags " + error;
  if (!problem.request.target.known) return text(kernel.lags) + " lags chosen: error over all lags " + error;
  return "error over the " + text(kernel.lags) + " lags of the table " + error +
         "; the autocorrelation beyond them reaches " + number(kernel.report.tail);
}

// Why a kernel is not as requested, from its record.
std::string shortcoming(const Attributes& a) {
  const KernelReport report = recorded_report(a);
  const double tolerance = recorded_tolerance(a);
  const std::string error = number(report.error),
                    what = report.change > tolerance && report.change < report.error
                               ? "the kernel's change of the prescribed lags, " + number(report.change) +
                                     " (over all lags " + error + ")"
                               : "the kernel's error over all lags, " + error;
  return what + " of the variance, exceeds --acf-tolerance " + number(tolerance) +
         (report.reason == "solved" ? "" : ": " + report.reason);
}

// How a solved kernel changes the lags prescribed, and why; "" of one that does not.
std::string changed(const KernelProblem& problem, const Kernel& kernel) {
  const auto& [answer, change] = std::pair(kernel.report.answer, kernel.report.change);
  if (answer == Answer::exact || answer == Answer::wider || change <= problem.request.tolerance) return "";
  const std::string by = " by up to " + number(change) + " of the variance";
  if (answer == Answer::spectral) return "the root of the spectrum changes the autocorrelation" + by;
  if (problem.torus) return no_such_surface(problem) + "; that of the nearest one differs" + by;
  return "no kernel of " + text(kernel.lags) +
         " lags has this autocorrelation; the kernel of the nearest feasible one changes it" + by;
}

void warn_of_errors(const Tool& tool, const KernelRequest& request, const Kernel& kernel) {
  const KernelReport& report = kernel.report;
  if (request.lags != Shape{} && report.error > request.acf_tolerance)
    tool.warn("the error over all lags is " + number(report.error) + " of the variance: only the " +
              text(kernel.lags) +
              " prescribed lags are met; leave out --lags to meet --acf-tolerance at all lags");
}

Exit report_on(const Tool& tool, const KernelProblem& problem, const Kernel& kernel, bool aside) {
  auto say = [&](const std::string& text) { aside ? tool.detail("kernel: " + text) : tool.note(text); };
  const KernelReport& report = kernel.report;
  tool.detail("kernel: " + std::string(name_of(report.answer)) + ", " + report.reason + ", residual " +
              shortest(report.residual) + ", " + counted(report.jacobian_products, "product") + ", " +
              shortest(report.seconds) + " s");
  if (problem.request.lags == Shape{}) say(achieved(problem, kernel));
  if (!report.converged) {
    tool.warn(shortcoming(problem.data.attributes));
    return not_converged;
  }
  if (report.answer == Answer::wider)
    say("a kernel wider than " + text(kernel.lags) +
        " lags, because no kernel of these has this autocorrelation");
  warn_of_errors(tool, problem.request, kernel);
  return done;
}

}  // namespace

SolvedKernel solve(const Tool& tool, KernelProblem& problem, bool aside) {
  constexpr double before_drawing = 0.3;  // of the bar
  KernelRequest& request = problem.request;
  Progress progress(tool, aside ? before_drawing : 1);
  StepTable steps(tool, {"lags", "step", "products", "residual"});
  request.progress = [&](const KernelProgress& p) {
    const std::string residual = fmt::format("{:.2e}", p.residual);
    progress.iterate({.stage = {std::string(p.iteration), text(p.lags) + " lags"},
                      .residual = p.residual,
                      .tolerance = request.tolerance / 2,
                      .spent = p.spent,
                      .steps = static_cast<double>(p.products),
                      .name = "products",
                      .portion = 0.8});  // another iteration may follow
    if (p.step == 0) tool.detail(std::string(p.iteration));
    steps.row({text(p.lags), std::to_string(p.step), std::to_string(p.products), residual});
  };
  SolvedKernel out = answer(problem);
  request.progress = {};
  return out;
}

KernelSolution record(const Tool& tool, KernelProblem problem, SolvedKernel kernel, bool aside) {
  record_target(problem.data.attributes, problem);
  if (problem.marginal) record_heights(problem.data, *problem.marginal, kernel);
  const KernelTables tables{kernel.values,      kernel.acf_target, kernel.acf_achieved,
                            problem.has_height, problem.spacing,   problem.marginal.has_value(),
                            problem.torus,      problem.corner};
  tables.kernel.size() > 0 ? set_kernel(problem.data, tables) : set_correlation(problem.data, tables);
  record_kernel(problem.data.attributes, problem.request, kernel);
  const Exit code = report_on(tool, problem, kernel, aside);
  std::string change = code == done ? changed(problem, kernel) : "";
  return {std::move(problem.data), std::move(problem.before), code, std::move(change),
          std::move(kernel.root)};
}

void report_read(const Tool& tool, const Dataset& data) {
  const KernelReport report = recorded_report(data.attributes);
  tool.detail("kernel: " + report.reason + ", residual " + shortest(report.residual) +
              ", error over all lags " + shortest(report.error));
  if (!report.converged) tool.warn(shortcoming(data.attributes));
}

}  // namespace asperity::cli
