#include "formats/text_grid.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <vector>

#include "core/words.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

using Lines = std::vector<double>;

constexpr Index no_chance = 8;  // missing lines that an even spacing explains as well

// In ascending order, each once.
Lines lines_of(const Column& coordinates) {
  Lines out;
  for (const double x : coordinates)
    if (out.empty() || out.back() != x) out.push_back(x);
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// Powers of ten of the first and the last digit of a number.
struct Digits {
  int first = 0, last = 0;
};

Digits digits_of(double x) {
  char text[32];
  const char* end = std::to_chars(text, text + sizeof text, std::abs(x), std::chars_format::scientific).ptr;
  const char* e = std::find(static_cast<const char*>(text), end, 'e');
  const char* exponent = e + (e + 1 < end && e[1] == '+' ? 2 : 1);
  Digits out;
  std::from_chars(exponent, end, out.first);
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
    const bool single = std::ranges::all_of(lines, [&](double x) {
      return std::abs(x - static_cast<double>(static_cast<float>(x))) <= 0.5 * digit(x);
    });
    const double epsilon = std::numeric_limits<double>::epsilon();
    rounding_ = largest * (single && significant_ >= 7 ? std::ldexp(1.0, -22) : 8 * epsilon);
    ends_ = std::max(digit(lines.front()), digit(lines.back()));
  }
  // The size of the last printed digit.
  double digit(double x) const {
    const int own = x == 0 ? last_ : digits_of(x).first - significant_ + 1;
    return std::pow(10.0, std::max(last_, own));
  }
  double tolerance(double x) const { return 0.5 * (digit(x) + ends_) * (1 + 1e-9) + rounding_; }
  // The same where the grid does not begin and end at printed coordinates.
  double half(double x) const { return 0.5 * digit(x) * (1 + 1e-9) + rounding_; }
  double apart(double x) const { return digit(x) * (1 + 1e-9) + rounding_; }

 private:
  int last_ = 400, significant_ = 1;
  double rounding_ = 0, ends_ = 0;
};

struct Fit {
  GridAxis axis;
  double worst = 0, off = 0;            // the coordinate furthest from its place, by `off` of the step
  bool holds = false, rounded = false;  // rounded: (2) holds
  bool tied = false;                    // and for one choice only
};

Fit fit(const Lines& lines, const std::vector<Index>& places, const Print& print) {
  Fit out{.axis = {.first = lines.front(), .count = places.back() + 1}};
  out.axis.step = (lines.back() - lines.front()) / static_cast<double>(places.back());
  out.holds = out.axis.step > 0 && std::isfinite(out.axis.step);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double off = std::abs(lines[i] - out.axis.first - static_cast<double>(places[i]) * out.axis.step);
    if (off > out.off) out.off = off, out.worst = lines[i];
    out.holds = out.holds && off <= std::min(print.tolerance(lines[i]), 0.25 * out.axis.step);
  }
  out.off /= out.axis.step;
  return out;
}

// Whether the coordinates are nearest to lines one after the other.
bool each_at_its_place(const Lines& lines, const GridAxis& axis) {
  if (!(axis.step > 0)) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (axis.place(lines[k]) != static_cast<Index>(k)) return false;
  return true;
}

