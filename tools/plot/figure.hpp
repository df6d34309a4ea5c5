/// A figure as it is described: panels of one size in rows and columns under one title, with one legend and
/// one colour bar.
///
/// Everything is placed in units of the em, the height of the letters (plot/layout.hpp).
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "tools/cli/section.hpp"
#include "tools/plot/gnuplot.hpp"
#include "tools/plot/scale.hpp"

namespace asperity::plot {

// ---- what is asked of a figure, and what it is drawn from ----

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Request {
  std::string kind;
  std::string variable;                                        ///< empty: what the kind draws of itself
  std::string section;                                         ///< "y=0", "x=0.1mm"; empty: the kind's own
  Range x{-unlimited, unlimited}, y = x, depth{0, unlimited};  ///< what is shown [m]
  std::string range;                                           ///< of values, as typed; empty: of the data
  bool scale_by_hertz = false;                                 ///< stresses in units of p0
  cli::StressBound above;                                      ///< least value shown
  bool titled = false;                                         ///< `title` was given
  std::string title;
  int columns = 0;     ///< of panels, where there are several; 0: as many as panels
  Shape pixels;        ///< 0 × 0: what suits the figure
  std::string format;  ///< "png", "svg" or "pdf"

  std::string variable_or(const char* own) const { return variable.empty() ? own : variable; }
};

/// A dataset and its name in a comparison.
struct Case {
  Dataset data;
  std::string label;
};
using Cases = std::vector<Case>;

// ---- what it is made of ----

struct Axis {
  Range range;
  std::string label;
  bool downwards = false;
};
/// Of a range in SI: "height [µm]".
inline Axis axis_of(Range range, const Unit& unit, std::string_view quantity) {
  return {range / unit.factor, unit.label(quantity)};
}

struct Panel {
  std::string label = {};              ///< of its case, in a comparison
  std::optional<Axis> x = {}, y = {};  ///< on paper; those in space are commands
  Script commands = {};                ///< before what is drawn
  std::vector<Layer> layers = {};
};

struct LegendEntry {
  enum class Key { line, dashes, box };
  Key key;
  std::string colour, name;
};

/// Colours of values divided by the unit's factor, and their bar, unless it has no name.
struct ColourBar {
  Colours colours;
  Unit unit;
  std::string name;
};

struct Figure {
  std::string title = {};  ///< unless the request has one
  std::vector<Panel> panels = {};
  std::size_t columns = 1;
  bool comparison = false;  ///< a panel a case: each has its name, neighbours share their axes
  bool in_space = false;    ///< seen in perspective
  double aspect = 0;        ///< height over width of a panel; 0: any
  double left = 5.2, right = 1.2, bottom = 4.0, top = 0.8;  ///< margins around the panels [em]
  double gap_x = 1.4, gap_y = 1.4;                          ///< between panels [em]
  std::vector<LegendEntry> legend = {};                     ///< above the panels
  std::optional<ColourBar> colours = {};
  Script commands = {};  ///< before the first panel
};

/// A panel a case, in as many columns as the request says.
Figure side_by_side(const Request& request, const Cases& cases);

/// How flat a panel of equal scales along both axes may be; beyond, the scales part and the figure says so.
inline constexpr double flattest = 0.16, tallest = 2.5;

Script script_of(const Figure& figure, const Request& request);

/// Colours of lines, apart in hue and lightness for every kind of eyes; the k-th of a comparison.
const char* line_colour(std::size_t k);

// ---- the kinds of figures ----

/// A field in false colours, scales equal along x and y; several cases share their colours.
Figure map(const Cases& cases, const Request& request);
/// The contact state: open, elastic, at the limit pressure.
Figure contact(const Cases& cases, const Request& request);
/// A field in perspective, the heights enlarged by a round factor that is stated.
Figure surface(const Cases& cases, const Request& request);
/// A field along x and along y; several cases share the axes.
Figure profile(const Cases& cases, const Request& request);
/// Both profile autocorrelations: the target, the kernel's, the surface's with two standard errors.
Figure acf(const Cases& cases, const Request& request);
/// The histogram of the heights with standard errors, and the Gaussian of the same mean and rms.
Figure pdf(const Cases& cases, const Request& request);
/// A volume's field in a vertical section, depth downwards.
Figure section(const Cases& cases, const Request& request);

}  // namespace asperity::plot
