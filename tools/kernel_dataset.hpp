/// A kernel and its autocorrelation in a dataset.
///
///     kernel(k, l)         as z(i,j) = Σ kernel(k,l) η(i+k, j+l) applies it
///     acf_target(p, q)     over the half plane p = 0…, q = -…0…+
///     acf_achieved(p, q)   the same lags
/// in m and m2, or in units of the rms height where none is given; lags in metres, or in samples where no
/// spacing is known. Global attributes kernel_* hold the effective parameters and what the
/// solve achieved.
#pragma once

#include "acf/newton_krylov.hpp"
#include "cli/table.hpp"
#include "dataset/layout.hpp"
#include "grid/error.hpp"
#include "kernel_options.hpp"

namespace asperity::cli {

struct KernelTables {
  Field kernel, acf_target, acf_achieved;
  bool has_height = false;  ///< in m and m2, not in units of the rms height
  Spacing spacing;          ///< of the lags

  double rms() const { return std::sqrt(acf_target(0, acf_target.cols() / 2)); }
  void scale(double factor) {
    kernel *= factor;
    acf_target *= factor * factor;
    acf_achieved *= factor * factor;
  }
};

inline void set_kernel(Dataset& data, const KernelTables& tables) {
  const std::string_view height = tables.has_height ? "m" : "1", variance = tables.has_height ? "m2" : "1";
  const std::string_view lag = tables.spacing ? "m" : "1";
  const auto [dx, dy] = tables.spacing.value_or(std::array{1.0, 1.0});
  const Axis p{"p", 0, dx, lag, "lag in x"};
  const Axis q{"q", -(tables.acf_target.cols() / 2), dy, lag, "lag in y"};
  set_table(data, "kernel", tables.kernel, {"k", 0, 1, "1", "row of noise"},
            {"l", 0, 1, "1", "column of noise"}, {height, "moving-average kernel of unit white noise"});
  set_table(data, "acf_target", tables.acf_target, p, q, {variance, "autocorrelation asked for"});
  set_table(data, "acf_achieved", tables.acf_achieved, p, q, {variance, "autocorrelation of the kernel"});
  data.attributes.set("kernel_rms", tables.rms());
}

/// Throws DataError when a table is missing or makes no sense.
inline KernelTables kernel_of(const Dataset& data) {
  KernelTables tables{
      table_of(data, "kernel"), table_of(data, "acf_target"), table_of(data, "acf_achieved"), false, {}};
  if (tables.kernel.size() == 0) throw DataError("kernel", "it has no coefficients");
  if (tables.acf_target.cols() % 2 == 0 || !(tables.rms() > 0))
    throw DataError("acf_target", "its middle column does not begin with the variance");
  tables.has_height = data.at("kernel").attributes.text("units") == "m";
  const Variable &p = data.at("p"), &q = data.at("q");
  if (p.attributes.text("units") == "m") {
    const std::vector<double> rows = numbers(p.values), columns = numbers(q.values);
    const double dx = rows.size() > 1 ? rows[1] - rows[0] : 0,
                 dy = columns.size() > 1 ? columns[1] - columns[0] : 0;
    if (!(dx > 0 && dy > 0)) throw DataError("p", "its lags do not grow");
    tables.spacing = std::array{dx, dy};
  }
  return tables;
}

/// Solves for the kernel and puts it into a new dataset; the options are those of `declare`.
inline Dataset solved_kernel(const KernelOptions& options, const Spacing& spacing) {
  const KernelRequest request = options.request(spacing);
  const Kernel kernel = solve_kernel(request);
  Dataset data;
  set_kernel(data,
             {kernel.values, kernel.acf_target, kernel.acf_achieved, !std::isnan(options.rms), spacing});
  const ExponentialTarget target = options.target(spacing);
  const KernelReport& report = kernel.report;
  Attributes& a = data.attributes;
  a.set("kernel_target", "exponential");
  a.set_values("kernel_length", Values(std::vector<double>{target.length_x, target.length_y}));  // in samples
  a.set("kernel_level", target.level);
  a.set("kernel_formulation", name_of(kernel.formulation));
  a.set("kernel_method", "newton-krylov");
  a.set("kernel_solver", "KINSOL of " + sundials_version());
  a.set_values("kernel_lags", Values(std::vector<std::int32_t>{static_cast<std::int32_t>(kernel.lags.nx),
                                                               static_cast<std::int32_t>(kernel.lags.ny)}));
  a.set("kernel_tolerance", request.tolerance);
  a.set("kernel_residual", report.residual);
  a.set("kernel_error", report.error);
  a.set("kernel_mirrored_error", report.mirrored_error);
  a.set("kernel_tail", report.tail);
  a.set("kernel_feasibility", report.feasibility);
  a.set("kernel_newton_iterations", static_cast<int>(report.newton_steps));
  a.set("kernel_jacobian_products", static_cast<int>(report.jacobian_products));
  a.set("kernel_seconds", report.seconds);
  a.set("kernel_converged", report.converged ? 1 : 0);
  a.set("kernel_reason", report.reason);
  return data;
}

/// Says how the solve went, and returns the exit code that follows from it.
inline Exit tell(const Tool& tool, const Dataset& data) {
  const Attributes& a = data.attributes;
  const std::string reason = a.text("kernel_reason");
  tool.detail("kernel: " + reason + ", residual " + shortest(a.number("kernel_residual", NAN)) +
              ", error over all lags " + shortest(a.number("kernel_error", NAN)));
  if (a.number("kernel_converged", 1) != 0) return done;
  tool.warn("kernel: " + reason);
  return not_converged;
}

}  // namespace asperity::cli
