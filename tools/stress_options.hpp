/// What asperity-stress can be told.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "cli/tool.hpp"
#include "dataset/dataset.hpp"
#include "stress/layers.hpp"

namespace asperity::cli {

struct StressOptions {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double depth = none;
  int layers = 32;
  std::string spacing = "uniform", depths, components = "von_mises";
  double poisson = none, friction = 0;
  std::string friction_angle = "0deg";
  int body = 1;
  bool no_maximum = false;
  std::string resolution = "adapted";

  void declare(Tool& tool);

  // What the options mean for a dataset; ParameterError where they do not go with it.
  std::vector<double> depths_on(const Grid& grid) const;
  double poisson_of(const Dataset& data) const;
  Friction sliding() const;
  DepthResolution depth_resolution() const {
    return resolution == "full" ? DepthResolution::full : DepthResolution::adapted;
  }
};

}  // namespace asperity::cli
