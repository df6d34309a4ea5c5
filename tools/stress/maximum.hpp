/// The largest stress below a loaded surface: --maximum with the errors that the grid leaves of it, and the
/// table of --result maxima.
#pragma once

#include "stress/maximum.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/tool.hpp"
#include "tools/contact/record.hpp"
#include "tools/stress/options.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// What --of and --below ask for on this grid; throws ParameterError("below", …).
StressSearch search_of(const StressOptions& options, const Grid& grid);

/// The name of the attribute with this maximum.
std::string attribute_of(Criterion of);

/// Searches in whole layers, sets the attributes stress_max_…, with the error of a maximum at an edge, and
/// warns of one that the grid does not resolve or that may lie outside. Of several ranks the first searches,
/// and holds the whole pressure for it.
StressMaximum find_maximum(const Tool& tool, StressScene& scene, const StressSearch& search);

/// The largest stress of each layer and its place, the table of --result maxima; warns as find_maximum does.
Table maxima_of(const Tool& tool, const StressOptions& options, const StressScene& scene);

// ---- errors of the grid, from the contact that loads the body on coarser cells ----

/// The contact whose pressure the dataset holds. Throws ParameterError("add", …) where the dataset lacks what
/// is needed to solve it again.
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
