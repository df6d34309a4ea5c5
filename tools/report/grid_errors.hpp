/// The errors of the grid that a dataset lacks, computed for its page.
#pragma once

#include <string>

#include "dataset/dataset.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::report {

/// Why there are none: sentences, empty where they are known or nothing has them.
struct NoGridErrors {
  std::string contact, stress;
};

/// Sets the attributes that asperity-contact and asperity-stress would with --add grid_errors, as far as the
/// contact can be solved again on coarser cells.
NoGridErrors add_grid_errors(const cli::Tool& tool, Dataset& data);

}  // namespace asperity::report
