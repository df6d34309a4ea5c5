#include "tools/report/readable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace asperity::report {
namespace {

using plot::Unit;

constexpr double least_decimal = 0.01;  // of pure numbers
constexpr int most_places = 15;
constexpr double largest_counter = 9007199254740992;  // 2^53: every whole number up to it is a double

// The power n of "m2" or "m-1"; 0 where it is none of a length beyond the first.
int power_of_length(const std::string& unit) {
  constexpr std::array powers{-4, -3, -2, -1, 2, 3, 4};
  for (const int n : powers)
    if (unit == "m" + std::to_string(n)) return n;
  return 0;
}

std::string superscript(int n) {
  constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = n < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(n))) out += digits[static_cast<std::size_t>(c - '0')];
  return out;
}

// The largest length whose power brings the number to 0.01 or more, or below 1000 of a negative power.
Unit power_unit(double magnitude, int n) {
  if (!(magnitude > 0)) return {1, "m" + superscript(n)};
  const Unit lengths[] = {{1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}};
  for (const Unit& length : lengths) {
    const double factor = std::pow(length.factor, n), number = magnitude / factor;
    if (length.factor == 1e-9 || (n > 0 ? number >= 0.01 : number < 1000))
      return {factor, length.name + superscript(n)};
  }
  return {};
}

std::string with_true_minus(std::string text) {
  if (text.find_first_of("123456789") == text.npos) std::erase(text, '-');
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

}  // namespace

Unit unit_for(double magnitude, const std::string& si_unit) {
  if (si_unit == "rad") return {std::numbers::pi / 180, "°"};
  if (si_unit.empty() || si_unit == "1") {
    if (!(magnitude > 0) || magnitude >= least_decimal) return {};
    const int thousands = static_cast<int>(std::floor(std::log10(magnitude * (1 + 1e-9)) / 3));
    return {std::pow(1000.0, thousands), "×\u00A010" + superscript(3 * thousands)};
  }
  if (si_unit == "s") {
    const Unit newtons = plot::unit_for(std::min(magnitude, 1.0), "N");
    return {newtons.factor, newtons.name.substr(0, newtons.name.size() - 1) + "s"};
  }
  const int power = power_of_length(si_unit);
  return power != 0 ? power_unit(magnitude, power) : plot::unit_for(magnitude, si_unit);
}

std::string digits_of(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const bool whole = value == std::round(value) && std::abs(value) <= largest_counter;
  return with_true_minus(whole ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value));
}

std::string rounded(double value, int places) {
  if (!std::isfinite(value)) return digits_of(value);
  const double step = std::pow(10.0, -places);
  const double kept = places < 0 ? std::round(value / step) * step : value;
  return with_true_minus(fmt::format("{:.{}f}", kept, std::clamp(places, 0, most_places)));
}

std::string readable(double value, const std::string& si_unit) {
  if (!std::isfinite(value)) return digits_of(value);
  const double size = std::abs(value);
  const bool pure = si_unit.empty() || si_unit == "1";
  if (pure && size > 0 && size < least_decimal) {
    const int exponent = static_cast<int>(std::floor(std::log10(size)));
    return digits_of(value / std::pow(10.0, exponent)) + "\u00A0×\u00A010" + superscript(exponent);
  }
  const Unit unit = unit_for(size, si_unit);
  const std::string number = digits_of(value / unit.factor);
  return unit.name.empty() ? number : number + (unit.name == "°" ? "" : "\u00A0") + unit.name;
}

Measurement readable(const Parameter& row) {
  const bool known = std::isfinite(row.standard_error) && row.standard_error > 0;
  const double size = std::isfinite(row.value) ? std::abs(row.value) : 0;
  const Unit unit = unit_for(std::max(size, known ? row.standard_error : 0), row.unit);
  if (!known) return {digits_of(row.value / unit.factor), "", "", "", unit.name};
  const double error = row.standard_error / unit.factor;
  const int places = 1 - static_cast<int>(std::floor(std::log10(error)));
  const Interval ends = row.interval_95();
  return {rounded(row.value / unit.factor, places), rounded(error, places),
          rounded(ends.low / unit.factor, places), rounded(ends.high / unit.factor, places), unit.name};
}

}  // namespace asperity::report
