/// The bodies that asperity-contact presses together: what was read, and the gap before they touch.
#pragma once

#include "dataset/dataset.hpp"
#include "tools/contact/options.hpp"

namespace asperity::cli {

struct ContactScene {
  Dataset data;  ///< to be amended; its grid is the contact's
  Grid grid;
  Field gap;  ///< undeformed [m]
};

/// Reads the surfaces, if there are any. Throws ParameterError when the boundary that is asked for does not
/// go with them, DataError when the counter body lies on another grid.
ContactScene read_scene(const Tool& tool, const ContactOptions& options);

}  // namespace asperity::cli
