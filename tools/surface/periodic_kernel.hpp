/// Kernels on a torus, in a dataset (acf/periodic.hpp): of periodic surfaces, or of surfaces that are a
/// corner of a periodic one.
///
/// The attribute kernel_period, in samples, is the torus. Such a kernel is right on no other grid, except
/// that kernel_corner is the largest surface that is not periodic and may be cut out. acf_target and
/// acf_achieved are at lags up to half a period, or less. It comes about where the correlation of a kernel
/// reaches around a periodic surface, where a table has all lags of a period, and where a table is positive
/// definite as it stands.
#pragma once

#include <optional>

#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {

struct TorusOptions {
  double rms = 1;
  const std::optional<Marginal>& marginal;
  Shape lags = {1 << 30, 1 << 30};  ///< of the tables, at most
  bool keeps_kernel = true;
  double memory;
  int threads = 1;
};
struct OnTorus {
  SpectralRoot root = {};
  KernelTables tables = {};
  double error = 0;  ///< largest, over the lags of the correlation [σ²]
};
/// `correlation` of the heights, a half plane of lags up to half the torus, is met to round-off where a
/// surface has it, else as nearly as its spectrum can be. Throws ParameterError("memory").
OnTorus on_torus(const Field& correlation, Shape torus, const TorusOptions& options);

/// The largest error of acf_achieved, where the target is known [σ²].
double largest_error(const KernelTables& tables);

/// The sum of a target over the periods, without what has fallen to `left`, over its value at 0: a half plane
/// of lags up to half a period. Says how it differs from the target; throws as wrap_kernel.
Field periodic_correlation(const Tool& tool, const Target& target, Shape surface, double left);
/// The same of a half plane that is zero where it ends.
Field periodic_correlation(const Tool& tool, const Field& half_plane, Shape surface);

/// The same on the period of a surface, for a kernel whose correlation reaches around it; any other is left
/// as it is. Says how the autocorrelation changes. The solution has not converged where an error beyond the
/// tolerance comes in. Throws UsageError("periodic") where the heights would mostly be one offset, or hardly
/// anything is left of the variance. A profile has no sum across it.
void wrap_kernel(const Tool& tool, KernelSolution& solution, KernelTables& tables, Shape surface);

/// Throws UsageError where the kernel is that of another period, or the surface none.
void check_period(const KernelTables& tables, Shape surface, bool periodic);

}  // namespace asperity::cli
