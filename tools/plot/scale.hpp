/// Scales of axes and colours: SI prefixes, round steps, ranges, palettes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "tools/cli/readable.hpp"

namespace asperity::plot {

struct Range {
  double low, high;

  double width() const { return high - low; }
  double magnitude() const;  ///< the larger of |low| and |high|
  bool contains(double v) const { return low <= v && v <= high; }
  Range operator/(double unit) const { return {low / unit, high / unit}; }
  bool operator==(const Range&) const = default;
};

/// The range of the values, without NaN; {0, 0} if all are NaN.
Range range_of(const Field& values);
Range united(Range a, Range b);

using cli::Unit;
/// Powers, angles and all but m, Pa and N stay SI.
inline Unit unit_for(double magnitude, const std::string& si_unit) {
  return cli::prefixed(magnitude, si_unit);
}

/// The smallest of 1, 2, 5 × 10ⁿ that divides the width into at most `most_steps` steps.
double round_step(double width, double most_steps);
/// A range that can be drawn: if narrower than 1e-13 of its magnitude, it is widened by 5 % either way.
/// Throws DataError("picture", …) for values beyond 1e300.
Range drawable(Range range);
/// The multiples of `step` in a range; none if there are more than a thousand.
std::vector<double> multiples(Range range, double step);
/// A number to three digits: "2.72", "6090", "1.2·10⁻⁷".
std::string brief(double value);

/// Colours from low to high. Sequential is viridis, at eleven of its 256 colours with straight lines between:
/// its lightness rises evenly, so that equal differences look equal, a grey print keeps their order, and
/// readers who do not tell red from green see it too. Heights have it, for their zero is a choice; in grey a
/// diverging palette would show hills as dales. Stresses that push or pull have a zero that matters: they
/// keep a diverging palette, ours, whose L* falls by the same amount from the middle to either end.
///
/// S. van der Walt, N. Smith, A better default colormap for Matplotlib, SciPy 2015 (viridis, CC0).
/// CIE 15:2004, Colorimetry; P. Kovesi, Good colour maps: how to design them, arXiv:1509.03700 (2015).
enum class Palette { sequential, diverging };
const std::vector<std::string>& control_colours(Palette palette);

/// How values become colours.
struct Colours {
  Range range{0, 1};  ///< in SI
  Palette palette = Palette::sequential;
  std::string words = {};  ///< of a range that does not hold all values: ", 0.5 to 99.5 %"
};
/// From the least value to the largest, from zero upwards if the least is near, or evenly about zero.
Colours sequential(Range values);
Colours one_sided(Range values);
Colours about_zero(Range values);

}  // namespace asperity::plot
