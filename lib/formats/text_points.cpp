#include "formats/text_points.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr double unevenness = 0.05;  // of the spacing

using Column = Eigen::ArrayXd;

// Coordinates of a grid along one axis.
struct Axis {
  double first = 0, step = 0;
  Index count = 1;
  double worst = 0;  // the coordinate that is furthest from its place, by `off` of the spacing
  double off = 0;

  Index place(double x) const { return count > 1 ? std::llround((x - first) / step) : 0; }
};

// Coordinates further apart than a quarter of the widest gap are different ones.
Axis axis_of(const Column& coordinates) {
  std::vector<double> sorted(coordinates.begin(), coordinates.end());
  std::ranges::sort(sorted);
  double widest = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) widest = std::max(widest, sorted[i] - sorted[i - 1]);
  const auto differ = [&](std::size_t i) { return i > 0 && sorted[i] - sorted[i - 1] > widest / 4; };
  Axis out{.first = sorted.front()};
  for (std::size_t i = 1; i < sorted.size(); ++i) out.count += differ(i);
  if (out.count == 1) return out;
  out.step = (sorted.back() - sorted.front()) / static_cast<double>(out.count - 1);
  double place = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    place += differ(i);
    const double off = std::abs((sorted[i] - out.first) / out.step - place);
    if (off > out.off) out.off = off, out.worst = sorted[i];
  }
  return out;
}

bool turns(const Column& c) {
  const Column steps = c.tail(c.size() - 1) - c.head(c.size() - 1);
  return !((steps >= 0).all() || (steps <= 0).all());
}

bool steady(const Column& c) {
  const Column steps = c.tail(c.size() - 1) - c.head(c.size() - 1);
  return (steps > 0).all() || (steps < 0).all();
}

bool even(const Column& c) {
  if (!steady(c)) return false;
  const Axis axis = axis_of(c);
  return axis.count == c.size() && axis.off <= unevenness;
}

// Whether pairs stand on different places of a grid that they fill at least by half.
bool on_grid(const Column& a, const Column& b) {
  const Axis x = axis_of(a), y = axis_of(b);
  if (std::min(x.count, y.count) < 2 || x.count > 2 * a.size() / y.count) return false;
  if (std::max(x.off, y.off) > unevenness) return false;
  std::vector<bool> taken(static_cast<std::size_t>(x.count * y.count));
  for (Index i = 0; i < a.size(); ++i) {
    const auto at = static_cast<std::size_t>(x.place(a(i)) * y.count + y.place(b(i)));
    if (taken[at]) return false;
    taken[at] = true;
  }
  return true;
}

bool constant(const Column& c) { return c.maxCoeff() <= c.minCoeff(); }

// Of lines x y z: a profile along an axis, points on a grid, or lines of a scan of which one coordinate never turns.
bool are_coordinates(const Column& x, const Column& y, const Column& z) {
  if ((constant(x) && even(y)) || (constant(y) && even(x))) return true;
  if (even(x)) return !even(z);
  const auto scanned = [](const Column& c) { return !turns(c) && !constant(c); };
  return z.size() > 3 && (on_grid(x, y) || scanned(x) || scanned(y));
}

// A matrix with its coordinates along two of its edges.
bool labelled(const Field& lines) {
  const Index n = lines.rows() - 1, columns = lines.cols() - 1;
  if (n < 3 || columns < 3) return false;
  return even(lines.col(0).tail(n)) && even(lines.row(0).tail(columns)) && !even(lines.col(columns).tail(n));
}

[[noreturn]] void refuse(const std::string& what) { throw DataError("map", what); }

Axis grid_axis(const Column& coordinates, const std::string& name) {
  if (!coordinates.isFinite().all()) refuse("a coordinate " + name + " is missing");
  const Axis out = axis_of(coordinates);
  if (out.off > unevenness)
    refuse("its " + std::to_string(out.count) + " coordinates " + name +
           " are not evenly spaced: " + shortest(out.worst) + " lies " +
           shortest(std::round(100 * out.off) / 100) + " spacings from its place");
  return out;
}

}  // namespace

bool has_coordinates(const Field& lines) {
  const Index n = lines.rows(), columns = lines.cols();
  if (n < 3 || columns < 2) return false;
  if (labelled(lines)) return true;
  const Column first = lines.col(0), second = lines.col(1), last = lines.col(columns - 1);
  if (!first.isFinite().all()) return false;
  if (columns == 2) return steady(first);
  if (columns == 3 && second.isFinite().all()) return are_coordinates(first, second, last);
  return even(first) && !even(last);
}

Map map_of_points(const Field& lines, double metres) {
  const Index columns = lines.cols(), points = lines.rows();
  if (columns != 2 && columns != 3)
    refuse("lines of points are x z or x y z, and these hold " + counted(columns, "number"));
  const Column xs = lines.col(0), ys = columns == 3 ? Column(lines.col(1)) : Column::Zero(points);
  const Axis x = grid_axis(xs, "x"), y = grid_axis(ys, "y");
  const std::string shape = std::to_string(x.count) + " x " + std::to_string(y.count);
  if (x.count * y.count < 2) refuse("one point is no map");
  if (x.count > 2 * points / y.count)
    refuse(std::to_string(points) + " points are less than half of a grid of " + shape);
  Map map{.values = Field::Constant(x.count, y.count, Map::unknown)};
  std::vector<bool> given(static_cast<std::size_t>(map.values.size()));
  for (Index i = 0; i < points; ++i) {
    const Index at_x = x.place(xs(i)), at_y = y.place(ys(i));
    const auto at = static_cast<std::size_t>(at_x * y.count + at_y);
    if (given[at])
      refuse("the point x = " + shortest(xs(i)) + (columns == 3 ? ", y = " + shortest(ys(i)) : "") +
             " is given twice");
    given[at] = true;
    map.values(at_x, at_y) = lines(i, columns - 1);
  }
  const double dx = metres * (x.count > 1 ? x.step : y.step), dy = metres * (y.count > 1 ? y.step : x.step);
  map.spacing = {dx, dy};
  return map;
}

}  // namespace asperity
