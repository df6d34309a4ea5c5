/// The largest stresses a few cells deep, searched only in tiles that may hold them.
///
/// Near the surface, stress comes mostly from neighbouring cells. The kernel is split [1],
///     K = w K + (1 - w) K,   w = 1 up to 6 cells off along each axis, then down to 0 at 16 as cos²,    (1)
/// and the second part, which is smooth, is taken from wide cells (stress/kernel_split.hpp).
///
/// A tile of 32 × 32 cells bears nowhere at depth z more than
///     f(far + m U) + (M - m) B,   m ≤ p ≤ M within 15 cells of it,                                     (2)
/// f the criterion, f(a + b) ≤ f(a) + f(b); U the stress under the whole of w K, and B the largest f of any
/// pattern of loads 0 and 1 under w K: there the pattern is the cells whose K : ∂f/∂σ is positive. (For ν =
/// 0.3 without friction B is 0.64 to 0.69, a disc.) Tiles are taken in the falling order of (2); all six
/// components come from one convolution of 64 × 64 cells, and the tiles and depths whose bound is below the
/// largest value found are left out.
///
/// Scope     cells not longer than twice their width, at least 64 along each side; along an axis on which
///           the load repeats a multiple of four. A load that repeats along both axes is a sum of waves: at
///           the depths of the far part, waves through wide cells miss the steps of w K by 3 % of a step.
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
  /// From which depth on layers of wider cells take over [m].
  static double deepest(const Grid& grid);

  /// All local maxima at these depths, rising, above deepest(), from which a refinement may lead above the
  /// largest value here and above `known` (least_start).
  static std::vector<LayerMaximum> maxima(const LoadedBody& body, Criterion of,
                                          const std::vector<double>& depths, double known, int threads);
};

}  // namespace asperity
