#include "tools/surface/kernel_dataset.hpp"

#include <utility>

#include "acf/kernel.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {
namespace {

// NAN of a single lag.
double step_of(const Variable& axis, const std::vector<double>& lags) {
  if (lags.size() < 2) return NAN;
  if (!(lags[1] > lags[0])) throw DataError(axis.name, "its lags do not increase");
  return lags[1] - lags[0];
}

// From the lags p and q; of a single lag, from the grid, or else from the other's.
Spacing lag_spacing(const Dataset& data) {
  const Variable &rows = data.at("p"), &columns = data.at("q");
  const auto p = lags_of(rows), q = lags_of(columns);
  if (!p || !q) return std::nullopt;
  double dx = step_of(rows, *p), dy = step_of(columns, *q);
  if ((std::isnan(dx) || std::isnan(dy)) && data.has("x") && data.has("y")) {
    const Grid grid = grid_of(data);
    if (std::isnan(dx)) dx = grid.dx;
    if (std::isnan(dy)) dy = grid.dy;
  }
  if (std::isnan(dx) && std::isnan(dy)) return std::nullopt;
  return std::array{std::isnan(dx) ? dy : dx, std::isnan(dy) ? dx : dy};
}

void check(const KernelTables& tables) {
  if (shape_of(tables.acf_target) != shape_of(tables.acf_achieved))
    throw DataError("acf_achieved", "its lags are not those of acf_target");
  if (tables.acf_target.cols() % 2 == 0 || !(tables.rms() > 0))
    throw DataError("acf_target", "its middle column does not begin with the variance");
  if (tables.kernel.size() == 0) return;
  const double variance = tables.kernel.square().sum(),
               stated = tables.translated ? 1 : tables.acf_achieved(0, tables.acf_achieved.cols() / 2);
  if (!(std::abs(variance - stated) <= 1e-6 * stated))
    throw DataError("kernel", "the sum of its squares, " + shortest(variance) +
                                  ", is not the variance that it must have, " + shortest(stated) +
                                  ": one of them was changed; solve for the kernel again");
}

constexpr Quantity<KernelReport> report_quantities[] = {
    {"kernel_residual", &KernelReport::residual},
    {"kernel_change", &KernelReport::change},
    {"kernel_error", &KernelReport::error},
    {"kernel_mirrored_error", &KernelReport::mirrored_error},
    {"kernel_tail", &KernelReport::tail},
    {"kernel_feasibility", &KernelReport::feasibility},
    {"kernel_newton_iterations", &KernelReport::steps},
    {"kernel_residuals", &KernelReport::residuals},
    {"kernel_jacobian_products", &KernelReport::jacobian_products},
    {"kernel_preconditionings", &KernelReport::preconditionings},
    {"kernel_seconds", &KernelReport::seconds},
    {"kernel_converged", &KernelReport::converged}};

}  // namespace

Spacing spacing_of(Shape shape, std::array<double, 2> size) {
  for (double s : size)
    if (!(s >= 1e-100 && s <= 1e100))
      throw UsageError("size", format_quantity(s, "m") + ": must lie in 1e-100 ... 1e100 m");
  return std::array{size[0] / static_cast<double>(shape.nx), size[1] / static_cast<double>(shape.ny)};
}

void require_spacing(const std::string& option, const std::string& gives, const Spacing& given,
                     const std::string& whose, const Spacing& known, double tolerance) {
  if (!given || !known) return;
  for (std::size_t axis : {0u, 1u})
    if (std::abs((*given)[axis] / (*known)[axis] - 1) > tolerance)
      throw UsageError(option, gives + " of " + format_quantity((*given)[axis], "m") + ", " + whose + " " +
                                   format_quantity((*known)[axis], "m"));
}

void KernelTables::scale(double factor) {
  if (!translated) kernel *= factor;
  acf_target *= factor * factor;
  acf_achieved *= factor * factor;
}

bool has_height(const Variable& acf) {
  const std::string unit = unit_of(acf);
  return !unit.empty() && unit != "1" && factor_to("m2", acf) > 0;
}

