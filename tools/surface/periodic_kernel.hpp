/// The kernel of a periodic surface in a dataset (acf/periodic.hpp).
///
/// Such a kernel is solved for on one period, and right on no other grid. The attribute kernel_period, in
/// samples, says so; acf_target and acf_achieved are then those of the periodic surface, at lags up to half a
/// period. It comes about where the correlation of a kernel reaches around the surface that is drawn with
/// --periodic, and where the table of --acf is that of a whole period.
#pragma once

#include <optional>

#include "tools/cli/tool.hpp"
#include "tools/surface/kernel_dataset.hpp"
#include "tools/surface/marginal_dataset.hpp"

namespace asperity::cli {

/// `correlation` of the heights, a half plane of lags up to half a period, is met to round-off where a
/// surface has it, else as nearly as its spectrum can be; acf_achieved is what is. Throws
/// ParameterError("memory") where it takes more than so many bytes.
KernelTables on_period(const Field& correlation, Shape period, double rms,
                       const std::optional<Marginal>& marginal, double memory);

/// The largest error of acf_achieved, where the target is known [σ²].
double largest_error(const KernelTables& tables);

/// The same on the period of a surface, for a kernel whose correlation reaches around it; a kernel that does
/// not is left as it is, and so is one of this period. Says how the autocorrelation changes. Returns
/// not_converged where an error beyond the tolerance of the kernel comes in. Throws UsageError("periodic")
/// where the heights would mostly be one offset, or hardly anything is left of the variance.
Exit wrap_kernel(const Tool& tool, Dataset& data, KernelTables& tables, Shape surface, double memory);

/// Throws UsageError where the kernel is that of another period, or the surface none.
void check_period(const KernelTables& tables, Shape surface, bool periodic);

}  // namespace asperity::cli
