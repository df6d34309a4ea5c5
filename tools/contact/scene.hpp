/// What asperity-contact presses together, and what it leaves of a solution: attributes and fields, or a row.
#pragma once

#include "dataset/dataset.hpp"
#include "tools/cli/table.hpp"
#include "tools/contact/options.hpp"

namespace asperity::cli {

struct ContactScene {
  Dataset data;  ///< to be amended; its grid is the contact's
  Grid grid;
  Field gap;  ///< undeformed [m]
};

/// Reads the surfaces, if there are any. Throws ParameterError when the requested boundary does not
/// go with them, DataError when the counter body lies on another grid.
ContactScene read_scene(const Tool& tool, const ContactOptions& options);

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact);

/// The table of a sweep, its rows to come, and the row of a load.
Table load_table();
std::vector<Cell> load_row(const Contact& contact);

}  // namespace asperity::cli
