/// A confidence interval of an estimate, low ≤ estimate ≤ high, or the reason why there is none.
///
/// The ends are corrected for a bias that the estimate keeps. The correction assumes a bias that is small
/// compared with the error: where both ends lie on one side of the estimate, there is no interval. There is
/// none either if an end is NaN; ±∞ is an open end.
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
  std::string why;  ///< why there is none; "" where no error is known

  Interval() = default;
  static Interval of(double estimate, double low, double high) {
    if (std::isnan(estimate) || std::isnan(low) || std::isnan(high)) return {};
    if (low <= estimate && estimate <= high) return {low, high, ""};
    return {NAN, NAN, "no interval: the bias correction exceeds the standard error"};
  }
  static Interval about(double estimate, double half_width) {
    return of(estimate, estimate - half_width, estimate + half_width);
  }

  /// Of a ratio, by its logarithm: `half_width` is relative; `most` bounds the ratio.
  static Interval of_ratio(double estimate, double half_width,
                           double most = std::numeric_limits<double>::infinity()) {
    return of(estimate, estimate * std::exp(-half_width), std::min(most, estimate * std::exp(half_width)));
  }

  /// Of a positive figure of heavy tails, where a large value has a large error: 1/value varies more evenly.
  static Interval of_inverse(double estimate, double half_width) {
    return of(estimate, estimate / (1 + half_width),
              half_width < 1 ? estimate / (1 - half_width) : std::numeric_limits<double>::infinity());
  }

  bool known() const { return !std::isnan(low); }

 private:
  Interval(double from, double to, std::string reason) : low(from), high(to), why(std::move(reason)) {}
};

}  // namespace asperity
