/// Lines of equal value over an image, by gnuplot's contours of the same cells, with straight lines between
/// their centres. They stand at the multiples of a step that lie within the range of the values.
#pragma once

#include <vector>

#include "tools/plot/gnuplot.hpp"
#include "tools/plot/scale.hpp"

namespace asperity::plot {

struct Isolines {
  Script commands = {};            ///< find the lines, before the panel is drawn
  std::vector<Layer> layers = {};  ///< draw them; none where no multiple lies within
};
Isolines isolines(const Field& cells, const Lattice& at, double step);

}  // namespace asperity::plot
