/// What asperity-contact leaves of a solution: attributes and fields of a dataset, or a row of a table.
#pragma once

#include "tools/cli/table.hpp"
#include "tools/contact/scene.hpp"

namespace asperity::cli {

/// The effective parameters, the result and its fields, in place of any former ones.
void record(ContactScene& scene, const ContactOptions& options, const Contact& contact);

/// The table of a sweep, its rows to come, and the row of a load.
Table load_table();
std::vector<Cell> load_row(const Contact& contact);

}  // namespace asperity::cli
