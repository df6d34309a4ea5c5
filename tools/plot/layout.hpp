/// Where the parts of a figure stand on its sheet [pixel].
///
/// The em is the width over 32, 46, 60 for one, two, three columns of panels, and 0.25 cm of a PDF: letters
/// of 7 pt in print 8, 11.5, 15 cm wide.
#pragma once

#include "tools/plot/figure.hpp"

namespace asperity::plot {

using LegendLine = std::vector<LegendEntry>;
inline constexpr double key_length = 2.0, legend_gap = 1.6, line_of_legend = 2.0, label_height = 1.5;  // [em]
/// Of an entry, and of a line of them [em].
double length_of(const LegendEntry& entry);
double length_of(const LegendLine& line);

struct Layout {
  std::string title;
  std::vector<LegendLine> legend;
  std::size_t rows, columns;
  Shape pixels;  ///< of the sheet
  double em;
  double panel_width, panel_height;
  double left, bottom;    ///< of the lowest panel on the left
  double step_x, step_y;  ///< from panel to panel
  double panels_wide, panels_high;

  double x_of(std::size_t panel) const { return left + static_cast<double>(panel % columns) * step_x; }
  double y_of(std::size_t panel) const {
    return bottom + static_cast<double>(rows - 1 - panel / columns) * step_y;
  }
};

/// Panels as large as the sheet allows; where they are too high for it, narrower and centred. Throws
/// ParameterError("pixels", …) where they have no room.
Layout layout_of(const Figure& figure, const Request& request);

}  // namespace asperity::plot