// The steps for which all bands x_k ± half_k - k·step have a number in common are an interval; the width of
// what they have in common is concave in the step.
Fit centred_fit(const Lines& lines, const Print& print) {
  constexpr int halvings = 60;
  const auto last = static_cast<double>(lines.size() - 1);
  Lines half(lines.size());
  std::ranges::transform(lines, half.begin(), [&](double x) { return print.half(x); });
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

// Places of lines: one after the other, or joined where `joined` says that two are the same.
template <class Joined>
std::vector<Index> places_in_turn(const Lines& lines, const Joined& joined) {
  std::vector<Index> out{0};
  for (std::size_t i = 1; i < lines.size(); ++i)
    out.push_back(out.back() + (joined(lines[i - 1], lines[i]) ? 0 : 1));
  return out;
}

// Places with lines missing between them, by distances in units of the mean of the smallest ones.
std::vector<Index> places_with_holes(const Lines& lines, const std::vector<Index>& in_turn) {
  Lines gaps;
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (in_turn[i] > in_turn[i - 1]) gaps.push_back(lines[i] - lines[i - 1]);
  const double least = std::ranges::min(gaps);
  double sum = 0, count = 0;
  for (const double gap : gaps)
    if (gap < 1.5 * least) sum += gap, ++count;
  const double most = 2 * static_cast<double>(lines.size());
  std::vector<Index> out{0};
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const double steps = std::round((lines[i] - lines[i - 1]) / (sum / count));
    if (!(steps <= most)) return {};
    out.push_back(out.back() + (in_turn[i] > in_turn[i - 1] ? static_cast<Index>(steps) : 0));
  }
  const Index known = in_turn.back() + 1;
  return out.back() + 1 <= 2 * known ? out : std::vector<Index>{};
}

struct Fits {
  Fit every, holes;  // with every line there, and with some missing
};

Fits fits_of(const Lines& lines, const std::vector<Index>& in_turn, const Print& print) {
  if (in_turn.back() == 0) return {};
  Fits out{fit(lines, in_turn, print), {}};
  const auto places = places_with_holes(lines, in_turn);
  if (!places.empty()) out.holes = fit(lines, places, print);
  const Index missing = out.holes.holds ? out.holes.axis.count - out.every.axis.count : 0;
  if ((missing > 0 || !out.every.holds) && in_turn.back() + 1 == std::ssize(lines)) {
    const Fit centred = centred_fit(lines, print);
    const bool few = missing > 0 && missing < no_chance;
    if (centred.holds && !(few && centred.tied)) out.every = centred;
  }
  return out;
}

// As they are, and if nothing fits, with lines that differ by a digit joined.
Fits fits_of(const Lines& lines) {
  const Print print(lines);
  const Fits apart = fits_of(lines, places_in_turn(lines, [](double, double) { return false; }), print);
  if (apart.every.holds || apart.holes.holds) return apart;
  const auto near = [&](double a, double b) { return b - a <= print.apart(b); };
  const Fits joined = fits_of(lines, places_in_turn(lines, near), print);
  return joined.every.holds || joined.holes.holds ? joined : apart;
}

// Those that hold: both if they are ambiguous.
Fits decided(Fits fits) {
  constexpr Index many = 20;
  const Index missing = fits.holes.axis.count - fits.every.axis.count;
  if (!fits.every.holds || !fits.holes.holds) return fits;
  if (missing == 0 || (fits.every.rounded && missing >= no_chance)) fits.holes.holds = false;
  if (missing == 1 && fits.holes.axis.count >= many) fits.every.holds = false;
  return fits;
}

}  // namespace

std::optional<GridAxis> axis_of(const Column& coordinates) {
  const Lines lines = lines_of(coordinates);
  if (lines.size() == 1) return GridAxis{.first = lines.front()};
  const Fits fits = decided(fits_of(lines));
  if (fits.every.holds == fits.holes.holds) return std::nullopt;
  return fits.every.holds ? fits.every.axis : fits.holes.axis;
}

GridAxis require_axis(const Column& coordinates, char name) {
  if (!coordinates.isFinite().all()) refuse("a coordinate {} is missing or infinite", name);
  const Lines lines = lines_of(coordinates);
  if (lines.size() == 1) return {.first = lines.front()};
  const Fits fits = decided(fits_of(lines));
  if (fits.every.holds && fits.holes.holds)
    refuse("the {} coordinates are ambiguous: they have too few digits to tell {} evenly spaced ones from {}",
           name, fits.every.axis.count, fits.holes.axis.count);
  if (fits.every.holds) return fits.every.axis;
  if (fits.holes.holds) return fits.holes.axis;
  refuse("the {} coordinates {} are not evenly spaced to their printed digits: {} is off by {} spacings",
         name, fits.every.axis.count, shortest(fits.every.worst), in_digits(fits.every.off, 2));
}

}  // namespace asperity
