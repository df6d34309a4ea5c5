/// The kernel of a periodic surface in a dataset (acf/periodic.hpp).
///
/// Such a kernel is right on no other grid, as the attribute kernel_period, in samples, says; acf_target and
/// acf_achieved are those of the periodic surface, at lags up to half a period. It comes about where the
/// correlation of a kernel reaches around a periodic surface, and where a table has all lags of a period.
#pragma once

#include <optional>

#include "tools/surface/kernel_solution.hpp"

namespace asperity::cli {

/// `correlation` of the heights, a half plane of lags up to half a period, is met to round-off where a
/// surface has it, else as nearly as its spectrum can be. Throws ParameterError("memory").
KernelTables on_period(const Field& correlation, Shape period, double rms,
                       const std::optional<Marginal>& marginal, double memory);

/// The largest error of acf_achieved, where the target is known [σ²].
double largest_error(const KernelTables& tables);

/// The sum of a target over the periods, without what has fallen to `left`, over its value at 0: a half plane
/// of lags up to half a period. Says how it differs from the target; throws as wrap_kernel.
Field periodic_correlation(const Tool& tool, const Target& target, Shape surface, double left);

/// The same on the period of a surface, for a kernel whose correlation reaches around it; any other is left
/// as it is. Says how the autocorrelation changes. The solution has not converged where an error beyond the
/// tolerance comes in. Throws UsageError("periodic") where the heights would mostly be one offset, or hardly
/// anything is left of the variance. A profile has no sum across it.
void wrap_kernel(const Tool& tool, KernelSolution& solution, KernelTables& tables, Shape surface);

/// Throws UsageError where the kernel is that of another period, or the surface none.
void check_period(const KernelTables& tables, Shape surface, bool periodic);

}  // namespace asperity::cli
