/// Numbers for people: in a unit with a prefix, rounded to the digits that their error leaves.
///
/// The standard error has two significant digits; the value and its interval end at the same place. Without
/// an error there are four digits, and all digits of a whole number. Numbers below 0.01 of their unit, or too
/// large for it, have a power of a thousand as a factor.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stats/measure/parameter.hpp"

namespace asperity::cli {

struct Unit {
  double factor = 1;  ///< in SI
  std::string name;   ///< "µm"; empty for pure numbers

  /// "height [µm]"
  std::string label(std::string_view quantity) const;
};
/// The prefix of m, Pa or N that brings a magnitude into [1, 1000): 3e-3 m is in mm. Other units stay SI.
Unit prefixed(double magnitude, const std::string& si_unit);
/// The same for powers of a length from m-4 to m4 (mm²), products and quotients that begin with m, Pa or N
/// (kN/m), rad m-1 (rad/mm), times, and angles, which are in degrees. Other units stay SI.
Unit unit_for(double magnitude, const std::string& si_unit);
/// "⁻²"
std::string superscript(int n);

/// Four digits, a true minus, and ∞; a dash for an unknown number.
std::string digits_of(double value);
/// "386.7 nm".
std::string readable(double value, const std::string& si_unit);

/// How to show numbers that share a unit and a standard error.
struct Scale {
  Unit unit;
  int exponent = 0;           ///< a multiple of three: numbers are those of 10^exponent units
  std::optional<int> places;  ///< after the point; none: four significant digits

  double number(double value) const;
  std::string text(double value) const;   ///< "−0.020" of number(value)
  std::string plain(double value) const;  ///< "-20e-3" of the unit, to be copied and read back
};
/// `largest` is the largest modulus among them; an `error` of zero or NaN counts as unknown.
Scale scale_for(double largest, double error, const std::string& si_unit);
/// The same in a given unit.
Scale scale_for(double largest, double error, const Unit& unit);

struct Measurement {
  Scale scale;
  std::string value, error, low, high;  ///< all but the value empty where the error is unknown
  std::string unit;                     ///< with the power of ten: "× 10⁻³"
};
Measurement readable(const Parameter& row);

}  // namespace asperity::cli
