/// The loaded body that asperity-stress looks into: what was read, and what the options make of it.
#pragma once

#include <optional>

#include "dataset/dataset.hpp"
#include "stress/layers.hpp"
#include "tools/stress/options.hpp"

namespace asperity::cli {

struct StressScene {
  Dataset data;  ///< to be amended
  LoadedBody body;
  std::vector<double> depths;  ///< [m]; none: no layers are asked for
  std::optional<Plane> plane;  ///< of a section
  double least = 0;            ///< values of less are left out [Pa]
  DepthResolution resolution = DepthResolution::adapted;
};

/// The coordinate of a plane [m].
double place_of(const Plane& plane, const Grid& grid);

/// Throws ParameterError when the options do not go with the dataset.
StressScene read_scene(const Tool& tool, const StressOptions& options);

/// The effective parameters, as attributes.
void record_parameters(StressScene& scene);

/// That this largest von Mises stress [Pa] is above the yield stress, where the contact had a limit pressure.
void warn_of_yield(const Tool& tool, const StressScene& scene, double von_mises);

}  // namespace asperity::cli
