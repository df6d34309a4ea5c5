#include "tools/surface/periodic_kernel.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "acf/kernel.hpp"
#include "acf/periodic.hpp"
#include "core/words.hpp"
#include "marginal/predistortion.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "transform/plan.hpp"

namespace asperity::cli {
namespace {

constexpr double notable_change = 1e-9;  // of the variance: more than round-off
constexpr double least_variance = 0.01;  // of the one requested
constexpr double largest_offset = 0.5;   // share of the variance
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// More lags of a half plane, which hold `fill`.
Field extended(const Field& half_plane, Shape lags, double fill) {
  Field out = Field::Constant(lags.nx, lags.ny, fill);
  out.block(0, (lags.ny - half_plane.cols()) / 2, half_plane.rows(), half_plane.cols()) = half_plane;
  return out;
}

// Fewer lags of a half plane.
Field within(const Field& half_plane, Shape lags) {
  return half_plane.block(0, (half_plane.cols() - lags.ny) / 2, lags.nx, lags.ny);
}

// What was requested; where nothing was, what the kernel made of it.
Field asked_for(const KernelTables& tables) {
  return tables.acf_target.isNaN().select(tables.acf_achieved, tables.acf_target) /
         (tables.rms() * tables.rms());
}

// What a surface can be given: what was requested where the table holds all of it, else what the kernel has.
Field had(const KernelTables& tables, const Attributes& a) {
  const bool all = recorded_report(a).error <= recorded_tolerance(a);
  return all ? asked_for(tables) : (tables.acf_achieved / (tables.rms() * tables.rms())).eval();
}

// Of a profile those along it: it has no others to add up.
Field own_lags(const Field& half_plane, Shape surface) {
  return within(half_plane, {surface.nx > 1 ? half_plane.rows() : 1, surface.ny > 1 ? half_plane.cols() : 1});
}

double variance(const Field& half_plane) { return half_plane(0, half_plane.cols() / 2); }

std::string around(Shape surface) {
  return "the correlation reaches around the surface of " + text(surface) + " points";
}

void refuse_offset(const Field& correlation, Shape surface) {
  if (surface.cells() <= 1) return;
  const EffectiveSampleSize size(LagField(correlation), Pairs(Grid{surface, 1, 1, true}));
  const double offset = size.mean_power(1);
  if (offset > largest_offset)
    throw UsageError("periodic",
                     around(surface) + fmt::format(": {:.0f} % of the variance would be one offset of all "
                                                   "heights; choose shorter lengths or a larger surface",
                                                   100 * offset));
}

void refuse_rest(double left, Shape surface) {
  if (!(left >= least_variance))
    throw UsageError(
        "periodic", around(surface) + fmt::format(": its sum over the periods leaves {:.2g} of the variance, "
                                                  "the error of a kernel; choose another size or length",
                                                  left));
}

void warn_of_change(const Tool& tool, double change, Shape surface) {
  if (change <= notable_change) return;
  tool.warn("--periodic: " + around(surface) + " and changes the autocorrelation by up to " +
            fmt::format("{:.2g}", change) +
            " of the variance: it is the sum over the periods, at the prescribed rms height");
}

// A sum over the periods over its value at 0; `alone`: without the other periods.
Field checked_sum(const Tool& tool, Field sum, const Field& alone, Shape surface) {
  refuse_rest(variance(sum), surface);
  sum /= variance(sum);
  refuse_offset(sum, surface);
  warn_of_change(tool, (sum - alone).abs().maxCoeff(), surface);
  return sum;
}

// What the solution on the plane has left on record, of the kernel that has taken its place.
void record(Attributes& a, double error) {
  a.set("kernel_method", name_of(Method::spectral));
  a.set("kernel_answer", name_of(Method::spectral));
  a.set("kernel_reason", "the root of the spectrum on the period");
  for (const char* name : {"kernel_residual", "kernel_change", "kernel_error", "kernel_mirrored_error"})
    a.set(name, error);
  a.set("kernel_tail", 0.0);
  a.erase("kernel_solver");
}

// The lags that a period has: of those beyond half of it the autocorrelation is that of others.
void cut(KernelTables& tables, Attributes& a, Shape surface) {
  const Index rows = std::min(tables.acf_target.rows(), surface.nx / 2 + 1),
              columns = std::min(tables.acf_target.cols(), surface.ny / 2 * 2 + 1);
  if (rows == tables.acf_target.rows() && columns == tables.acf_target.cols()) return;
  for (Field* table : {&tables.acf_target, &tables.acf_achieved}) *table = within(*table, {rows, columns});
  a.set("kernel_error", largest_error(tables));
}

}  // namespace

double largest_error(const KernelTables& tables) {
  const auto known = !tables.acf_target.isNaN();
  return known.select((tables.acf_achieved - tables.acf_target).abs(), 0).maxCoeff() /
         variance(tables.acf_target);
}

OnTorus on_torus(const Field& correlation, Shape torus, const TorusOptions& o) {
  check_memory(o.keeps_kernel ? periodic_kernel_cost(torus) : root_cost(torus), o.memory, torus);
  const std::optional<CorrelationMap> map =
      o.marginal ? std::optional<CorrelationMap>(o.marginal->translation) : std::nullopt;
  OnTorus out;
  out.root =
      map ? spectral_root(correlation.unaryExpr([&](double r) { return map->inverse(r); }), torus, o.threads)
          : spectral_root(correlation, torus, o.threads);
  const Shape kept{std::min(o.lags.nx, torus.nx / 2 + 1), std::min(o.lags.ny, torus.ny / 2 + 1)};
  const Index middle = torus.ny / 2, columns = 2 * kept.ny - 1, most_q = correlation.cols() / 2;
  Field achieved(kept.nx, columns);
  Eigen::ArrayXd errors = Eigen::ArrayXd::Zero(std::max(kept.nx, correlation.rows()));
  correlation_of(
      out.root, errors.size(),
      [&](Index first, const Eigen::Ref<const Field>& rows) {
        Field heights = rows;
        if (map) heights = rows.unaryExpr([&](double rho) { return (*map)(std::clamp(rho, -1.0, 1.0)); });
        for (Index i = 0; i < rows.rows(); ++i) {
          const Index p = first + i;
          if (p < kept.nx) achieved.row(p) = heights.row(i).segment(middle - kept.ny + 1, columns);
          if (p < correlation.rows())
            errors(p) = (heights.row(i).segment(middle - most_q, correlation.cols()) - correlation.row(p))
                            .abs()
                            .maxCoeff();
        }
      },
      o.threads);
  out.error = errors.maxCoeff();
  KernelTables& tables = out.tables;
  tables.translated = o.marginal.has_value();
  if (o.keeps_kernel) tables.kernel = kernel_of(out.root, o.threads) * (tables.translated ? 1 : o.rms);
  const Shape known{std::min(kept.nx, correlation.rows()), std::min(kept.ny, most_q + 1)};
  tables.acf_target =
      extended(within(correlation, {known.nx, 2 * known.ny - 1}), shape_of(achieved), unknown);
  tables.acf_target *= o.rms * o.rms;
  tables.acf_achieved = std::move(achieved) * (o.rms * o.rms);
  tables.period = torus;
  return out;
}

Field periodic_correlation(const Tool& tool, const Target& target, Shape surface, double left) {
  const Shape far = target.reach(left);
  auto first = [](Index lag, Index reach, Index period) {
    return lag - std::max<Index>(lag + reach - 1, 0) / period * period;
  };
  auto sum = [&](Index p, Index q) {  // the lag's own value at any distance
    double out = 0;
    for (Index i = first(p, far.nx, surface.nx); i < std::max(far.nx, p + 1); i += surface.nx)
      for (Index j = first(q, far.ny, surface.ny); j < std::max(far.ny, q + 1); j += surface.ny)
        out += target(static_cast<double>(i), static_cast<double>(j));
    return out;
  };
  const Index middle = surface.ny / 2;
  auto half_plane = [&](auto value) -> Field {
    return Field::NullaryExpr(surface.nx / 2 + 1, 2 * middle + 1,
                              [&](Index p, Index column) { return value(p, column - middle); });
  };
  return checked_sum(tool, half_plane(sum),
                     half_plane([&](Index p, Index q) { return target(double(p), double(q)); }), surface);
}

Field periodic_correlation(const Tool& tool, const Field& half_plane, Shape surface) {
  const Field sum = periodic_sum(half_plane, surface);
  return checked_sum(tool, sum, within(half_plane, shape_of(sum)), surface);
}

void wrap_kernel(const Tool& tool, KernelSolution& solution, KernelTables& tables, Shape surface) {
  if (tables.period) return;
  Attributes& a = solution.data.attributes;
  if (!reaches_around(shape_of(tables.kernel), surface)) return cut(tables, a, surface);
  const Field alone = own_lags(asked_for(tables), surface), asked = periodic_sum(alone, surface),
              sum = periodic_sum(own_lags(had(tables, a), surface), surface),
              correlation = sum / variance(sum);
  refuse_rest(std::min(variance(sum), variance(asked)), surface);
  refuse_offset(correlation, surface);
  const Field target =
      within(tables.acf_target, shape_of(asked)).isNaN().select(unknown, asked / variance(asked));
  OnTorus found = on_torus(correlation, surface,
                           {.rms = tables.rms(),
                            .marginal = marginal_of(solution.data),
                            .memory = static_cast<double>(tool.memory()),
                            .threads = tool.thread_count()});
  KernelTables& wrapped = found.tables;
  wrapped.acf_target =
      extended(target, shape_of(wrapped.acf_achieved), unknown) * (tables.rms() * tables.rms());
  wrapped.has_height = tables.has_height;
  wrapped.spacing = tables.spacing;
  tables = std::move(wrapped);
  solution.root = std::move(found.root);
  const double error = largest_error(tables), tolerance = recorded_tolerance(a);
  const bool met = !(recorded_report(a).error > tolerance);
  record(a, error);
  warn_of_change(tool, (correlation - within(alone, shape_of(correlation))).abs().maxCoeff(), surface);
  if (!met) return;
  solution.change.clear();
  if (error > notable_change)
    solution.change =
        "the kernel changes the sum over the periods by up to " + number(error) + " of the variance";
  if (error <= tolerance) return;
  a.set("kernel_converged", 0);
  solution.change += ", more than --acf-tolerance " + number(tolerance);
  solution.code = not_converged;
}

void check_period(const KernelTables& tables, Shape surface, bool periodic) {
  if (!tables.period || (periodic && *tables.period == surface)) return;
  if (!periodic && tables.corner) {
    if (surface.nx <= tables.corner->nx && surface.ny <= tables.corner->ny) return;
    throw UsageError("shape", text(surface) + ": the kernel is for surfaces up to " + text(*tables.corner) +
                                  " points; solve for it with this --shape");
  }
  const std::string words = "the kernel is for periodic surfaces of " + text(*tables.period) + " points";
  if (periodic) throw UsageError("shape", text(surface) + ": " + words);
  throw UsageError("periodic", "is required: " + words +
                                   "; for other surfaces solve with --length, or with fewer lags of its "
                                   "table (asperity-acf --max-lag)");
}

}  // namespace asperity::cli
