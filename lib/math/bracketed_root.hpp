/// Root of a continuous function between two points where its signs differ.
///
/// Bisection, or inverse quadratic interpolation wherever the three last points let it be trusted: Brent's
/// idea with Chandrupatla's criterion. It ends when the function is within `tolerance` of zero or the bracket
/// has shrunk to rounding, after 6 to 12 values of a smooth function.
///
/// T. R. Chandrupatla, A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear
/// function without using derivatives, Adv. Eng. Softw. 28 (1997) 145-149.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

struct CurvePoint {
  double x, f;
};

/// Where the next point is taken, as a fraction of the way from a to b, c being the point before.
inline double next_fraction(CurvePoint a, CurvePoint b, CurvePoint c) {
  const double xi = (a.x - b.x) / (c.x - b.x), phi = (a.f - b.f) / (c.f - b.f);
  if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) return 0.5;
  return a.f / (b.f - a.f) * c.f / (b.f - c.f) +
         (c.x - a.x) / (b.x - a.x) * a.f / (c.f - a.f) * b.f / (c.f - b.f);
}

template <class Function>
double bracketed_root(Function f, CurvePoint a, CurvePoint b, double tolerance) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double fraction = 0.5;
  for (int i = 0; i < 200; ++i) {
    const CurvePoint best = std::abs(a.f) < std::abs(b.f) ? a : b;
    const double finest = 2 * epsilon * std::abs(best.x) / std::abs(b.x - a.x);
    if (std::abs(best.f) <= tolerance || !(finest < 0.5)) return best.x;
    fraction = std::clamp(fraction, finest, 1 - finest);
    const double x = a.x + fraction * (b.x - a.x);
    const CurvePoint next{x, f(x)};
    CurvePoint former = a;
    if ((next.f > 0) != (a.f > 0)) {
      former = b;
      b = a;
    }
    a = next;
    fraction = next_fraction(a, b, former);
  }
  return a.x;
}

}  // namespace asperity
