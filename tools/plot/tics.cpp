#include "tools/plot/tics.hpp"

#include <algorithm>
#include <cmath>

#include "tools/cli/readable.hpp"

namespace asperity::plot {
namespace {

constexpr double gap_along = 0.9, gap_across = 1.8, most_across = 8;  // [em], [em], steps

// Of a range, 0 to 1 along the axis.
double place_of(const Axis& axis, double v) {
  const Range r = drawn(axis);
  if (axis.logarithmic) return std::log(v / r.low) / std::log(r.high / r.low);
  return (v - r.low) / r.width();
}

// "0.02", or "2·10⁻⁶" where the axis goes beyond 0.001 to 1000.
std::string power_text(double digit, int power, bool plain) {
  if (plain) return fmt::format("{:.6g}", digit * std::pow(10, power));
  const std::string ten = power == 0 ? "1" : power == 1 ? "10" : "10" + cli::superscript(power);
  return digit == 1 ? ten : fmt::format("{:.0f}·{}", digit, ten);
}

// Every `stride`-th power of ten, or with 2 and 5 times them.
Tics powers(Range r, int stride, bool finer) {
  Tics out;
  const int first = static_cast<int>(std::floor(std::log10(r.low))),
            last = static_cast<int>(std::ceil(std::log10(r.high)));
  const bool plain = r.low >= 0.99e-3 && r.high < 5000;
  for (int n = first; n <= last; ++n)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double at = digit * std::pow(10, n);
      const bool wanted = finer || (digit == 1 && n % stride == 0);
      if (wanted && r.low * (1 - 1e-9) <= at && at <= r.high * (1 + 1e-9))
        out.push_back({at, power_text(digit, n, plain)});
    }
  return out;
}

Tics logarithmic(Range r, double most) {
  const double decades = std::log10(r.high / r.low);
  if (decades < 2 && most >= 3 * decades)
    if (const Tics fine = powers(r, 1, true); fine.size() > 1) return fine;
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / std::max(most, 1.0))));
  return powers(r, stride, false);
}

Tics at_most(const Axis& axis, double most) {
  const Range r = drawn(axis);
  return axis.logarithmic ? logarithmic(r, most) : tics_at(r, round_step(r.width(), most));
}

bool touch(const Axis& axis, const Tics& tics, double length) {
  for (std::size_t k = 1; k < tics.size(); ++k) {
    const double apart = (place_of(axis, tics[k].at) - place_of(axis, tics[k - 1].at)) * length,
                 needed = 0.5 * (length_of(tics[k].text) + length_of(tics[k - 1].text)) + gap_along;
    if (apart < needed) return true;
  }
  return false;
}

}  // namespace

Tics two_at_least(Range range, double step, double least) {
  Tics out = tics_at(range, step);
  const double decade = std::pow(10, std::floor(std::log10(range.width())));
  for (const double digit : {8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.8, 0.6, 0.5, 0.4})
    if (const double finer = digit * decade; out.size() < 2 && finer < step && finer >= least * range.width())
      out = tics_at(range, finer);
  return out;
}

Tics tics_at(Range range, double step) {
  const double whole = range.magnitude() / step;
  const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(std::max(whole, 1.0)))) + 1, 6, 17);
  Tics out;
  for (const double v : multiples(range, step))
    out.push_back({v, fmt::format("{}{:.{}g}", v < 0 ? "−" : "", std::abs(v), digits)});
  return out;
}

Tics tics_along(const Axis& axis, double length) {
  Tics out;
  for (double most = std::max(2.0, length / 3.2); most >= 1;
       most = most > 2 ? std::max(2.0, most - 1) : most - 1) {
    out = at_most(axis, most);
    if (touch(axis, out, length)) continue;
    if (out.size() > 1 || axis.logarithmic) return out;
    const Range r = drawn(axis);
    const Tics two = two_at_least(r, round_step(r.width(), most), 0);
    return touch(axis, two, length) ? out : two;
  }
  if (out.size() > 1) out.erase(out.begin() + 1, out.end());
  return out;
}

Tics tics_across(const Axis& axis, double height) {
  return at_most(axis, std::clamp(height / gap_across, 2.0, most_across));
}

double longest(const Tics& tics) {
  double out = 0;
  for (const Tic& t : tics) out = std::max(out, length_of(t.text));
  return out;
}

Overhang overhang(const Axis& axis, double length) {
  Overhang out;
  for (const auto& [at, text] : tics_along(axis, length)) {
    const double place = place_of(axis, at) * length, half = 0.5 * length_of(text);
    out.left = std::max(out.left, half - place);
    out.right = std::max(out.right, place + half - length);
  }
  return out;
}

std::string command(std::string_view axis, const Tics& tics) {
  if (tics.empty()) return fmt::format("unset {}tics", axis);  // an empty list means gnuplot's own
  std::string list;
  for (const auto& [at, text] : tics)
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", gnuplot_string(text), at);
  return fmt::format("set {}tics ({})", axis, list);
}

}  // namespace asperity::plot
