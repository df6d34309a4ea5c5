/// The error that the grid leaves of a largest stress, from the contact that loads the body on coarser cells.
#pragma once

#include "stress/maximum.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::cli {

/// What the dataset tells of the contact whose pressure it holds; throws ParameterError("add", …) where that
/// is not enough to solve it again.
struct LoadingContact {
  Field gap;             ///< undeformed, counted from the approach [m]
  double modulus = 0;    ///< E* [Pa]
  double limit = 0;      ///< limit pressure [Pa]
  double load = 0;       ///< [N]
  bool resolved = true;  ///< the surface by its grid
};
LoadingContact loading_contact(const Dataset& data);

/// Sets stress_max_…_error and stress_max_depth_error, or warns why there are none.
void record_grid_errors(const Tool& tool, StressScene& scene, const LoadingContact& contact,
                        const StressSearch& search, const StressMaximum& maximum);

}  // namespace asperity::cli
