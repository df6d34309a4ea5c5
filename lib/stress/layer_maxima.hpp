/// Where a search for the largest stress may start: the local maxima of layers, also of wider cells.
///
/// At depth z the mean pressure over cells three times narrower than z is as good as the pressure itself:
/// what it lacks has faded to exp(-3π), 1e-3 of it.
#pragma once

#include <numbers>
#include <vector>

#include "core/extent.hpp"
#include "stress/maximum.hpp"

namespace asperity {

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

}  // namespace asperity
