#include "tools/cli/quantity.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/units.hpp"

namespace asperity::cli {
namespace {

struct NumberAndUnit {
  double number;
  std::string unit;
};

using ByteUnit = std::pair<std::string_view, double>;
constexpr ByteUnit byte_units[] = {{"B", 1},        {"kB", 1e3},     {"MB", 1e6},
                                   {"GB", 1e9},     {"TB", 1e12},    {"KiB", 0x1p10},
                                   {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};

// UDUNITS multiplies: "500 N" is a unit of 500 N, and "'000N" one of 1 N. A unit by itself has no numbers but
// exponents, as in m2, s-1, um^-3 and (m s)**2, and the 1 of 1/um.
bool has_number(std::string_view unit) {
  constexpr std::string_view digits = "0123456789";
  if (unit.starts_with("1/")) unit.remove_prefix(2);
  for (std::size_t at = unit.find_first_of(digits); at != unit.npos; at = unit.find_first_of(digits, at)) {
    std::string_view base = unit.substr(0, at);
    if (base.ends_with('-') || base.ends_with('+')) base.remove_suffix(1);
    base.remove_suffix(base.ends_with('^') ? 1 : base.ends_with("**") ? 2 : 0);
    const unsigned char last = base.empty() ? ' ' : static_cast<unsigned char>(base.back());
    const bool letter = last < 0x80 ? std::isalpha(last) != 0 : last != 0xb7;  // the end of a middle dot
    if (!letter && last != ')') return true;
    at = std::min(unit.find_first_not_of(digits, at), unit.size());
  }
  return false;
}

NumberAndUnit number_and_unit(const std::string& option, const std::string& text) {
  const auto [number, rest, found, in_range] = leading_number<double>(text);
  if (found && !in_range) refuse(option, text, "is beyond the range of a double");
  if (!found || std::isnan(number)) refuse(option, text, "does not begin with a number");
  const std::string_view unit = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
  if (has_number(unit))
    refuse(option, text, "has more than one number: write one, without blanks or marks within, and its unit");
  return {number, std::string(unit)};
}

// Units as one would type them for a quantity of this dimension.
std::string examples(const std::string& unit) {
  if (unit == "m") return "mm or um";
  if (unit == "Pa") return "GPa or MPa";
  if (unit == "N") return "N or kN";
  return unit;
}

template <class T, class Parse>
std::array<T, 2> pair_of(const std::string& option, const std::string& text, Parse parse) {
  const std::vector<std::string> words = split(text, ',');
  if (words.size() > 2) refuse(option, text, "has more than two values");
  const T first = parse(words.front());
  return {first, words.size() == 1 ? first : parse(words.back())};
}

std::vector<double> spaced(const std::string& option, double from, double to, const std::string& number,
                           Steps steps) {
  const Bounds bounds(std::numeric_limits<Index>::min(), most_values, "the most values of a series");
  const Index count = parse_count(option, number, bounds);
  if (count < 2) refuse(option, number, "is not a number of values, 2 or more");
  std::vector<double> out;
  for (Index i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    out.push_back(steps == Steps::geometric ? from * std::pow(to / from, t) : from + (to - from) * t);
  }
  out.back() = to;
  return out;
}

}  // namespace

void refuse(const std::string& option, const std::string& text, const std::string& why) {
  throw ParameterError(option, "'" + text + "' " + why);
}

double parse_quantity(const std::string& option, const std::string& text, const std::string& unit) {
  const auto [number, given] = number_and_unit(option, text);
  if (std::isinf(number) && given.empty()) return number;
  if (given.empty()) refuse(option, text, "has no unit: append one, such as " + examples(unit));
  if (given == "px")
    refuse(option, text, "counts samples, which is not possible here: give it in " + examples(unit));
  try {
    return number * unit_factor(given, unit);
  } catch (const std::invalid_argument& e) {
    refuse(option, text, "cannot be read: " + std::string(e.what()));
  }
}

SampledLength parse_length(const std::string& option, const std::string& text) {
  const auto [number, given] = number_and_unit(option, text);
  if (given == "px") return {number, true};
  if (given.empty()) refuse(option, text, "has no unit: append px for samples, or mm, um, ...");
  return {parse_quantity(option, text, "m"), false};
}

std::array<double, 2> parse_quantities(const std::string& option, const std::string& text,
                                       const std::string& unit) {
  if (unit.empty() || unit == "1")
    return pair_of<double>(option, text, [&](const std::string& t) {
      const auto [number, given] = number_and_unit(option, t);
      if (!given.empty()) refuse(option, text, "is a pure number: leave the unit out");
      return number;
    });
  return pair_of<double>(option, text, [&](const std::string& t) { return parse_quantity(option, t, unit); });
}

std::array<SampledLength, 2> parse_lengths(const std::string& option, const std::string& text) {
  return pair_of<SampledLength>(option, text, [&](const std::string& t) { return parse_length(option, t); });
}

Index parse_count(const std::string& option, const std::string& text, const Bounds& bounds) {
  const auto [value, rest, found, in_range] = leading_number<Index>(text);
  if (!found || !rest.empty()) refuse(option, text, "is not a whole number");
  if (value < bounds.least) throw ParameterError(option, text + " is below " + std::to_string(bounds.least));
  if (value > bounds.greatest)
    throw ParameterError(option, text + " is above " + std::to_string(bounds.greatest) +
                                     (bounds.reason.empty() ? "" : ", " + bounds.reason));
  return value;
}

Shape parse_counts(const std::string& option, const std::string& text, const Bounds& bounds) {
  auto read = [&](std::string_view word) {
    const auto [value, rest, found, in_range] = leading_number<Index>(word);
    if (!found || !rest.empty()) refuse(option, text, "is not of the form AxB, such as 128x128");
    const Index most = std::min<Index>(bounds.greatest, 1 << 20);
    if (value < bounds.least || value > most)
      refuse(option, text,
             "must lie between " + std::to_string(bounds.least) + " and " + std::to_string(most) +
                 (bounds.reason.empty() ? "" : ", " + bounds.reason));
    return value;
  };
  const auto cross = text.find('x');
  if (cross == std::string::npos) refuse(option, text, "is not of the form AxB, such as 128x128");
  const std::string_view whole = text;
  const Index nx = read(whole.substr(0, cross));
  return {nx, read(whole.substr(cross + 1))};
}

double parse_angle(const std::string& option, const std::string& text) {
  const auto [number, given] = number_and_unit(option, text);
  if (given.empty()) refuse(option, text, "needs a unit: " + std::string(text) + "deg, or 0.5rad");
  // UDUNITS has no "deg".
  const double angle = given == "deg" ? number * std::numbers::pi / 180 : parse_quantity(option, text, "rad");
  if (!(std::abs(angle) <= 2 * std::numbers::pi * (1 + 1e-12)))
    refuse(option, text, "is more than a full turn: give at most 360deg");
  return angle;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> out;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(separator, begin);
    out.push_back(text.substr(begin, end - begin));
  }
  return out;
}

std::vector<double> parse_series(const std::string& option, const std::string& text, Steps steps,
                                 const std::function<double(const std::string&)>& value) {
  std::vector<double> values;
  const std::vector<std::string> range = split(text, ':');
  if (range.size() == 1) {
    for (const std::string& word : split(text, ',')) values.push_back(value(word));
  } else {
    if (range.size() != 3 && range.size() != 4) refuse(option, text, "is not of the form FROM:TO:COUNT");
    if (range.size() == 4) {
      if (range[3] != "uniform" && range[3] != "geometric")
        refuse(option, range[3], "is neither uniform nor geometric");
      steps = range[3] == "uniform" ? Steps::uniform : Steps::geometric;
    }
    const double from = value(range[0]);
    if (steps == Steps::geometric && !(from > 0))
      throw ParameterError(option, "equal ratios cannot start from '" + range[0] + "'");
    values = spaced(option, from, value(range[1]), range[2], steps);
  }
  if (std::ranges::adjacent_find(values, std::not_fn(std::less<>())) != values.end())
    refuse(option, text, "does not increase");
  return values;
}

std::size_t parse_bytes(const std::string& option, const std::string& text) {
  const auto [number, given] = number_and_unit(option, text);
  if (given.empty()) refuse(option, text, "has no unit: append MB or GiB");
  const auto* unit = std::ranges::find(byte_units, given, &ByteUnit::first);
  if (unit == std::end(byte_units))
    refuse(option, text, "is not a size in B, kB, MB, GB, TB, KiB, MiB, GiB or TiB");
  const double bytes = number * unit->second;
  if (!(bytes >= 1 && bytes < 0x1p63)) refuse(option, text, "must lie between 1B and 8388607TiB");
  return static_cast<std::size_t>(bytes);
}

std::string format_bytes(std::size_t bytes) {
  constexpr std::size_t gibi = std::size_t{1} << 30, mega = 1000000;
  if (bytes > 0 && bytes % gibi == 0) return std::to_string(bytes / gibi) + "GiB";
  return std::to_string((bytes + mega - 1) / mega) + "MB";
}

std::string format_quantity(double value, const std::string& unit) {
  constexpr struct {
    double factor;
    const char* prefix;
  } prefixes[] = {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}};
  const auto print = [](double v) { return in_digits(v, 9); };
  if (unit == "1" || value == 0 || !std::isfinite(value)) return print(value);
  const auto* p = std::ranges::find_if(prefixes, [&](const auto& q) { return std::abs(value) >= q.factor; });
  if (p == std::end(prefixes)) return print(value) + unit;
  return print(value / p->factor) + p->prefix + unit;
}

std::string figure(double value, const std::string& unit) {
  if (unit != "m") return in_digits(value, 4) + " " + unit;
  return format_quantity(to_number<double>(in_digits(value, 4)).value_or(value), unit);
}

}  // namespace asperity::cli
