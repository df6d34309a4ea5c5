/// Plastic flow below a contact, for its page (tools/contact/plasticity.hpp).
///
/// The residual stress is that of the strain alone: what stays where the load is taken off elastically.
#pragma once

#include <string>
#include <vector>

#include "tools/cli/tool.hpp"
#include "tools/plot/figure.hpp"

namespace asperity::report {

/// A volume on (layer, x, y), and its largest value among the middles of layers and cells.
struct FlowVolume {
  std::string words, unit, variable = {};
  double largest = 0, depth = 0;  ///< depth [m]
  std::string section = {};       ///< through it
};

struct Flow {
  plot::Cases dataset = {};  ///< one, of the volumes alone
  std::vector<double> depths = {};
  std::vector<FlowVolume> volumes = {};
  std::string unknown = {};  ///< why some are missing, in a sentence
};

/// Equivalent plastic strain and residual von Mises stress of each body that has flown; nothing of others.
Flow flow_of(const cli::Tool& tool, const Dataset& data);

}  // namespace asperity::report
