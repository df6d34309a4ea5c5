/// A confidence interval of an estimate: low ≤ estimate ≤ high, or none, and why.
///
/// The ends are freed of a bias that the estimate keeps, by a correction derived as small beside the error;
/// where both come to lie on one side of the estimate it is not, and there is no interval. An end that is not
/// a number makes none either; ±∞ is an open end.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asperity {

class Interval {
 public:
  double low = std::numeric_limits<double>::quiet_NaN(), high = low;  ///< NaN both, or in order
  std::string why;  ///< there is none; "" where no error is known

  Interval() = default;
  static Interval of(double estimate, double low, double high) {
    if (std::isnan(estimate) || std::isnan(low) || std::isnan(high)) return {};
    if (low <= estimate && estimate <= high) return {low, high, ""};
    return {NAN, NAN, "the correction of its bias exceeds its error"};
  }
  static Interval about(double estimate, double half_width) {
    return of(estimate, estimate - half_width, estimate + half_width);
  }

  /// Of a ratio, in its logarithm: `half_width` is relative, and no ratio exceeds `most`.
  static Interval of_ratio(double estimate, double half_width,
                           double most = std::numeric_limits<double>::infinity()) {
    return of(estimate, estimate * std::exp(-half_width), std::min(most, estimate * std::exp(half_width)));
  }

  bool known() const { return !std::isnan(low); }

 private:
  Interval(double from, double to, std::string reason) : low(from), high(to), why(std::move(reason)) {}
};

}  // namespace asperity
