/// The error that the grid leaves of a largest stress, from the contact that loads the body on coarser cells.
#pragma once

#include "stress/maximum.hpp"
#include "tools/contact/recorded.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// The contact whose pressure the dataset holds; throws ParameterError("add", …) where it does not tell
/// enough to solve it again.
RecordedContact loading_contact(const Dataset& data, int threads);

/// NaN where not known, because of an edge at the limit pressure.
StressMaximum maximum_error(const LoadedBody& body, DepthResolution resolution,
                            const CoarserContacts& coarser, const StressSearch& search,
                            const StressMaximum& maximum, bool at_limit_pressure, int threads);

void record(Attributes& attributes, Criterion of, const StressMaximum& error);

/// Sets stress_max_…_error and stress_max_depth_error, or warns why there are none.
void record_grid_errors(const Tool& tool, StressScene& scene, const RecordedContact& contact,
                        const StressSearch& search, const StressMaximum& maximum);

}  // namespace asperity::cli
