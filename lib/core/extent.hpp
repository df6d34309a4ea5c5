/// Extent of something on a grid: the lines from the first to the last with any of it; along a periodic
/// axis the shortest run of lines with all of it, which may continue across the edge.
#pragma once

#include <array>

#include "core/field.hpp"

namespace asperity {

/// The place on a torus of n lines: i modulo n, from 0 to n - 1.
inline Index wrapped(Index i, Index n) { return (i % n + n) % n; }

/// A run of lines of one axis.
struct Extent {
  Index first = 0, count = 0;

  Index end() const { return first + count; }
  bool operator==(const Extent&) const = default;
};

using LineMask = Eigen::Array<bool, Eigen::Dynamic, 1>;

/// From the first to the last marked line.
inline Extent extent(const LineMask& marked, bool periodic) {
  Index first = -1, last = -1, gap = 0, after_gap = 0;
  for (Index k = 0; k < marked.size(); ++k) {
    if (!marked(k)) continue;
    if (first < 0) first = k;
    if (last >= 0 && k - last - 1 > gap) gap = k - last - 1, after_gap = k;
    last = k;
  }
  if (last < 0) return {};
  const Extent inside{first, last - first + 1}, around{after_gap, marked.size() - gap};
  return periodic && around.count < inside.count ? around : inside;
}

/// Along x and along y, for the cells with holds(value).
template <class Holds>
std::array<Extent, 2> extents(const Field& f, Holds holds, Periodic periodic = {}) {
  LineMask in_x = LineMask::Constant(f.rows(), false), in_y = LineMask::Constant(f.cols(), false);
  for (Index i = 0; i < f.rows(); ++i) {
    bool any = false;
    for (Index j = 0; j < f.cols(); ++j) {
      const bool held = holds(f(i, j));
      any |= held;
      in_y(j) |= held;
    }
    in_x(i) = any;
  }
  return {extent(in_x, periodic.x), extent(in_y, periodic.y)};
}

}  // namespace asperity
