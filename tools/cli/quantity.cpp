#include "tools/cli/quantity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string_view>

#include "core/words.hpp"
#include "dataset/units.hpp"

namespace asperity::cli {
namespace {

struct NumberAndUnit {
  double number;
  std::string unit;
};

struct ByteUnit {
  std::string_view name;
  double bytes;
};
constexpr ByteUnit byte_units[] = {{"B", 1},        {"kB", 1e3},     {"MB", 1e6},
                                   {"GB", 1e9},     {"TB", 1e12},    {"KiB", 0x1p10},
                                   {"MiB", 0x1p20}, {"GiB", 0x1p30}, {"TiB", 0x1p40}};

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& why) {
  throw ParameterError(option, "'" + text + "' " + why);
}

NumberAndUnit split(const std::string& option, const std::string& text) {
  const auto [number, unit, found, in_range] = leading_number<double>(text);
  if (found && !in_range) refuse(option, text, "is beyond the range of a double");
  if (!found || std::isnan(number)) refuse(option, text, "does not begin with a number");
  return {number, std::string(unit.substr(std::min(unit.find_first_not_of(' '), unit.size())))};
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
  const auto comma = text.find(',');
  if (comma == std::string::npos) {
    const T both = parse(text);
    return {both, both};
  }
  if (text.find(',', comma + 1) != std::string::npos) refuse(option, text, "has more than two values");
  return {parse(text.substr(0, comma)), parse(text.substr(comma + 1))};
}

}  // namespace

double parse_quantity(const std::string& option, const std::string& text, const std::string& unit) {
  const auto [number, given] = split(option, text);
  if (std::isinf(number) && given.empty()) return number;
  if (given.empty()) refuse(option, text, "has no unit: append one, such as " + examples(unit));
  try {
    return number * unit_factor(given, unit);
  } catch (const std::invalid_argument& e) {
    refuse(option, text, "cannot be read: " + std::string(e.what()));
  }
}

SampledLength parse_length(const std::string& option, const std::string& text) {
  const auto [number, given] = split(option, text);
  if (given == "px") return {number, true};
  if (given.empty()) refuse(option, text, "has no unit: append px for samples, or mm, um, ...");
  return {parse_quantity(option, text, "m"), false};
}

std::array<double, 2> parse_quantities(const std::string& option, const std::string& text,
                                       const std::string& unit) {
  return pair_of<double>(option, text, [&](const std::string& t) { return parse_quantity(option, t, unit); });
}

std::array<SampledLength, 2> parse_lengths(const std::string& option, const std::string& text) {
  return pair_of<SampledLength>(option, text, [&](const std::string& t) { return parse_length(option, t); });
}

std::array<double, 2> parse_numbers(const std::string& option, const std::string& text) {
  return pair_of<double>(option, text, [&](const std::string& t) {
    const auto [number, unit] = split(option, t);
    if (!unit.empty()) refuse(option, text, "is a pure number and takes no unit");
    return number;
  });
}

Index parse_count(const std::string& option, const std::string& text, const Bounds& bounds) {
  const auto [value, rest, found, in_range] = leading_number<Index>(text);
  if (!found || !rest.empty()) throw ParameterError(option, "'" + text + "' is no whole number");
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
  const auto [number, given] = split(option, text);
  // UDUNITS has no "deg".
  const double angle =
      given.empty() || given == "deg" ? number * std::numbers::pi / 180 : parse_quantity(option, text, "rad");
  if (!(std::abs(angle) <= 2 * std::numbers::pi * (1 + 1e-12)))
    refuse(option, text, "is more than a turn: at most 360 degrees either way");
  return angle;
}

std::size_t parse_bytes(const std::string& option, const std::string& text) {
  const auto [number, given] = split(option, text);
  if (given.empty()) refuse(option, text, "has no unit: append MB or GiB");
  const auto* unit = std::ranges::find(byte_units, given, &ByteUnit::name);
  if (unit == std::end(byte_units))
    refuse(option, text, "is no size in B, kB, MB, GB, TB, KiB, MiB, GiB or TiB");
  const double bytes = number * unit->bytes;
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

}  // namespace asperity::cli
