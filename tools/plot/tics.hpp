/// Numbers beside an axis, so many that none touches the next.
///
/// Along an axis 0.9 em are left between numbers, and 1.8 em from line to line across it. Logarithmic axes
/// have powers of ten, or 1, 2, 5 times them where the axis is shorter than two decades.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tools/plot/figure.hpp"
#include "tools/plot/text.hpp"

namespace asperity::plot {

struct Tic {
  double at;
  std::string text;
};
using Tics = std::vector<Tic>;

/// The multiples of a step, with so many digits that no two read alike.
Tics tics_at(Range range, double step);
/// The same, or where only one lies in the range, of the next finer step of 1, 2, 3, 4, 5, 6, 8 × 10ⁿ that
/// has two: one number gives no scale. The step is no finer than this part of the range.
Tics two_at_least(Range range, double step, double least);
/// For an axis of this length [em], read along it (x) or line below line (y). Their range is that drawn.
Tics tics_along(const Axis& axis, double length);
Tics tics_across(const Axis& axis, double height);

double longest(const Tics& tics);  ///< [em]
/// By how much the outermost numbers of an x axis of this length stick out beyond its ends [em].
struct Overhang {
  double left = 0, right = 0;
};
Overhang overhang(const Axis& axis, double length);

/// "set xtics (…)"
std::string command(std::string_view axis, const Tics& tics);

}  // namespace asperity::plot
