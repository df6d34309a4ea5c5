/// Does a surface that is marked periodic continue at its opposite edge?
///
/// With d(i) the rms step from line i to the next, over the points of a line, and d(N-1) that from the last
/// line to the first, the surface jumps at its seam where
///     d(N-1) > 2 max d(i),   0 ≤ i < N-1.                                                            (1)
/// A surface of the period has no first line: its seam is one of N steps like the others, whatever its
/// texture, lay or spikes. A trend or a part of a larger surface has a step that no other comes near.
///
/// Symbols   N lines across the axis
/// Scope     16 lines and more, of fewer nothing is told. One tooth of a saw a period is a jump too.
/// Accuracy  noise of one point a line, the worst case, is taken for a jump in 1 of 1000 at 16 lines, and
///           less often on more.
/// Cost      one pass.
#pragma once

#include <array>

#include "core/field.hpp"

namespace asperity {

struct Seam {
  double step = 0, largest = 0;  ///< d(N-1), and the largest of the others, in the unit of the heights
  bool jumps() const { return step > 2 * largest; }
};

/// Across x and across y; zeros along an axis that is free or has too few lines.
std::array<Seam, 2> seams(const Field& heights, Periodic periodic);

}  // namespace asperity
