#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "formats/refuse.hpp"
#include "formats/text_columns.hpp"

namespace asperity {
namespace {

using Column = Eigen::ArrayXd;
using Lines = std::vector<double>;
using Places = std::vector<Index>;

constexpr double widest_step = 3;  // of the mean, across which a line is drawn
constexpr Index no_chance = 8;     // missing lines that an even spacing explains as well

// ---- printed digits ----

// Powers of ten of the first and the last digit of a number.
struct Digits {
  int first = 0, last = 0;
};

Digits digits_of(double number) {
  char text[32];
  const char* const end =
      std::to_chars(text, text + sizeof text, std::abs(number), std::chars_format::scientific).ptr;
  const char* const e = std::find(static_cast<const char*>(text), end, 'e');
  Digits out;
  std::from_chars(e + (e + 1 < end && e[1] == '+' ? 2 : 1), end, out.first);
  out.last = out.first - std::max<int>(0, static_cast<int>(e - text) - 2);
  return out;
}

// How far printed coordinates may be from those that were meant.
class Print {
 public:
  explicit Print(const Lines& lines) {
    double largest = 0;
    for (const double x : lines) {
      largest = std::max(largest, std::abs(x));
      if (x == 0) continue;
      const Digits d = digits_of(x);
      last_ = std::min(last_, d.last);
      significant_ = std::max(significant_, d.first - d.last + 1);
    }
    const bool single = significant_ >= 7 && std::ranges::all_of(lines, [&](double x) {
                          return std::abs(x - static_cast<double>(static_cast<float>(x))) <= 0.5 * digit(x);
                        });
    rounding_ = largest * (single ? std::ldexp(1.0, -22) : 8 * std::numeric_limits<double>::epsilon());
    ends_ = std::max(digit(lines.front()), digit(lines.back()));
  }

  double of_one(double x) const { return 0.5 * digit(x) * (1 + 1e-9) + rounding_; }               // (1)
  double with_ends(double x) const { return 0.5 * (digit(x) + ends_) * (1 + 1e-9) + rounding_; }  // (2)
  double apart(double x) const { return digit(x) * (1 + 1e-9) + rounding_; }

 private:
  // The size of the last printed digit.
  double digit(double x) const {
    const int own = x == 0 ? last_ : digits_of(x).first - significant_ + 1;
    return std::pow(10.0, std::max(last_, own));
  }

  int last_ = 400, significant_ = 1;
  double rounding_ = 0, ends_ = 0;
};

// ---- the grid of coordinates ----

struct GridAxis {
  double first = 0, step = 0;
  Index count = 1;

  Index place(double x) const { return count > 1 ? std::llround((x - first) / step) : 0; }
};

struct Fit {
  GridAxis axis;
  double worst = 0, off = 0;            // the coordinate furthest from its place, by `off` of the step
  bool holds = false, rounded = false;  // rounded: by (1)
  bool tied = false;                    // and for one choice only
};

// By (2), lines at these places.
Fit fit(const Lines& lines, const Places& places, const Print& print) {
  Fit out{.axis = {.first = lines.front(), .count = places.back() + 1}};
  const double step = out.axis.step = (lines.back() - lines.front()) / static_cast<double>(places.back());
  out.holds = step > 0 && std::isfinite(step);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double off = std::abs(lines[i] - out.axis.first - static_cast<double>(places[i]) * step);
    if (off > out.off) out.off = off, out.worst = lines[i];
    out.holds = out.holds && off <= std::min(print.with_ends(lines[i]), 0.25 * step);
  }
  out.off /= step;
  return out;
}

// Whether the coordinates are nearest to lines one after the other.
bool each_at_its_place(const Lines& lines, const GridAxis& axis) {
  if (!(axis.step > 0)) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (axis.place(lines[k]) != static_cast<Index>(k)) return false;
  return true;
}

// By (1), lines one after the other. The steps for which all bands x_k ± half_k - k·step have a number in
// common are an interval; the width of what they have in common is concave in the step.
Fit centred_fit(const Lines& lines, const Print& print) {
  constexpr int halvings = 60;
  const auto last = static_cast<double>(lines.size() - 1);
  Lines half(lines.size());
  std::ranges::transform(lines, half.begin(), [&](double x) { return print.of_one(x); });
  const double range = lines.back() - lines.front(), ends = half.front() + half.back();
  double least = (range - ends) / last, most = (range + ends) / last, low = 0, high = 0;
  Fit out{.axis = {.count = static_cast<Index>(lines.size())}};
  for (int n = 0; n < halvings; ++n) {
    const double step = out.axis.step = 0.5 * (least + most);
    std::size_t lowest = 0, highest = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const double place = lines[k] - static_cast<double>(k) * step;
      if (k == 0 || place - half[k] > low) low = place - half[k], lowest = k;
      if (k == 0 || place + half[k] < high) high = place + half[k], highest = k;
    }
    if (lowest == highest) break;
    (lowest > highest ? least : most) = step;
  }
  out.axis.first = 0.5 * (low + high);
  out.tied = high - low <= 1e-6 * std::ranges::max(half);
  out.holds = out.rounded = low <= high && each_at_its_place(lines, out.axis);
  return out;
}

