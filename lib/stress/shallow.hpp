/// The largest stresses a few cells deep, looked for only where they may lie.
///
/// What a cell is under near the surface is mostly the work of the cells about it. The kernel is split [1],
///     K = w K + (1 - w) K,   w = 1 up to 6 cells off along each axis, then down to 0 at 16 as cos²,
///     (1)
/// and the second part, being smooth, is that of cells four times as long and wide under their mean pressure,
/// less w K of those, at the depths 4, 8 and 12 Δ; between and above them a parabola in z.
///
/// A tile of 32 × 32 cells bears nowhere at depth z more than
///     f(far + m U) + (M - m) B,   m ≤ p ≤ M within 15 cells of it,
///     (2)
/// f the criterion, which no sum of stresses exceeds the sum of; U the stress under the whole of w K, and B
/// the largest f of any pattern of loads 0 and 1 under w K: that at which the pattern is the cells whose
/// K : ∂f/∂σ is positive. (Of ν = 0.3 and no friction B is 0.64 to 0.69, a disc.) Tiles are taken in the
/// order
/// of (2); all six components come from one convolution of 64 × 64 cells, and the tiles and depths whose
/// bound is below the largest value found are left out.
///
/// Scope     cells not longer than twice their width, at least 64 along each side, and where they repeat a
///           multiple of four.
/// Accuracy  of far about 1 % of the largest pressure; values are starts of stress/peak.hpp.
/// Cost      1.1 µs a cell for a tile at all depths; the far part three layers of a 16th of the cells.
///
/// [1] A. Brandt, A. A. Lubrecht, Multilevel matrix multiplication and fast solution of integral equations,
///     J. Comp. Physics 90 (1990) 348-370.
#pragma once

#include "stress/layer_maxima.hpp"

namespace asperity {

class ShallowSearch {
 public:
  static bool possible(const Grid& grid);
  /// Above it whole layers are as good [m]: there the waves of a load periodic in both directions are not the
  /// steps of its cells.
  static double shallowest(const Grid& grid);
  /// From which depth on layers of wider cells take over [m].
  static double deepest(const Grid& grid);

  /// All local maxima at these depths, rising, above deepest(), from which a refinement may lead above the
  /// largest value here and above `known` (least_start).
  static std::vector<LayerMaximum> maxima(const LoadedBody& body, Criterion of,
                                          const std::vector<double>& depths, double known, int threads);
};

}  // namespace asperity
