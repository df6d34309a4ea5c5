/// The loaded body that asperity-stress looks into: what was read, and what the options make of it.
#pragma once

#include <optional>

#include "dataset/dataset.hpp"
#include "stress/section.hpp"
#include "tools/stress/options.hpp"

namespace asperity::cli {

struct StressScene {
  Dataset data;  ///< to be amended
  Grid grid;
  Field pressure;
  Friction friction;
  double poisson = 0;
  std::vector<double> depths;  ///< [m]; none: no layers are asked for
  std::optional<Plane> plane;  ///< of a section
  double least = 0;            ///< values of less are left out [Pa]

  StressSolver solver(const StressOptions& options, int threads) const {
    return {grid, pressure, friction, poisson, threads, options.depth_resolution()};
  }
};

/// The coordinate of a plane [m].
double place_of(const Plane& plane, const Grid& grid);

/// Throws ParameterError when the options do not go with the dataset.
StressScene read_scene(const Tool& tool, const StressOptions& options);

}  // namespace asperity::cli
