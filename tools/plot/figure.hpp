/// The sheet that a figure is drawn on: panels of one size in rows and columns, a title, a colour bar.
///
/// Everything is placed here, in units of the em, the height of the letters: no label depends on what gnuplot
/// makes room for. The em is the width over 32, 46, 60 for one, two, three columns of panels, and 0.25 cm of a PDF:
/// letters of 7 pt where the figure is printed 8, 11.5, 15 cm wide.
#pragma once

#include <string>
#include <vector>

#include "tools/plot/gnuplot.hpp"
#include "tools/plot/request.hpp"
#include "tools/plot/scale.hpp"

namespace asperity::plot {

struct LegendEntry {
  enum class Key { line, dashes, box };
  Key key;
  std::string colour, name;
};

struct Sheet {
  std::size_t panels = 1, columns = 1;
  bool comparison = false;  ///< a panel a case: each has its name, neighbours share their axes
  double aspect = 0;        ///< height over width of a panel; 0: any
  double left = 5.2, right = 1.2, bottom = 4.0, top = 0.8;  ///< margins around the panels [em]
  double gap_x = 1.4, gap_y = 1.4;                          ///< between panels [em]
  std::vector<LegendEntry> legend = {};                     ///< above the panels
};

/// A panel a case, in as many columns as the request says.
Sheet side_by_side(const Request& request, std::size_t cases);

/// How flat a panel of equal scales along both axes may be; beyond, the scales part and the figure says so.
inline constexpr double flattest = 0.16, tallest = 2.5;

class Figure {
 public:
  Figure(const Request& request, Sheet sheet, const std::string& title);

  /// The next commands draw this panel, counted by rows from the top left.
  void panel(std::size_t number, const std::string& label = "");
  // In a comparison only the lowest panels name their x axis, only those on the left their y axis.
  void x_axis(Range range, const std::string& label);
  void y_axis(Range range, const std::string& label, bool downwards = false);
  /// Colours for values divided by the unit's factor; the bar is drawn with the last panel.
  void colours(const Colours& colours, const Unit& unit, const std::string& quantity);

  /// The sheet's legend, once, in as many lines as it takes.
  void legend();

  double em_wide() const { return panel_width_ / em_; }  ///< of a panel [em]
  double em_high() const { return panel_height_ / em_; }
  double panel_aspect() const { return panel_height_ / panel_width_; }
  const Shape& pixels() const { return pixels_; }

  Script script;

 private:
  void fit(const Request& request);
  std::string terminal(const std::string& format) const;
  void begin(const std::string& format);
  void colour_bar(Range shown, const Unit& unit, const std::string& quantity);
  void legend_key(const LegendEntry& entry, double x, double y);
  void legend_line(const std::vector<LegendEntry>& entries, double y);
  double legend_height() const;
  bool is_last() const { return panel_ + 1 == sheet_.panels; }
  double columns() const { return static_cast<double>(sheet_.columns); }
  double rows() const { return static_cast<double>(rows_); }
  double panels_wide() const { return columns() * (panel_width_ + sheet_.gap_x * em_) - sheet_.gap_x * em_; }
  double panels_high() const { return rows() * (panel_height_ + sheet_.gap_y * em_) - sheet_.gap_y * em_; }
  double screen_x(double px) const { return px / static_cast<double>(pixels_.nx); }
  double screen_y(double px) const { return px / static_cast<double>(pixels_.ny); }

  Sheet sheet_;
  std::size_t rows_, panel_ = 0;  ///< how many, and the present one
  std::vector<std::vector<LegendEntry>> legend_lines_;
  std::string title_;
  Shape pixels_;
  double em_ = 0, panel_width_ = 0, panel_height_ = 0, left_ = 0, bottom_ = 0, panel_x_ = 0, panel_y_ = 0;
};

/// Colours of lines, apart in hue and lightness for every kind of eyes; the k-th of a comparison.
const char* line_colour(std::size_t k);

/// The title given, or else this one.
std::string title_or(const Request& request, const std::string& otherwise);

}  // namespace asperity::plot
