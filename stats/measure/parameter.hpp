/// A measured quantity: value, error and unit.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "stats/uncertainty/interval.hpp"

namespace asperity {

/// Of a 95 % interval of a Gaussian quantity, in standard errors.
inline constexpr double half_width_95 = 1.959963984540054;

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Estimate {
  double value;
  double standard_error = unknown;
  std::optional<Interval> interval = {};
  std::string why = {};  ///< why the value or its error is missing or rough, where it is not why others are
  bool is_bound = false;
};

struct Parameter {
  std::string name;  ///< the symbol of the standard, if there is one: "Sq"
  double value;
  std::string unit;       ///< SI, in UDUNITS' notation
  double standard_error;  ///< not finite if unknown
  std::string meaning;
  /// Of 95 % confidence; absent: 1.96 standard errors about the value.
  std::optional<Interval> interval = {};
  std::string why = {};   ///< why the value or its error is missing or rough
  bool is_bound = false;  ///< the quantity is below the value, the least that its simulation tells

  Interval interval_95() const {
    if (!std::isfinite(standard_error)) return {};
    return interval.value_or(Interval::about(value, half_width_95 * standard_error));
  }
  /// Why a value, error or interval is missing or rough; "" if none is, or an error no theory gives.
  std::string note() const { return why.empty() ? interval_95().why : why; }
};

using Parameters = std::vector<Parameter>;

}  // namespace asperity
