#include "tools/cli/readable.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace asperity::cli {
namespace {

constexpr double least_decimal = 0.01, largest_decimal = 1e10;
constexpr int most_digits = 15;                       // of a double, that are sure
constexpr double largest_counter = 9007199254740992;  // 2^53: every whole number up to it is a double

std::string with_true_minus(std::string text) {
  if (text.find_first_of("123456789") == text.npos) std::erase(text, '-');
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

bool is_whole(double value) { return value == std::round(value) && std::abs(value) <= largest_counter; }

// Of the first digit of a number, once that is rounded to `digits`.
int leading_exponent(double number, int digits) {
  const std::string text = fmt::format("{:.{}e}", number, digits - 1);
  return std::atoi(text.c_str() + text.find('e') + 1);
}

// Not below that of the smallest normal double.
int power_of_thousand(double number) {
  return std::max(-306, 3 * static_cast<int>(std::floor(leading_exponent(number, most_digits) / 3.0)));
}

std::string times_power(int exponent) { return "×\u00A010" + superscript(exponent); }

}  // namespace

std::string digits_of(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  return with_true_minus(is_whole(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.4g}", value));
}

std::string rounded(double value, int places) {
  if (!std::isfinite(value)) return digits_of(value);
  const double step = std::pow(10.0, -places);
  const double kept = places < 0 ? std::round(value / step) * step : value;
  return with_true_minus(fmt::format("{:.{}f}", kept, std::max(places, 0)));
}

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

std::string Scale::text(double value) const {
  return places ? rounded(number(value), *places) : digits_of(number(value));
}

Scale scale_for(double largest, double error, const std::string& si_unit) {
  const bool known = std::isfinite(error) && error > 0;
  const double size = std::isfinite(largest) ? std::abs(largest) : 0;
  return scale_for(largest, error, unit_for(known ? std::max(size, error) : size, si_unit));
}

Scale scale_for(double largest, double error, const Unit& unit) {
  const double size = std::isfinite(largest) ? std::abs(largest) : 0;
  Scale out;
  out.unit = unit;
  const bool known = std::isfinite(error) && error > 0;
  const double number = (known ? std::max(size, error) : size) / out.unit.factor;
  const bool counts = !known && is_whole(number);
  if (number > 0 && !counts && (number < least_decimal || number >= largest_decimal))
    out.exponent = power_of_thousand(number);
  if (!known || !(out.number(error) > 0)) return out;
  const int places = 1 - leading_exponent(out.number(error), 2);
  const double digits = size > 0 ? std::log10(out.number(size)) + places : 0;
  if (digits < most_digits) out.places = places;
  return out;
}

Measurement readable(const Parameter& row) {
  const Scale scale = scale_for(row.value, row.standard_error, row.unit);
  std::string unit = scale.unit.name;
  if (scale.exponent != 0) unit = times_power(scale.exponent) + (unit.empty() ? "" : "\u00A0" + unit);
  if (!scale.places) return {scale, scale.text(row.value), "", "", "", unit};
  const Interval ends = row.interval_95();
  return {scale,
          scale.text(row.value),
          scale.text(row.standard_error),
          scale.text(ends.low),
          scale.text(ends.high),
          unit};
}

}  // namespace asperity::cli