// Places with lines missing between them, by distances in units of the mean of the smallest ones.
Places places_with_holes(const Lines& lines, const Places& in_turn) {
  Lines gaps;
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (in_turn[i] > in_turn[i - 1]) gaps.push_back(lines[i] - lines[i - 1]);
  const double least = std::ranges::min(gaps);
  double sum = 0, count = 0;
  for (const double gap : gaps)
    if (gap < 1.5 * least) sum += gap, ++count;
  const double most = 2 * static_cast<double>(lines.size());
  Places out{0};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double steps = std::round((lines[i] - lines[i - 1]) / (sum / count));
    if (!(steps <= most)) return {};
    out.push_back(out.back() + (in_turn[i] > in_turn[i - 1] ? static_cast<Index>(steps) : 0));
  }
  return out.back() + 1 <= 2 * (in_turn.back() + 1) ? out : Places{};
}

struct Fits {
  Fit every, holes;  // with every line there, and with some missing

  bool none() const { return !every.holds && !holes.holds; }
};

// Lines that are no further apart than `joined` are one.
template <class Joined>
Fits fits_joining(const Lines& lines, const Print& print, const Joined& joined) {
  Places in_turn{0};
  for (std::size_t i = 1; i < lines.size(); ++i)
    in_turn.push_back(in_turn.back() + (lines[i] - lines[i - 1] <= joined(lines[i]) ? 0 : 1));
  if (in_turn.back() == 0) return {};
  Fits out{fit(lines, in_turn, print), {}};
  if (const Places places = places_with_holes(lines, in_turn); !places.empty())
    out.holes = fit(lines, places, print);
  const Index missing = out.holes.holds ? out.holes.axis.count - out.every.axis.count : 0;
  if ((missing > 0 || !out.every.holds) && in_turn.back() + 1 == std::ssize(lines)) {
    const Fit centred = centred_fit(lines, print);
    const bool few = missing > 0 && missing < no_chance;
    if (centred.holds && !(few && centred.tied)) out.every = centred;
  }
  return out;
}

// Those that hold: both if they are ambiguous.
Fits fits_of(const Column& coordinates) {
  constexpr Index many = 20;
  Lines lines;
  std::unique_copy(coordinates.begin(), coordinates.end(), std::back_inserter(lines));
  std::ranges::sort(lines);
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  if (lines.size() == 1) return {.every = {.axis = {.first = lines.front()}, .holds = true}, .holes = {}};
  const Print print(lines);
  Fits out = fits_joining(lines, print, [](double) { return 0.0; });
  if (out.none()) {
    const Fits joined = fits_joining(lines, print, [&](double x) { return print.apart(x); });
    if (!joined.none()) out = joined;
  }
  if (!out.every.holds || !out.holes.holds) return out;
  const Index missing = out.holes.axis.count - out.every.axis.count;
  if (missing == 0 || (out.every.rounded && missing >= no_chance)) out.holes.holds = false;
  if (missing == 1 && out.holes.axis.count >= many) out.every.holds = false;
  return out;
}

// Nothing if the coordinates fit no grid, or two.
std::optional<GridAxis> axis_of(const Column& coordinates) {
  const Fits fits = fits_of(coordinates);
  if (fits.every.holds == fits.holes.holds) return std::nullopt;
  return fits.every.holds ? fits.every.axis : fits.holes.axis;
}

