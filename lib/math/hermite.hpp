/// Hermite functions, one order a call: f_k = He_k(x) w/√k!, k = 0, 1, …, from f_0 = w by
///     f_{k+1} = (x f_k - √k f_{k-1})/√(k+1).
///
/// With the Gaussian density w = φ(x) they stay below 1; with w = 1 they are the orthonormal polynomials. At
/// one point, or at the points of an Eigen array together.
#pragma once

#include <cmath>
#include <utility>

namespace asperity {

template <class Value>
class HermiteFunction {
 public:
  HermiteFunction(Value x, Value weight) : x_(x), now_(weight), before_(0.0 * weight) {}
  /// The reference holds until the next call.
  const Value& next() {
    before_ = (x_ * now_ - std::sqrt(k_) * before_) * (1 / std::sqrt(k_ + 1));
    std::swap(now_, before_);
    ++k_;
    return before_;
  }

 private:
  Value x_, now_, before_;
  double k_ = 0;
};

}  // namespace asperity
