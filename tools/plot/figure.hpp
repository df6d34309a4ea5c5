/// Description of a figure: panels of one size in rows and columns, with one title, legend and colour bar.
///
/// All positions are in units of the em, the height of the letters (plot/layout.hpp).
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "stats/feature/features.hpp"
#include "tools/cli/section.hpp"
#include "tools/plot/gnuplot.hpp"
#include "tools/plot/scale.hpp"

namespace asperity {
class Sample;
}

namespace asperity::plot {

// ---- the request and its data ----

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Request {
  std::string kind;
  std::string variable;                                        ///< empty: the default of the kind
  std::string section;                                         ///< "y=0", "x=0.1mm"; empty: the default
  Range x{-unlimited, unlimited}, y = x, depth{0, unlimited};  ///< what is shown [m]
  std::string range;                                           ///< of values, as typed; empty: from the data
  bool scale_by_hertz = false;                                 ///< stresses in units of p0
  cli::StressBound above;                                      ///< least value shown
  Pruning pruning = {};                                        ///< of features
  bool scale_bar = false;                                      ///< in place of the axes of a map
  bool titled = false;                                         ///< `title` was given
  std::string title;
  int columns = 0;        ///< of panels; 0: all panels in one row
  Shape pixels;           ///< 0 × 0: chosen to fit the figure
  Index most_blocks = 0;  ///< of a map along a side; 0: as many as there are pixels
  std::string format;     ///< "png", "svg" or "pdf"

  std::string variable_or(const char* own) const { return variable.empty() ? own : variable; }
};

/// A dataset and its name in a comparison.
struct Case {
  Dataset data;
  std::string label;
  std::shared_ptr<const Sample> sample = nullptr;  ///< of a field that is measured already
};
using Cases = std::vector<Case>;

// ---- parts of a figure ----

struct Axis {
  Range range;
  std::string label;
  bool downwards = false, logarithmic = false;
  double unit = 1;        ///< in SI, by which the range is divided
  std::string note = {};  ///< in small letters below the label, of this panel alone: "y × 6"
  std::string bar = {};   ///< a unit: in place of numbers and label stands a bar of a round length below x
};
/// What of its range can be drawn.
inline Range drawn(const Axis& axis) { return axis.logarithmic ? axis.range : drawable(axis.range); }
/// The axis of a range in SI: "height [µm]".
inline Axis axis_of(Range range, const Unit& unit, std::string_view quantity) {
  return {.range = range / unit.factor, .label = unit.label(quantity), .unit = unit.factor};
}

/// The sizes of symbols are multiples of `dot`, one em, in scripts: "pointsize 0.4*dot".
struct Panel {
  std::string label = {};              ///< of its case, in a comparison
  std::optional<Axis> x = {}, y = {};  ///< of plane plots; axes in space are commands
  Script commands = {};                ///< before the layers
  std::vector<Layer> layers = {};
};

struct LegendEntry {
  enum class Key { line, dashes, box, hatch, circle, dot };
  Key key;
  std::string colour, name;
};

/// Colours of values divided by the unit's factor, and their bar; without a name no bar is drawn.
struct ColourBar {
  Colours colours;
  Unit unit;
  std::string name;
};

struct Figure {
  std::string title = {};  ///< used if the request has none
  std::vector<Panel> panels = {};
  std::size_t columns = 1;
  bool comparison = false;  ///< one panel per case with its label; neighbours share the labels of like axes
  bool in_space = false;    ///< seen in perspective
  double aspect = 0;        ///< height over width of a panel; 0: any
  double left = 5.2, right = 1.2, bottom = 4.0, top = 0.8;  ///< margins around the panels [em]
  double gap_x = 1.4, gap_y = 1.4;                          ///< between panels [em]
  std::vector<LegendEntry> legend = {};                     ///< above the panels
  std::optional<ColourBar> colours = {};
  Script commands = {};                 ///< before the first panel
  std::vector<std::string> notes = {};  ///< what the user is told beside the picture
};

/// One panel per case, in the requested number of columns.
Figure side_by_side(const Request& request, const Cases& cases);

/// Bounds of the aspect of a panel with equal scales; beyond them one axis is stretched, and a note below x
/// says so, which is there whatever the title.
inline constexpr double flattest = 0.16, tallest = 2.5;

Script script_of(const Figure& figure, const Request& request);

/// Hatches in grey, which no palette has, what the images of all panels leave uncovered, and says so above.
void show_missing(Figure& figure);
/// The colour of line k; hue and lightness differ, so that colour-blind readers can tell lines apart.
const char* line_colour(std::size_t k);

// ---- kinds of figures ----

/// A field in false colours, scales equal along x and y; several cases share their colours. Where a panel has
/// fewer pixels than points, they show means of blocks of points, and a note says so.
Figure map(const Cases& cases, const Request& request);
/// The map with the hills of the heights, pruned, and their peaks.
Figure features(const Cases& cases, const Request& request);
/// The contact state: open, elastic, at the limit pressure; of a block the largest, lest a contact disappear.
Figure contact(const Cases& cases, const Request& request);
/// A field in perspective, with heights enlarged by a round factor that the title states.
Figure surface(const Cases& cases, const Request& request);
/// A field along x and along y; several cases share the axes.
Figure profile(const Cases& cases, const Request& request);
/// Both profile autocorrelations: the target, the kernel's, the surface's with two standard errors.
Figure acf(const Cases& cases, const Request& request);
/// The histogram of the heights with standard errors, and the Gaussian of the same mean and rms.
Figure pdf(const Cases& cases, const Request& request);
/// The material ratio curve with its 95 % intervals and the construction of Sk, Spk and Svk.
Figure abbott(const Cases& cases, const Request& request);
/// Spectra over rings and of profiles with their 95 % intervals, on logarithmic axes; several cases share
/// them. Points without an error are hollow.
Figure psd(const Cases& cases, const Request& request);
/// Heights against the quantiles of a Gaussian, with the band for heights that are Gaussian.
Figure qq(const Cases& cases, const Request& request);
/// Load over approach and area over load, from tables of loads; several share the axes.
Figure sweep(const Cases& cases, const Request& request);
/// The largest stress at each depth of a volume or a table; several cases share the axes.
Figure maxima(const Cases& cases, const Request& request);
/// A vertical section of a volume, depth downwards, with lines of equal value and a mark of the largest.
Figure section(const Cases& cases, const Request& request);

}  // namespace asperity::plot