GridAxis require_axis(const Column& coordinates, char name) {
  if (!coordinates.isFinite().all()) refuse("a coordinate {} is missing or infinite", name);
  const auto [every, holes] = fits_of(coordinates);
  if (every.holds && holes.holds)
    refuse("the {} coordinates are ambiguous: they have too few digits to tell {} evenly spaced ones from {}",
           name, every.axis.count, holes.axis.count);
  if (every.holds) return every.axis;
  if (holes.holds) return holes.axis;
  refuse("the {} coordinates {} are not evenly spaced to their printed digits: {} is off by {} spacings",
         name, every.axis.count, shortest(every.worst), in_digits(every.off, 2));
}

// Whether the count is not below that of points on half of a grid.
bool fill_half(Index points, const GridAxis& x, const GridAxis& y) { return x.count <= 2 * points / y.count; }

// The first point that another one before it has the place of, or their count.
Index given_twice(const Column& xs, const Column& ys, const GridAxis& x, const GridAxis& y) {
  std::vector<bool> known(static_cast<std::size_t>(x.count * y.count));
  for (Index i = 0; i < xs.size(); ++i) {
    auto at = known[static_cast<std::size_t>(x.place(xs(i)) * y.count + y.place(ys(i)))];
    if (at) return i;
    at = true;
  }
  return xs.size();
}

// ---- what looks like coordinates ----

Column differences(const Column& c) { return c.tail(c.size() - 1) - c.head(c.size() - 1); }

bool constant(const Column& c) { return c.maxCoeff() <= c.minCoeff(); }

// Ascending or descending, with equal values perhaps.
bool monotonic(const Column& c) {
  const Column steps = differences(c);
  return !constant(c) && ((steps >= 0).all() || (steps <= 0).all());
}

bool steady(const Column& c) {
  const Column steps = differences(c);
  return (steps > 0).all() || (steps < 0).all();
}

bool even(const Column& c) {
  constexpr double unevenness = 0.05;  // of the spacing
  if (!steady(c)) return false;
  const double step = (c(c.size() - 1) - c(0)) / static_cast<double>(c.size() - 1);
  const Column there = Column::LinSpaced(c.size(), 0, static_cast<double>(c.size() - 1)) * step + c(0);
  return ((c - there).abs() <= unevenness * std::abs(step)).all();
}

// Whether pairs lie on different points of a grid and fill at least half of it.
bool on_grid(const Column& a, const Column& b) {
  const auto x = axis_of(a), y = axis_of(b);
  if (!x || !y || std::min(x->count, y->count) < 2 || !fill_half(a.size(), *x, *y)) return false;
  return given_twice(a, b, *x, *y) == a.size();
}

// For lines x y z: a profile along an axis, points on a grid, or a scan with one monotonic coordinate.
bool are_coordinates(const Column& x, const Column& y, const Column& z) {
  if ((constant(x) && even(y)) || (constant(y) && even(x))) return true;
  if (even(x)) return !even(z);
  return z.size() > 3 && (on_grid(x, y) || monotonic(x) || monotonic(y));
}

// A matrix with its coordinates along two of its edges.
bool has_edges(const Eigen::Map<const Field>& lines) {
  const Index n = lines.rows() - 1, columns = lines.cols() - 1;
  if (n < 3 || columns < 3) return false;
  return even(lines.col(0).tail(n)) && even(lines.row(0).tail(columns)) && !even(lines.col(columns).tail(n));
}

// Even positions above lines of which none is even.
bool below_positions(const Eigen::Map<const Field>& lines) {
  const Index corner = std::isnan(lines(0, 0)) ? 1 : 0, columns = lines.cols() - corner;
  if (lines.rows() < 3 || columns < 4 - corner) return false;
  const auto even_line = [&](Index i) { return even(lines.row(i).tail(columns)); };
  if (!even_line(0)) return false;
  for (Index i = 1; i < lines.rows(); ++i)
    if (even_line(i)) return false;
  return true;
}

bool in_columns(const Eigen::Map<const Field>& lines) {
  const Index n = lines.rows(), columns = lines.cols();
  if (n < 3 || columns < 2) return false;
  if (has_edges(lines)) return true;
  const Column first = lines.col(0), second = lines.col(1), last = lines.col(columns - 1);
  if (!first.isFinite().all()) return false;
  if (columns == 2) return steady(first);
  if (columns == 3 && second.isFinite().all()) return are_coordinates(first, second, last);
  return even(first) && !even(last);
}

