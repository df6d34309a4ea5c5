#include "tools/cli/readable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace asperity::cli {

// ---- units ----

namespace {

struct Prefix {
  double factor;
  const char* symbol;
};
constexpr Prefix prefixes[] = {{1e9, "G"},  {1e6, "M"},  {1e3, "k"}, {1, ""},
                               {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
constexpr const Prefix* no_prefix = prefixes + 3;

// The largest from `begin` on that fits, or else the smallest of all.
template <class Fits>
Prefix prefix_from(const Prefix* begin, double magnitude, const Fits& fits) {
  if (!(magnitude > 0)) return *no_prefix;
  const Prefix* found = std::find_if(begin, std::end(prefixes), fits);
  return found == std::end(prefixes) ? *std::prev(found) : *found;
}

// The largest that brings a magnitude to 1 or more.
Prefix prefix_for(double magnitude, const Prefix* begin = prefixes) {
  const double limit = magnitude * (1 + 1e-9);
  return prefix_from(begin, magnitude, [&](const Prefix& p) { return limit >= p.factor; });
}

// The largest of a length whose power n is 0.01 or more of the number, or below 1000 of a negative power.
Prefix prefix_of_power(double magnitude, int n) {
  return prefix_from(no_prefix, magnitude, [&](const Prefix& p) {
    const double number = magnitude / std::pow(p.factor, n);
    return n > 0 ? number >= 0.01 : number < 1000;
  });
}

// The power n of "m2" or "m-1"; 0 for any other unit.
int power_of_length(std::string_view unit) {
  constexpr std::array powers{-4, -3, -2, -1, 2, 3, 4};
  const auto* found = std::ranges::find_if(powers, [&](int n) { return unit == "m" + std::to_string(n); });
  return found == powers.end() ? 0 : *found;
}

}  // namespace

std::string Unit::label(std::string_view quantity) const {
  return name.empty() ? std::string(quantity) : fmt::format("{} [{}]", quantity, name);
}

std::string superscript(int n) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = n < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(n))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

Unit prefixed(double magnitude, const std::string& si_unit) {
  if (si_unit.empty() || si_unit == "1") return {};
  if (si_unit != "m" && si_unit != "Pa" && si_unit != "N") return {1, si_unit};
  const Prefix p = prefix_for(magnitude);
  return {p.factor, p.symbol + si_unit};
}

Unit unit_for(double magnitude, const std::string& si_unit) {
  if (si_unit == "rad") return {std::numbers::pi / 180, "°"};
  if (si_unit == "rad m-1") {
    const Prefix p = prefix_of_power(magnitude, -1);
    return {1 / p.factor, fmt::format("rad/{}m", p.symbol)};
  }
  if (si_unit == "s") {
    const Prefix p = prefix_for(magnitude, no_prefix);
    return {p.factor, p.symbol + si_unit};
  }
  if (const int power = power_of_length(si_unit)) {
    const Prefix p = prefix_of_power(magnitude, power);
    return {std::pow(p.factor, power), fmt::format("{}m{}", p.symbol, superscript(power))};
  }
  // A prefix of the first factor is one of the whole, unless that factor has a power.
  const std::size_t first = std::min(si_unit.find_first_of(" /"), si_unit.size());
  const std::string factor = si_unit.substr(0, first);
  if (first < si_unit.size() && factor == "1") return {1, si_unit};
  const Unit out = prefixed(magnitude, factor);
  return {out.factor, out.name + si_unit.substr(first)};
}

// ---- numbers ----

namespace {

constexpr double least_decimal = 0.01, largest_decimal = 1e10;
constexpr int most_digits = 15;                       // of a double, that are sure
constexpr double largest_counter = 9007199254740992;  // 2^53: every whole number up to it is a double

bool is_whole(double value) { return value == std::round(value) && std::abs(value) <= largest_counter; }

// In ASCII; a zero has no sign.
std::string plain_number(double value, std::optional<int> places) {
  if (std::isnan(value)) return "-";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  const double step = std::pow(10.0, -places.value_or(0));
  const double kept = step > 1 ? std::round(value / step) * step : value;
  std::string text = places            ? fmt::format("{:.{}f}", kept, std::max(*places, 0))
                     : is_whole(value) ? fmt::format("{:.0f}", value)
                                       : fmt::format("{:.4g}", value);
  if (text.find_first_of("123456789") == text.npos) std::erase(text, '-');
  return text;
}

std::string with_symbols(const std::string& plain) {
  if (plain == "-") return "–";
  const bool negative = plain.starts_with('-');
  const std::string size = plain.substr(negative);
  return (negative ? "−" : "") + (size == "inf" ? "∞" : size);
}

// Of the first digit of a number, once that is rounded to `digits`.
int leading_exponent(double number, int digits) {
  const std::string text = fmt::format("{:.{}e}", number, digits - 1);
  return std::atoi(text.c_str() + text.find('e') + 1);
}

// Not below that of the smallest normal double.
int power_of_thousand(double number) {
  return std::max(-306, 3 * static_cast<int>(std::floor(leading_exponent(number, most_digits) / 3.0)));
}

// Of a value and its error, as far as they are known.
double greater_of(double value, double error) {
  const double size = std::isfinite(value) ? std::abs(value) : 0;
  return std::isfinite(error) ? std::max(size, error) : size;
}

std::string times_power(int exponent) { return "×\u00A010" + superscript(exponent); }

}  // namespace

std::string digits_of(double value) { return with_symbols(plain_number(value, {})); }

std::string readable(double value, const std::string& si_unit) {
  if (!std::isfinite(value)) return digits_of(value);
  const double size = std::abs(value);
  const bool pure = si_unit.empty() || si_unit == "1";
  if (pure && size > 0 && size < least_decimal) {
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    return digits_of(value / std::pow(10.0, exponent)) + "\u00A0" + times_power(exponent);
  }
  const Unit unit = unit_for(size, si_unit);
  const std::string number = digits_of(value / unit.factor);
  return unit.name.empty() ? number : number + (unit.name == "°" ? "" : "\u00A0") + unit.name;
}

double Scale::number(double value) const { return value / unit.factor / std::pow(10.0, exponent); }

std::string Scale::text(double value) const { return with_symbols(plain_number(number(value), places)); }

std::string Scale::plain(double value) const {
  const std::string text = plain_number(number(value), places);
  const bool bare = exponent == 0 || !std::isfinite(value) || value == 0;
  return bare ? text : fmt::format("{}e{}", text, exponent);
}

Scale scale_for(double largest, double error, const std::string& si_unit) {
  return scale_for(largest, error, unit_for(greater_of(largest, error), si_unit));
}

Scale scale_for(double largest, double error, const Unit& unit) {
  const bool known = std::isfinite(error) && error > 0;
  const double number = greater_of(largest, error) / unit.factor;
  Scale out{unit, 0, {}};
  if (number > 0 && (number < least_decimal || number >= largest_decimal) && (known || !is_whole(number)))
    out.exponent = power_of_thousand(number);
  if (!known || !(out.number(error) > 0)) return out;
  const int places = 1 - leading_exponent(out.number(error), 2);
  const double size = greater_of(largest, 0), digits = size > 0 ? std::log10(out.number(size)) + places : 0;
  if (digits < most_digits) out.places = places;
  return out;
}

Measurement readable(const Parameter& row) {
  const Scale scale = scale_for(row.value, row.standard_error, row.unit);
  std::string unit = scale.unit.name;
  if (scale.exponent != 0) unit = times_power(scale.exponent) + (unit.empty() ? "" : "\u00A0" + unit);
  Measurement out{scale, scale.text(row.value), "", "", "", unit};
  if (!scale.places) return out;
  const Interval ends = row.interval_95();
  out.error = scale.text(row.standard_error);
  out.low = scale.text(ends.low);
  out.high = scale.text(ends.high);
  return out;
}

}  // namespace asperity::cli
