/// Units for people: the SI unit with the prefix that suits a number.
#pragma once

#include <string>
#include <string_view>

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

}  // namespace asperity::cli
