/// Values as they are typed: a number and a unit, "0.4um", "208GPa", "5000N", "17px", and several of them.
///
/// UDUNITS-2 knows the units (dataset/units.hpp). A bare number is refused where a dimension is needed. A
/// second number is refused too, by which UDUNITS would multiply: "12 500N", "0-1mm". `px` counts samples.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/field.hpp"

namespace asperity::cli {

/// A length in metres or in samples.
struct SampledLength {
  double value = 0;
  bool samples = false;

  double metres(double spacing) const { return samples ? value * spacing : value; }
};

/// Throws ParameterError(option, "'text' why").
[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& why);

/// The value in the SI unit `unit` of a text such as "0.4um"; throws ParameterError(option, …) with a hint
/// where a unit is missing or wrong, or the number cannot be read. "inf" needs no unit.
double parse_quantity(const std::string& option, const std::string& text, const std::string& unit);
SampledLength parse_length(const std::string& option, const std::string& text);
/// "A,B" or "A"; pure numbers, without a unit, of "1" and "".
std::array<double, 2> parse_quantities(const std::string& option, const std::string& text,
                                       const std::string& unit);
std::array<SampledLength, 2> parse_lengths(const std::string& option, const std::string& text);

/// Bounds of a count, so that none takes memory or time without end.
struct Bounds {
  Bounds(Index least_, Index greatest_ = std::numeric_limits<int>::max(), std::string reason_ = {})
      : least(least_), greatest(greatest_), reason(std::move(reason_)) {}

  Index least, greatest;
  std::string reason;  ///< of the upper bound, where it is not evident
};
/// A whole number within bounds; throws ParameterError(option, …) otherwise.
Index parse_count(const std::string& option, const std::string& text, const Bounds& bounds);
/// "AxB", each at most 2^20.
Shape parse_counts(const std::string& option, const std::string& text, const Bounds& bounds);

/// An angle in radians, at most a turn: "30deg", "0.5rad".
double parse_angle(const std::string& option, const std::string& text);

/// "a,b,,c" at ',' is a, b, an empty word and c; an empty text is one empty word.
std::vector<std::string> split(const std::string& text, char separator);

enum class Steps { uniform, geometric };
/// The most values of a range: a layer or a contact each.
inline constexpr int most_values = 100'000;
/// The values of a list "A,B,C", or of a range "FROM:TO:COUNT", COUNT ≥ 2 values in `steps`, unless a fourth
/// word tells these, "FROM:TO:COUNT:geometric". `value` reads one of them. Throws ParameterError(option, …)
/// unless they increase.
std::vector<double> parse_series(const std::string& option, const std::string& text, Steps steps,
                                 const std::function<double(const std::string&)>& value);

/// Bytes: "512MB", "2GiB".
std::size_t parse_bytes(const std::string& option, const std::string& text);
/// "2GiB" where that is exact, else "27MB", rounded up.
std::string format_bytes(std::size_t bytes);

/// "3mm" for (0.003, "m"): the value with the prefix that suits it, to nine digits.
std::string format_quantity(double value, const std::string& unit);
/// "3.2um" to four digits; of a field in other units "3.2 V".
std::string figure(double value, const std::string& unit);

}  // namespace asperity::cli
