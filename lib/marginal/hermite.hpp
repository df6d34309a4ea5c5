/// Hermite functions, one order a call: f_k = He_k(x) w/√k!, k = 0, 1, …, from f_0 = w by
///     f_{k+1} = (x f_k - √k f_{k-1})/√(k+1).
///
/// With the Gaussian density w = φ(x) they stay below 1; with w = 1 they are the orthonormal polynomials. At one point,
/// or at the points of an Eigen array together.
#pragma once

#include <cmath>

namespace asperity {

template <class Value>
class HermiteFunction {
 public:
  HermiteFunction(Value x, Value weight) : x_(x), now_(weight), before_(0.0 * weight) {}
  Value next() {
    const Value value = now_;
    now_ = (x_ * value - std::sqrt(k_) * before_) / std::sqrt(k_ + 1);
    before_ = value;
    ++k_;
    return value;
  }

 private:
  Value x_, now_, before_;
  double k_ = 0;
};

}  // namespace asperity
