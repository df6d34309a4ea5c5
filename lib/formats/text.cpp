/// Numbers in plain text: a matrix of heights, one line for each x or for each y, or points of a surface.
///
/// A line `# units: um` gives the unit of the values. Both the unit and the size are optional. Separators are
/// described in formats/text_table.hpp. Lines of x z or x y z are read as points if Reading says so. A matrix
/// whose first columns look like coordinates is refused unless Reading tells what they are: a map that
/// contains coordinates as heights would go unnoticed.
///
/// The points must form a grid, in any order: evenly spaced along each axis to a twentieth of the spacing. At
/// least half of the points must be given; the others are missing. The spacing is the range of a coordinate
/// divided by the number of steps. A profile x z has the same spacing in y.
#include <algorithm>
#include <cmath>
#include <vector>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr double unevenness = 0.05;  // of the spacing

using Column = Eigen::ArrayXd;

// Coordinates of a grid along one axis.
struct Axis {
  double first = 0, step = 0;
  Index count = 1;
  double worst = 0;  // the coordinate furthest from its grid position, by `off` of the spacing
  double off = 0;

  Index place(double x) const { return count > 1 ? std::llround((x - first) / step) : 0; }
};

// Coordinates are different if more than a quarter of the widest gap apart.
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

Column steps_of(const Column& c) { return c.tail(c.size() - 1) - c.head(c.size() - 1); }

bool steady(const Column& c) {
  const Column steps = steps_of(c);
  return (steps > 0).all() || (steps < 0).all();
}

bool even(const Column& c) {
  if (!steady(c)) return false;
  const Axis axis = axis_of(c);
  return axis.count == c.size() && axis.off <= unevenness;
}

// Whether pairs lie on different points of a grid and fill at least half of it.
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
bool labelled(const Field& lines) {
  const Index n = lines.rows() - 1, columns = lines.cols() - 1;
  if (n < 3 || columns < 3) return false;
  return even(lines.col(0).tail(n)) && even(lines.row(0).tail(columns)) && !even(lines.col(columns).tail(n));
}

Axis grid_axis(const Column& coordinates, char name) {
  if (!coordinates.isFinite().all()) refuse("a coordinate {} is missing or infinite", name);
  const Axis out = axis_of(coordinates);
  if (out.off > unevenness)
    refuse("the {} coordinates {} are not evenly spaced: {} is off by {} spacings", out.count, name,
           shortest(out.worst), shortest(std::round(100 * out.off) / 100));
  return out;
}

// Whether some columns look like coordinates: the first ascends or descends in even steps and the last does
// not; the first of two is monotonic; the first two of three lie on a grid or one of them is monotonic; or
// the first line, apart from its corner, ascends evenly too.
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

// Lines of x z or x y z, x and y in `metres`.
Map map_of_points(const Field& lines, double metres) {
  const Index columns = lines.cols(), points = lines.rows();
  if (columns != 2 && columns != 3)
    refuse("lines of points must be x z or x y z, these have {}", counted(columns, "number"));
  const Column xs = lines.col(0), ys = columns == 3 ? Column(lines.col(1)) : Column::Zero(points);
  const Axis x = grid_axis(xs, 'x'), y = grid_axis(ys, 'y');
  if (x.count * y.count < 2) refuse("a map needs at least 2 points");
  if (x.count > 2 * points / y.count)
    refuse("{} points fill less than half of a grid of {} x {}", points, x.count, y.count);
  Map map{.values = Field::Constant(x.count, y.count, Map::unknown)};
  std::vector<bool> given(static_cast<std::size_t>(map.values.size()));
  for (Index i = 0; i < points; ++i) {
    const Index at_x = x.place(xs(i)), at_y = y.place(ys(i));
    const auto at = static_cast<std::size_t>(at_x * y.count + at_y);
    if (given[at])
      refuse("point x = {}{} is given twice", shortest(xs(i)),
             columns == 3 ? ", y = " + shortest(ys(i)) : "");
    given[at] = true;
    map.values(at_x, at_y) = lines(i, columns - 1);
  }
  map.spacing = {metres * (x.count > 1 ? x.step : y.step), metres * (y.count > 1 ? y.step : x.step)};
  return map;
}

// From the last line "# units: …"; a second matrix after it is refused.
std::string_view units_in(std::string_view text) {
  constexpr std::string_view states_units = "# units:";
  std::string_view units, second;
  for (bool numbers = false; !text.empty();) {
    const std::string_view all = text, line = take_line(text);
    if (line.starts_with(states_units)) {
      units = trimmed(line.substr(states_units.size()));
      if (numbers && second.empty()) second = all;
    } else if (!line.empty() && line.front() != '#') {
      numbers = true;
      if (!second.empty()) refuse_rest(second, "map");
    }
  }
  return units;
}

Map map_of_lines(Field lines, const Reading& reading) {
  if (reading.coordinate > 0) return map_of_points(lines, reading.coordinate);
  if (!reading.matrix && has_coordinates(lines))
    refuse(
        "the first columns look like coordinates: give asperity-convert the unit of the points (`xyz`), or "
        "tell "
        "it that all columns are heights (`matrix`)");
  if (reading.order == Order::yx) lines.transposeInPlace();
  return {.values = std::move(lines)};
}

Map decode(std::string_view bytes, const Reading& reading) {
  Map map = map_of_lines(matrix_of(bytes, "map", 1, reading), reading);
  if (const std::string_view units = units_in(bytes); !units.empty()) set_units(map, units);
  return map;
}

std::string encode(const Map& map, Order order) {
  const std::string head = map.units.empty() ? "" : "# units: " + map.units + "\n";
  return head + (order == Order::yx ? text_of(map.values.transpose()) : text_of(map.values));
}

}  // namespace

const Format format::text{
    "text", "txt csv tsv dat asc xyz", "matrix of numbers in plain text", nullptr, decode, encode};

}  // namespace asperity
