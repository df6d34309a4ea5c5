/// The exponential autocorrelation with elliptic contours, as the formula stands:
///     R(p,q)/σ² = exp(ln(level) √((p/λx*)² + (q/λy*)²)),
/// level at the lengths λx*, λy* in samples, 1/e at the decay lengths λ*/ln(1/level).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/field.hpp"

namespace asperity {

struct ExponentialTarget {
  double length_x = 1, length_y = 1, level = 0.1;

  double operator()(double p, double q) const {
    const double x = p / length_x, y = q / length_y;
    return std::exp(std::log(level) * std::sqrt(x * x + y * y));
  }
  /// Lags that cover so many decay lengths each way. Six leave an error below 1e-3 over all lags, 11.5 below
  /// 1e-6.
  Shape lags(double decay_lengths = 6) const {
    auto cover = [&](double length) {
      const double decay = length / -std::log(level);
      return std::max<Index>(1, static_cast<Index>(std::ceil(decay_lengths * decay)));
    };
    return {cover(length_x), cover(length_y)};
  }
};

}  // namespace asperity
