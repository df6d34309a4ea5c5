#include "tools/surface/kernel_solve.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acf/iteration.hpp"
#include "acf/table.hpp"
#include "acf/wording.hpp"
#include "core/words.hpp"
#include "marginal/predistortion.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/table.hpp"
#include "tools/surface/acf_table.hpp"
#include "tools/surface/kernel_period.hpp"

namespace asperity::cli {
namespace {

constexpr double negligible_change = 1e-6;
constexpr double silent_error =
    1e-2;  // beyond lags that were given, as of a model cut where it has fallen so far

// ---- what is wanted ----

void describe(Attributes& a, const EllipticTarget& model, const std::string& name) {
  a.set("kernel_target", name);
  a.set_values("kernel_length", Values(std::vector<double>{model.length_x / model.spacing_x,
                                                           model.length_y / model.spacing_y}));  // in samples
  a.set("kernel_level", model.level);
  a.set("kernel_angle", model.angle);
  if (model.model == Model::matern) a.set("kernel_smoothness", model.smoothness);
  if (model.model == Model::stretched_exponential) a.set("kernel_exponent", model.exponent);
  if (model.model == Model::self_affine) a.set("kernel_hurst", model.hurst);
  if (model.model == Model::exponential_cosine)
    a.set("kernel_wavelength", model.wavelength / model.spacing_x);  // in samples
}

void take_model(Wanted& out, const Tool& tool, const KernelOptions& options) {
  const EllipticTarget model = options.model(tool, out.spacing);
  out.request.target = model.target();
  describe(out.data.attributes, model, options.target);
}

void take_table(Wanted& out, const Tool& tool, const KernelOptions& options) {
  options.refuse_model(tool);
  AcfTable table = read_acf_table(options.acf, tool.memory_bound());
  tool.reads(options.acf, !table.dataset.variables.empty());
  for (std::size_t axis : {0u, 1u})
    if (out.spacing && table.spacing && std::abs((*out.spacing)[axis] / (*table.spacing)[axis] - 1) > 1e-6)
      throw UsageError(tool.given("--spacing") ? "spacing" : "size",
                       "gives samples of " + format_quantity((*out.spacing)[axis], "m") + ", the table has " +
                           format_quantity((*table.spacing)[axis], "m"));
  if (table.left_out)
    tool.warn("the lags of the table beyond " +
              text({table.half_plane.rows(), table.half_plane.cols() / 2 + 1}) +
              " hold no numbers, and are left out");
  if (!out.spacing) out.spacing = table.spacing;
  if (!out.has_height && std::isfinite(table.rms)) {
    out.request.rms = table.rms;
    out.has_height = true;
  }
  const bool free =
      options.lags == Shape{} && options.formulation.empty() && out.request.method == Method::newton_krylov;
  if (free) out.period = table.period;
  out.request.target = target_of_table(std::move(table.half_plane));
  out.measured = std::move(table.heights);
  out.data = std::move(table.dataset);
  out.before = Inventory(out.data);
  drop_surface(out.data, "kernel");
  tool.settle(out.data);
  out.data.attributes.set("kernel_target", "table");
}

// ---- what came out ----

void describe(Attributes& a, const Kernel& kernel, const KernelRequest& request) {
  const KernelReport& report = kernel.report;
  const bool by_kinsol = request.method == Method::newton_krylov || request.method == Method::fixed_point;
  a.set("kernel_formulation", name_of(kernel.formulation));
  a.set("kernel_method", name_of(request.method));
  if (by_kinsol) a.set("kernel_solver", "KINSOL of " + sundials_version());
  a.set_values("kernel_lags", pair_of(kernel.lags));
  a.set("kernel_tolerance", request.tolerance);
  a.set("kernel_acf_tolerance", request.acf_tolerance);
  a.set("kernel_answer", name_of(report.answer));
  a.set("kernel_residual", report.residual);
  a.set("kernel_change", report.change);
  a.set("kernel_error", report.error);
  a.set("kernel_mirrored_error", report.mirrored_error);
  a.set("kernel_tail", report.tail);
  a.set("kernel_feasibility", report.feasibility);
  a.set("kernel_newton_iterations", static_cast<int>(report.newton_steps));
  a.set("kernel_residuals", static_cast<int>(report.residuals));
  a.set("kernel_jacobian_products", static_cast<int>(report.jacobian_products));
  a.set("kernel_preconditionings", static_cast<int>(report.preconditionings));
  a.set("kernel_seconds", on_record(report.seconds));
  a.set("kernel_converged", report.converged ? 1 : 0);
  a.set("kernel_reason", report.reason);
}

// On the period of its table there is nothing to solve.
Kernel periodic(Wanted& wanted) {
  KernelRequest& request = wanted.request;
  request.method = Method::spectral;
  Kernel out;
  out.formulation = request.target.oriented ? Formulation::oriented : Formulation::symmetric;
  out.lags = *request.target.known;
  const Field target = Field::NullaryExpr(out.lags.nx, 2 * out.lags.ny - 1, [&](Index p, Index column) {
    return request.target(static_cast<double>(p), static_cast<double>(column - out.lags.ny + 1));
  });
  KernelTables tables = on_period(target, *wanted.period, request.rms, wanted.marginal, request.memory);
  KernelReport& report = out.report;
  report.residual = report.change = report.error = largest_error(tables);
  report.answer = report.error <= request.tolerance ? Answer::exact : Answer::nearest;
  report.reason = "the root of the spectrum on the period";
  report.converged = report.error <= request.acf_tolerance;
  if (!report.converged && !allows(request.infeasible, report.error))
    throw DataError(
        "acf",
        "no surface of this period and distribution has this autocorrelation; the closest one found "
        "changes it by " +
            number(report.error) + " (see --infeasible)");
  out.values = std::move(tables.kernel);
  out.acf_target = std::move(tables.acf_target);
  out.acf_achieved = std::move(tables.acf_achieved);
  return out;
}

// Solved for the field below the heights, whose distribution goes into the dataset.
Kernel predistorted(Wanted& wanted) {
  const Predistortion predistortion(wanted.marginal->translation);
  set_marginal(wanted.data, *wanted.marginal);
  wanted.data.attributes.set("kernel_least_acf", predistortion.map().lowest());
  wanted.data.attributes.set("kernel_hermite_tail", predistortion.map().tail());
  return wanted.period ? periodic(wanted) : predistortion.solve(wanted.request);
}

// "40x20 lags chosen: error over all lags 8.1e-4", of a table with what the kernel makes of the lags beyond it.
std::string achieved(const Solved& s) {
  const std::string error = number(s.report.error);
  if (s.period)
    return "a kernel of periodic surfaces of " + text(*s.period) +
           " points (asperity-generate --periodic): error over all lags " + error;
  if (!s.table) return text(s.lags) + " lags chosen: error over all lags " + error;
  return "error over the " + text(s.lags) + " lags of the table " + error +
         "; the autocorrelation beyond them reaches " + number(s.report.tail);
}

// Why a kernel is not what was asked for, from its record.
std::string shortcoming(const Attributes& a) {
  const std::string reason = a.text("kernel_reason");
  if (a.text("kernel_answer") == "best") return "not converged: " + reason;
  const double tolerance = a.number("kernel_acf_tolerance", NAN), change = a.number("kernel_change", 0),
               error = a.number("kernel_error", NAN);
  const std::string what =
      change > tolerance && change < error
          ? "the change of the lags prescribed, " + number(change) + " (over all lags " + number(error) + ")"
          : "the error over all lags, " + number(error);
  return what + " of the variance, exceeds --acf-tolerance " + number(tolerance) +
         (reason == "solved" ? "" : ": " + reason);
}

std::string what_it_is(Answer answer) {
  return answer == Answer::nearest ? "the kernel of the nearest that was found"
                                   : "the kernel of least squares";
}

}  // namespace

Wanted wanted_kernel(const Tool& tool, const KernelOptions& options, const Spacing& spacing) {
  Wanted out;
  out.spacing = spacing;
  out.has_height = !std::isnan(options.rms);
  KernelRequest& request = out.request;
  if (out.has_height) request.rms = options.rms;
  request.lags = options.lags;
  request.method = options.filters() ? Method::newton_krylov : method_named(options.method);
  request.infeasible = infeasible_named(options.infeasible);
  request.tolerance = options.tolerance;
  request.acf_tolerance = options.acf_tolerance;
  request.memory = static_cast<double>(tool.memory());
  if (!options.formulation.empty()) request.formulation = formulation_named(options.formulation);
  if (!tool.given("--acf"))
    take_model(out, tool, options);
  else
    take_table(out, tool, options);
  if (!options.filters()) out.marginal = options.heights.wanted(tool, out.measured, request.infeasible);
  request.check();
  return out;
}

Solved solve(const Tool& tool, Wanted wanted) {
  KernelRequest& request = wanted.request;
  Progress progress(tool);
  StepTable steps(tool, {"lags", "step", "products", "residual"});
  request.progress = [&](const KernelProgress& p) {
    const std::string residual = fmt::format("{:.2e}", p.residual);
    progress.iterate({.stage = std::string(p.iteration) + ", " + text(p.lags) + " lags",
                      .residual = p.residual,
                      .tolerance = request.tolerance / 2,
                      .spent = p.spent,
                      .steps = static_cast<double>(p.products),
                      .name = "products"});
    if (p.step == 0) tool.detail(std::string(p.iteration));
    steps.row({text(p.lags), std::to_string(p.step), std::to_string(p.products), residual});
  };
  const Kernel kernel = wanted.marginal ? predistorted(wanted)
                        : wanted.period ? periodic(wanted)
                                        : solve_kernel(request);
  set_kernel(wanted.data, {kernel.values, kernel.acf_target, kernel.acf_achieved, wanted.has_height,
                           wanted.spacing, wanted.marginal.has_value(), wanted.period});
  describe(wanted.data.attributes, kernel, request);
  return {std::move(wanted.data),
          kernel.report,
          kernel.lags,
          request.lags == Shape{},
          request.target.known.has_value(),
          request.acf_tolerance,
          std::move(wanted.before),
          wanted.period};
}

Exit tell(const Tool& tool, const Solved& s, bool aside) {
  auto say = [&](const std::string& text) { aside ? tool.detail("kernel: " + text) : tool.note(text); };
  const KernelReport& report = s.report;
  tool.detail("kernel: " + std::string(name_of(report.answer)) + ", " + report.reason + ", residual " +
              shortest(report.residual) + ", " + counted(report.jacobian_products, "product") + ", " +
              shortest(report.seconds) + " s");
  if (s.chosen) say(achieved(s));
  if (!report.converged) {
    tool.warn("kernel: " + shortcoming(s.data.attributes));
    return not_converged;
  }
  if (report.answer == Answer::wider)
    say("a kernel wider than " + text(s.lags) + " lags, for none of these has this autocorrelation");
  const bool changed = (report.answer == Answer::nearest || report.answer == Answer::least_squares) &&
                       report.change > negligible_change;
  if (changed && !(s.chosen && s.table))
    tool.warn("no kernel of " + text(s.lags) + " lags has this autocorrelation; " +
              what_it_is(report.answer) + " changes it by up to " + number(report.change) +
              " of the variance");
  if (!s.chosen && report.error > (s.table ? s.acf_tolerance : std::max(s.acf_tolerance, silent_error)))
    tool.warn("the error over all lags is " + number(report.error) + " of the variance: only the " +
              text(s.lags) +
              " lags prescribed are met; without --lags as many are taken as --acf-tolerance needs");
  return done;
}

void tell_read(const Tool& tool, const Dataset& data) {
  const Attributes& a = data.attributes;
  const std::string reason = a.text("kernel_reason");
  tool.detail("kernel: " + reason + ", residual " + shortest(a.number("kernel_residual", NAN)) +
              ", error over all lags " + shortest(a.number("kernel_error", NAN)));
  if (a.number("kernel_converged", 1) == 0) tool.warn("kernel: " + shortcoming(a));
}

}  // namespace asperity::cli
