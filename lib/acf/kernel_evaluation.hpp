/// What a kernel achieves: its autocorrelation, to compare with the target, and the largest errors.
#pragma once

#include <optional>

#include "acf/kernel.hpp"

namespace asperity {

/// The kernel with its tables and the errors of its report, of positive sum; none when a coefficient is not
/// finite or all are zero.
std::optional<Kernel> evaluate_kernel(const Target& target, Shape lags, Formulation formulation,
                                      Field values);

/// The target at 0 ≤ p < lags.nx, |q| < lags.ny, not a number where it is unknown.
Field half_plane_of(const Target& target, Shape lags);
/// The errors of the report, anew from the tables.
void measure_errors(Kernel& kernel);
/// Sets `converged`: whether the errors are within what the request tolerates.
void judge(KernelReport& report, const KernelRequest& request);

}  // namespace asperity
