/// Numbers for eyes: a unit with the prefix that suits them, and the digits that their error leaves.
///
/// The standard error has two digits, and the value and its interval end where it ends. Without an error
/// there are four digits, of whole numbers all. Pure numbers below 0.01 have powers of a thousand as units.
#pragma once

#include <string>

#include "stats/measure/parameter.hpp"
#include "tools/plot/scale.hpp"

namespace asperity::report {

/// Of a length, its powers from m-4 to m4, a force, a stress, a time, an angle or a pure number; any other
/// unit stands as it is.
plot::Unit unit_for(double magnitude, const std::string& si_unit);

/// Four digits, a true minus, and ∞; a dash for what is not known.
std::string digits_of(double value);
/// Rounded at 10^-places, which may lie before the point.
std::string rounded(double value, int places);

/// "386.7 nm".
std::string readable(double value, const std::string& si_unit);

struct Measurement {
  std::string value, error, low, high;  ///< empty where none is known
  std::string unit;
};
Measurement readable(const Parameter& row);

}  // namespace asperity::report
