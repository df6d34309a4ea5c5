/// What --add gives beyond the solution: numbers for attributes and the table of a sweep, and patches.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/contact/resolution.hpp"

namespace asperity::cli {

struct Figure {
  std::string name;  ///< of its column; its attribute is contact_name
  std::string unit;
  double value;
  bool of_load = true;               ///< varies with the load; the others are the scene's
  std::optional<double> error = {};  ///< of the grid, NaN where not known; of a figure that may have one
};
using Figures = std::vector<Figure>;

/// Of the rough gap [m], a difference of values up to `largest`: what its size and shape do not allow is
/// unknown.
GapRoughness roughness_of(const Field& rough_gap, const Grid& grid, int threads, double largest = 0);

/// The requested figures that are defined in the scene: the same ones for each load.
Figures figures(const ContactScene& scene, const ContactOptions& options, const Contact& contact,
                const GridFigures& grid);

/// label(x, y) and patch_area(patch).
void record_patches(Dataset& data, const Grid& grid, const Contact& contact);

}  // namespace asperity::cli
