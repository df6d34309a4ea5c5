/// What asperity-stress leaves of a solution: volumes and attributes of a dataset.
#pragma once

#include "dataset/dataset.hpp"
#include "stress/maximum.hpp"
#include "stress_options.hpp"
#include "stress_quantity.hpp"

namespace asperity::cli {

/// Removes whatever an earlier run left of any quantity.
void forget_stress(Dataset& data);

/// The selected quantities below every cell as volumes name(z, x, y).
void record_volumes(Dataset& data, const StressSolver& solver, const std::vector<double>& depths,
                    const StressSelection& selection);

void record_maximum(Attributes& a, const StressMaximum& maximum);
/// The effective parameters.
void record_parameters(Attributes& a, const StressOptions& options, const StressSolver& solver);

}  // namespace asperity::cli