// ---- points ----

// The columns of a table, without lines that have no number in any of them.
std::vector<Column> taken(const Table& table, const std::vector<Index>& of) {
  const auto lines = table.field();
  std::vector<Column> out(of.size(), Column(table.lines));
  Index count = 0;
  for (Index i = 0; i < table.lines; ++i) {
    bool some = false;
    for (std::size_t k = 0; k < of.size(); ++k) {
      out[k](count) = lines(i, of[k]);
      some |= !std::isnan(out[k](count));
    }
    count += some ? 1 : 0;
  }
  for (Column& column : out) column.conservativeResize(count);
  return out;
}

double metres_of(const Columns& columns, std::size_t axis) {
  const std::string& unit = columns.units[axis];
  if (unit.empty())
    refuse("the text gives no unit of {}: give it, such as `xyz` {}", axis == 0 ? "x" : "y",
           example_of(columns));
  return metres_per(unit);
}

// Of points on no grid, as many at even places, by straight lines between neighbours.
Map even_profile(Column xs, Column zs, double metres) {
  if (xs(0) > xs(xs.size() - 1)) xs = xs.reverse().eval(), zs = zs.reverse().eval();
  const Index last = xs.size() - 1;
  const double spacing = (xs(last) - xs(0)) / static_cast<double>(last);
  Map out{.values = Field::Constant(last + 1, 1, Map::unknown),
          .spacing = {metres * spacing, metres * spacing}};
  for (Index i = 0, k = 0; i <= last; ++i) {
    const double at = i == last ? xs(last) : xs(0) + static_cast<double>(i) * spacing;
    while (k + 2 <= last && xs(k + 1) <= at) ++k;
    const double step = xs(k + 1) - xs(k), share = (at - xs(k)) / step;
    if (step <= widest_step * spacing) out.values(i, 0) = (1 - share) * zs(k) + share * zs(k + 1);
  }
  const Column steps = differences(xs);
  out.understood = fmt::format(
      "x is not evenly spaced, by {} to {} m: read at {} even places, by straight lines between points, "
      "which lowers "
      "waves of a few spacings{}",
      in_digits(metres * steps.minCoeff(), 3), in_digits(metres * steps.maxCoeff(), 3), last + 1,
      steps.maxCoeff() > widest_step * spacing
          ? fmt::format("; in steps of more than {:g} spacings heights are missing", widest_step)
          : "");
  return out;
}

}  // namespace

Map map_of_points(const Table& table, const Columns& columns) {
  const bool profile = columns.of.size() == 2;
  const std::array metres{metres_of(columns, 0), profile ? 1 : metres_of(columns, 1)};
  std::vector<Column> given = taken(table, columns.of);
  const Column xs = std::move(given.front()), zs = std::move(given.back()),
               ys = profile ? Column::Zero(xs.size()) : Column(std::move(given[1]));
  if (xs.size() < 2) refuse("a map needs at least 2 points");
  if (profile && xs.isFinite().all() && fits_of(xs).none()) {
    Lines sorted(xs.begin(), xs.end());
    std::ranges::sort(sorted);
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
      refuse("point x = {} is given twice", shortest(*twice));
    if (steady(xs)) return even_profile(xs, zs, metres[0]);
  }
  const GridAxis x = require_axis(xs, 'x'), y = require_axis(ys, 'y');
  if (!fill_half(xs.size(), x, y))
    refuse("{} points fill less than half of a grid of {} x {}", xs.size(), x.count, y.count);
  Map map{.values = Field::Constant(x.count, y.count, Map::unknown)};
  if (const Index i = given_twice(xs, ys, x, y); i < xs.size())
    refuse("point x = {}{} is given twice", shortest(xs(i)), profile ? "" : ", y = " + shortest(ys(i)));
  for (Index i = 0; i < xs.size(); ++i) map.values(x.place(xs(i)), y.place(ys(i))) = zs(i);
  const double dx = metres[0] * x.step, dy = metres[1] * y.step;
  map.spacing = {x.count > 1 ? dx : dy, y.count > 1 ? dy : dx};
  return map;
}

Coordinates coordinates_in(const Eigen::Map<const Field>& lines) {
  if (in_columns(lines)) return Coordinates::columns;
  return below_positions(lines) ? Coordinates::line : Coordinates::none;
}

}  // namespace asperity
