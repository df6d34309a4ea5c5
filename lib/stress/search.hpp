/// The parts of the search for the largest stress (stress/maximum.hpp): the maxima of layers, from which it
/// may start; tiles near the surface; and the refinement at points of the field.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "core/extent.hpp"
#include "stress/maximum.hpp"
#include "stress/points.hpp"

namespace asperity {

// ---- local maxima of layers, also of wider cells ----
//
// At depth z the mean pressure over cells three times narrower than z is as good as the pressure itself: what
// it lacks has faded to exp(-3π), 1e-3 of it.

/// A place within a layer of cells [cells].
struct LayerPeak {
  double value = 0, u = 0, v = 0;  ///< u, v from the middle of the nine
};

/// Values f(p, q), p and q of -1, 0, 1, the middle one the largest.
using Nine = std::array<std::array<double, 3>, 3>;

/// The vertex of the quadratic through the nine, with the mixed difference of the corners; that of the cross
/// where it has no vertex within a cell.
LayerPeak peak_of_nine(const Nine& f);
/// The vertices of the parabolas along both axes: those change steadily with the values.
LayerPeak peak_of_cross(const Nine& f);

/// A local maximum of a layer, between its centres.
struct LayerMaximum {
  double value = 0, x = 0, y = 0, z = 0;
  double dx = 0, dy = 0;  ///< spacing of the layer's points [m]
  Index i = 0, j = 0;     ///< place in its field
  double rise = 0;        ///< by which a parabola through the layers above and below exceeds it
};

/// The ratio of the scan's depths, and how many sides of a wide cell its depth must be: `maximum` and `depth`
/// of validation/stress_error_time, tests/stress/maximum.cpp.
inline constexpr double scan_ratio = std::numbers::sqrt2, wide_cell_depth = 3;

/// Whether the field shows the steps between the cells, so that its values at their centres alone count.
bool at_centres(const Grid& grid, double z);

/// The least value at depth z, of layers of these cells, from which a maximum may lie above `top`. Parabolas
/// give the values between two layers to 3 % (of the largest tension, which has creases, 15 %), and those
/// between the points of a layer, a times its depth apart, to 10 a² %.
double least_start(Criterion of, const Grid& cells, double z, double top);

/// A body of cells sx × sy as wide under their mean pressure; outside a free domain nothing acts. Its middle
/// is off that of the finer one by `shift`.
struct WiderCells {
  LoadedBody body;
  double shift_x = 0, shift_y = 0;
};
WiderCells wider_cells(const LoadedBody& body, Index sx, Index sy);

/// The local maxima among rows rows_from … rows_to - 1, columns likewise, of values at depth z that reach
/// `least`; of neighbours equal within 1e-9 the first.
void add_maxima(const Field& values, const Grid& grid, Index rows_from, Index rows_to, Index columns_from,
                Index columns_to, double least, double z, std::vector<LayerMaximum>& out);

/// The largest value of all, of values that ranks share by rows; across a free edge nothing changes.
LayerMaximum largest_of(const Field& own, const Grid& grid, const Slabs& rows, double z);

// ---- the influence of a cell near the surface in two parts, near and far: (1) of ShallowSearch ----
//
// The near part w K reaches 15 cells. The far part (1 - w) K is smooth: at four depths, at the middles of
// cells four times as long and wide, it is the layer below their mean pressures less what w K makes of the
// cells within 16; at other depths the cubic through the four.

/// w reaches this far [cells].
inline constexpr Index near_reach = 15;

struct NearKernel {
  /// For cells `s` times as wide as those of the body, for the lags -n … n, at depth z [m].
  NearKernel(const LoadedBody& body, Index s, Index n, double z);

  const stress::Tensor& at(Index i, Index j) const { return lags[size((n + i) * (2 * n + 1) + n + j)]; }
  /// Under a unit load everywhere.
  stress::Tensor sum() const;
  /// The largest value under any loads between 0 and 1: ascent from six states of stress, each step the loads
  /// whose K : ∂f/∂σ is positive. f being convex, a step never leads down.
  double largest(Criterion of) const;

  Index n;
  std::vector<stress::Tensor> lags;  ///< [2n+1][2n+1]
};

class FarStress {
 public:
  static constexpr Index wide = 4;
  using Weights = std::array<double, 4>;

  FarStress(const LoadedBody& body, int threads);

  Shape shape() const { return shape_of(layers_[0][0]); }
  /// Of the four layers, at depth z [m].
  Weights weights(double z) const;
  stress::Tensor at(const Weights& weights, Index i, Index j) const;

 private:
  Weights depths_;
  std::array<std::array<Field, 6>, 4> layers_;
};

// ---- near the surface ----

/// The largest stresses a few cells deep, searched only in tiles that may hold them.
///
/// Near the surface, stress comes mostly from neighbouring cells. The kernel is split [1],
///     K = w K + (1 - w) K,   w = 1 up to 6 cells off along each axis, then down to 0 at 16 as cos²,    (1)
/// and the second part, which is smooth, is taken from wide cells (FarStress).
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
/// Accuracy  of far about 1 % of the largest pressure; values are starts of PeakFinder.
/// Cost      1.1 µs a cell for a tile at all depths; the far part three layers of a 16th of the cells.
///
/// [1] A. Brandt, A. A. Lubrecht, Multilevel matrix multiplication and fast solution of integral equations,
///     J. Comp. Physics 90 (1990) 348-370.
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

// ---- at points of the field ----

/// A stress and its place [m].
struct StressPlace {
  double value = 0, x = 0, y = 0, z = 0;
};

/// The largest stress near a place that the scan of layers found, refined at points of the field.
///
/// About a place the field is that of a window of 24 × 24 cells, as wide as a third of the depth, with a
/// quadratic in x, y and z for what other cells add: it meets the field of stress/points.hpp at seven
/// points, 0.03 of the depth apart. Its maximum, found by steps to the highest of 26 neighbours, is the
/// next place, until the field there has the predicted value. Above the depth of one longer side of a cell
/// the field shows the steps of the pressure between the cells: there only the columns through the cells'
/// centres count, and places move from one to the next.
///
/// Accuracy  the value 1e-6 of the maximum to which it leads (tests/stress/shallow.cpp).
/// Cost      8 to 25 points of the field, some 600 of a window, 15 to 40 µs each.
class PeakFinder {
 public:
  /// The search ends above the depth `below` [m]. The body is kept by reference.
  PeakFinder(const LoadedBody& body, Criterion of, double below, int threads);

  /// The maximum about a place; or a lower value where that maximum will not exceed `goal`.
  StressPlace find(const StressPlace& from, double goal) const;
  /// From the one point of the field there: the field's value, and what the maximum about it may reach.
  struct Estimate {
    StressPlace at;
    double reaches = 0;
  };
  Estimate estimate(const StressPlace& from) const;

 private:
  class Model;
  bool varies_x() const { return !(body_.grid.periodic.x && body_.grid.shape.nx == 1); }
  bool varies_y() const { return !(body_.grid.periodic.y && body_.grid.shape.ny == 1); }
  StressPlace within(StressPlace place, bool centred) const;
  StressPlace refined(const StressPlace& from, bool centred, double goal) const;
  StressPlace largest_of(const Model& model, const StressPlace& from, double range, double last) const;
  StressPlace largest_beside(const Model& model, StressPlace top) const;
  double at_centre(double place, double length, double spacing, Index n, bool periodic) const;

  const LoadedBody& body_;
  Criterion of_;
  double below_, steps_show_;  ///< [m]
  CellSum field_;
};

}  // namespace asperity
