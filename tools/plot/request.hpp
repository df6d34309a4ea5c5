/// What is asked of a figure, and what it is drawn from.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "tools/plot/scale.hpp"

namespace asperity::plot {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Request {
  std::string kind;
  std::string variable;                                        ///< empty: what the kind draws of itself
  std::string section;                                         ///< "y=0", "x=0.1mm"; empty: the kind's own
  Range x{-unlimited, unlimited}, y = x, depth{0, unlimited};  ///< what is shown [m]
  std::string range;                                           ///< of values, as typed; empty: of the data
  bool scale_by_hertz = false;                                 ///< stresses in units of p0
  double above = std::numeric_limits<double>::quiet_NaN();     ///< least value shown, share of p0 or maximum
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

}  // namespace asperity::plot
