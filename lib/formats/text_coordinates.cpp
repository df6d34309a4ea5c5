#include "formats/text_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "formats/text_grid.hpp"

namespace asperity {
namespace {

using Lines = Eigen::Map<const Field>;

constexpr double unevenness = 0.05;  // of the spacing

Column steps_of(const Column& c) { return c.tail(c.size() - 1) - c.head(c.size() - 1); }

bool steady(const Column& c) {
  const Column steps = steps_of(c);
  return (steps > 0).all() || (steps < 0).all();
}

bool even(const Column& c) {
  if (!steady(c)) return false;
  const double step = (c(c.size() - 1) - c(0)) / static_cast<double>(c.size() - 1);
  const Column there = Column::LinSpaced(c.size(), 0, static_cast<double>(c.size() - 1)) * step + c(0);
  return ((c - there).abs() <= unevenness * std::abs(step)).all();
}

// Whether pairs lie on different points of a grid and fill at least half of it.
bool on_grid(const Column& a, const Column& b) {
  const auto x = axis_of(a), y = axis_of(b);
  if (!x || !y || std::min(x->count, y->count) < 2 || x->count > 2 * a.size() / y->count) return false;
  std::vector<bool> taken(static_cast<std::size_t>(x->count * y->count));
  for (Index i = 0; i < a.size(); ++i) {
    const auto at = static_cast<std::size_t>(x->place(a(i)) * y->count + y->place(b(i)));
    if (taken[at]) return false;
    taken[at] = true;
  }
  return true;
}

bool constant(const Column& c) { return c.maxCoeff() <= c.minCoeff(); }

// Monotonic, and not constant.
bool scanned(const Column& c) {
  const Column steps = steps_of(c);
  return !constant(c) && ((steps >= 0).all() || (steps <= 0).all());
}

// For lines x y z: a profile along an axis, points on a grid, or a scan with one monotonic coordinate.
bool are_coordinates(const Column& x, const Column& y, const Column& z) {
  if ((constant(x) && even(y)) || (constant(y) && even(x))) return true;
  if (even(x)) return !even(z);
  return z.size() > 3 && (on_grid(x, y) || scanned(x) || scanned(y));
}

// A matrix with its coordinates along two of its edges.
bool labelled(const Lines& lines) {
  const Index n = lines.rows() - 1, columns = lines.cols() - 1;
  if (n < 3 || columns < 3) return false;
  return even(lines.col(0).tail(n)) && even(lines.row(0).tail(columns)) && !even(lines.col(columns).tail(n));
}

// Even positions above lines of which none is even.
bool below_positions(const Lines& lines) {
  const Index corner = std::isnan(lines(0, 0)) ? 1 : 0, columns = lines.cols() - corner;
  if (lines.rows() < 3 || columns < 4 - corner) return false;
  const auto line = [&](Index i) { return Column(lines.row(i).tail(columns)); };
  if (!even(line(0))) return false;
  for (Index i = 1; i < lines.rows(); ++i)
    if (even(line(i))) return false;
  return true;
}

bool in_columns(const Lines& lines) {
  const Index n = lines.rows(), columns = lines.cols();
  if (n < 3 || columns < 2) return false;
  if (labelled(lines)) return true;
  const Column first = lines.col(0), second = lines.col(1), last = lines.col(columns - 1);
  if (!first.isFinite().all()) return false;
  if (columns == 2) return steady(first);
  if (columns == 3 && second.isFinite().all()) return are_coordinates(first, second, last);
  return even(first) && !even(last);
}

}  // namespace

Coordinates coordinates_in(const Lines& lines) {
  if (in_columns(lines)) return Coordinates::columns;
  return below_positions(lines) ? Coordinates::line : Coordinates::none;
}

}  // namespace asperity
