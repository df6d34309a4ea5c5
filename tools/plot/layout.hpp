/// Positions of the parts of a figure on its sheet [pixel].
///
/// The em is the width divided by 32, 46, 60 for one, two, three columns of panels, and 0.25 cm in a PDF:
/// letters are 7 pt in print 8, 11.5, 15 cm wide.
#pragma once

#include "tools/plot/figure.hpp"

namespace asperity::plot {

using LegendLine = std::vector<LegendEntry>;
// [em]
inline constexpr double key_length = 2.0, legend_gap = 1.6, line_of_legend = 2.0, line_of_title = 2.0,
                        label_height = 1.5, below_axis = 3.2, below_bar = 1.0, line_of_note = 1.3,
                        small = 0.86;
/// Length of an entry, and of a line of entries [em].
double length_of(const LegendEntry& entry);
double length_of(const LegendLine& line);

struct Layout {
  std::vector<std::string> title;  ///< lines
  std::vector<LegendLine> legend;
  std::size_t rows, columns;
  double margin;  ///< left of the panels, with room for the longest number of y [em]
  Shape pixels;   ///< of the sheet
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

/// The height of a colour bar, as high as the panels but always legible, and the step of its numbers.
double bar_height(const Layout& layout);
double bar_step(const Layout& layout, Range shown);

/// Whether a panel has numbers and a label of its own: in a comparison it borrows those of x from the panel
/// below and those of y from the panel on its left, if there is one with the same range and label.
bool labels_x(const Figure& figure, std::size_t panel);
bool labels_y(const Figure& figure, std::size_t panel);

/// Adds to the small note below x, or to the label above the panel where x has none. The axes of all panels
/// are there.
void add_note(Figure& figure, std::size_t panel, const std::string& text);
/// Notes by how much an axis of a panel is longer than the scale of the other says: "y × 6".
void tell_stretch(Figure& figure, std::size_t panel, double true_aspect, const char* along, const char* up);

/// Titles of more than two lines and legends of more than three are shortened.
///
/// Panels as large as the sheet allows; narrower and centred if they would be too high. Throws
/// ParameterError("pixels", …) if there is no room for them.
Layout layout_of(const Figure& figure, const Request& request);

}  // namespace asperity::plot