KernelTables kernel_of(const Dataset& data) {
  KernelTables out;
  out.has_height = has_height(data.at("acf_target"));
  out.translated = data.attributes.find("kernel_heights") != nullptr;
  const char* const variance = out.has_height ? "m2" : "1";
  if (data.has("kernel")) {
    out.kernel = table_of(data, "kernel", out.has_height && !out.translated ? "m" : "1");
    if (out.kernel.size() == 0) throw DataError("kernel", "it has no coefficients");
  }
  out.acf_target = table_of(data, "acf_target", variance, Missing::not_a_number);
  out.acf_achieved = table_of(data, "acf_achieved", variance);
  out.period = kernel_period(data);
  out.corner = kernel_corner(data);
  check(out);
  out.spacing = lag_spacing(data);
  return out;
}

void set_kernel(Dataset& data, const KernelTables& tables) {
  const char* const unit = tables.has_height && !tables.translated ? "m" : "1";
  set_table(data, "kernel", tables.kernel, {"k", 0, 1, "1", "row of noise"},
            {"l", 0, 1, "1", "column of noise"}, {unit, "moving-average kernel of unit white noise"});
  set_correlation(data, tables);
}

void set_correlation(Dataset& data, const KernelTables& tables) {
  const std::string_view variance = tables.has_height ? "m2" : "1";
  const std::string_view lag = tables.spacing ? "m" : "1";
  const auto [dx, dy] = tables.spacing.value_or(std::array{1.0, 1.0});
  const Axis p{"p", 0, dx, lag, "lag in x"};
  const Axis q{"q", -(tables.acf_target.cols() / 2), dy, lag, "lag in y"};
  set_table(data, "acf_target", tables.acf_target, p, q, {variance, "target autocorrelation"},
            Missing::not_a_number);
  set_table(data, "acf_achieved", tables.acf_achieved, p, q, {variance, "autocorrelation of the kernel"});
  data.attributes.set("kernel_rms", tables.rms());
  for (const auto& [name, shape] :
       {std::pair("kernel_period", tables.period), std::pair("kernel_corner", tables.corner)})
    if (shape)
      data.attributes.set_values(name, pair_of(*shape));
    else
      data.attributes.erase(name);
}

namespace {

std::optional<Shape> counts_in(const Dataset& data, const char* name) {
  const Values* const found = data.attributes.find(name);
  if (found == nullptr) return std::nullopt;
  const std::vector<double> sides = numbers(*found);
  if (sides.size() != 2 || !(sides[0] >= 1 && sides[1] >= 1 && sides[0] <= 1e9 && sides[1] <= 1e9))
    throw DataError(name, "is not a pair of counts");
  return Shape{static_cast<Index>(sides[0]), static_cast<Index>(sides[1])};
}

}  // namespace

std::optional<Shape> kernel_period(const Dataset& data) { return counts_in(data, "kernel_period"); }
std::optional<Shape> kernel_corner(const Dataset& data) { return counts_in(data, "kernel_corner"); }

Values pair_of(Shape s) {
  return std::vector<std::int32_t>{static_cast<std::int32_t>(s.nx), static_cast<std::int32_t>(s.ny)};
}

void record_model(Attributes& a, const EllipticTarget& model) {
  a.set("kernel_target", name_of(model.model));
  a.set_values("kernel_length", Values(std::vector<double>{model.length_x / model.spacing_x,
                                                           model.length_y / model.spacing_y}));
  a.set("kernel_level", model.level);
  a.set("kernel_angle", model.angle);
  for (const ShapeParameter& shape : shape_parameters)
    if (shape.model == model.model)
      a.set("kernel_" + std::string(shape.name),
            model.*shape.value / (shape.is_length ? model.spacing_x : 1));
}

void record_kernel(Attributes& a, const KernelRequest& request, const Kernel& kernel) {
  a.set("kernel_formulation", name_of(kernel.formulation));
  a.set("kernel_method", name_of(request.method));
  if (request.method == Method::newton_krylov) a.set("kernel_solver", "KINSOL of " + sundials_version());
  a.set_values("kernel_lags", pair_of(kernel.lags));
  a.set("kernel_tolerance", request.tolerance);
  a.set("kernel_acf_tolerance", request.acf_tolerance);
  a.set("kernel_answer", name_of(kernel.report.answer));
  record(a, report_quantities, kernel.report);
  a.set("kernel_reason", kernel.report.reason);
}

KernelReport recorded_report(const Attributes& a) {
  KernelReport out;
  out.residual = out.error = NAN;
  out.converged = true;
  read_back(a, report_quantities, out);
  out.reason = a.text("kernel_reason");
  return out;
}

double recorded_tolerance(const Attributes& a) { return a.number("kernel_acf_tolerance", 1e-3); }

}  // namespace asperity::cli
