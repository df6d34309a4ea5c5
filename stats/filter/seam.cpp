#include "stats/filter/seam.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/words.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {
namespace {

Field along_x(const Field& z, Axis1D axis) { return axis == Axis1D::x ? z : Field(z.transpose()); }

// z's rows are those of the axis.
Eigen::ArrayXd jumps(const Field& z) {
  if (z.rows() < 3) throw DataError("heights", "an axis of fewer than three points has no seam");
  return z.row(0) - z.bottomRows(1);
}

double mean_jump(const Field& z) {
  const ValidSum sum = sum_of_valid(jumps(z));
  if (sum.count == 0) throw DataError("heights", "no line has both its first and its last point");
  return sum.sum / sum.count;
}

// Row i of the axis multiplied or added to by f(i).
template <class Change>
Field by_rows(Field z, Axis1D axis, Change change) {
  for (Index i = 0; i < (axis == Axis1D::x ? z.rows() : z.cols()); ++i)
    if (axis == Axis1D::x)
      change(z.row(i), i);
    else
      change(z.col(i), i);
  return z;
}

}  // namespace

SeamJump seam_jump(const Field& heights, Axis1D axis) {
  const Field z = along_x(heights, axis);
  const Eigen::ArrayXd jump = jumps(z);
  SeamJump out{.mean = mean_jump(z)};
  const ValidSum squares = sum_of_valid(jump.square());
  out.rms = std::sqrt(squares.sum / squares.count);
  out.pairs = static_cast<Index>(squares.count);
  out.largest = jump.isNaN().select(0, jump).abs().maxCoeff();
  const Field steps = z.bottomRows(z.rows() - 1) - z.topRows(z.rows() - 1);
  const ValidSum inside = sum_of_valid(steps.square());
  out.step_rms = std::sqrt(inside.sum / inside.count);
  return out;
}

Field closed_by_tilt(const Field& z, Axis1D axis) {
  const Field lines = along_x(z, axis);
  const double slope = mean_jump(lines) / static_cast<double>(lines.rows() - 1);
  return by_rows(z, axis, [=](auto row, Index i) { row += slope * static_cast<double>(i); });
}

Field closed_by_taper(const Field& z, const Grid& grid, Axis1D axis, double length) {
  const double step = axis == Axis1D::x ? grid.dx : grid.dy,
               whole = axis == Axis1D::x ? grid.size_x() : grid.size_y();
  constexpr double slack = 1e-9;  // of lengths that were rounded
  check_parameter(length >= step * (1 - slack) && length <= whole / 2 * (1 + slack), "taper",
                  "'" + in_digits(length, 12) + " m' is not from one point, " + in_digits(step, 12) +
                      " m, to half the axis, " + in_digits(whole / 2, 12) + " m");
  const double level = mean(z);
  return by_rows(z, axis, [=](auto row, Index i) {
    const double along = (static_cast<double>(i) + 0.5) * step, s = std::min(along, whole - along);
    if (s < length) row = level + (row - level) * ((1 - std::cos(std::numbers::pi * s / length)) / 2);
  });
}

}  // namespace asperity
