/// Values between the samples of a sequence that has few high modes.
///
/// f is known by its spectrum f^(k), k in radians a sample, and small near the highest mode π. From samples c
/// of a spectrum that is divided by that of the bell φ,
///     f(x) = Σ_m c(m) φ(x - m),   c^(k) = f^(k) / φ^(k),                                                (1)
///     φ(x) = I0(β √(1 - (2x/w)²)),   φ^(k) = w sinh(g) / g,   g² = β² - (kw/2)²,   |x| < w/2,           (2)
/// follows f anywhere from the w = 8 samples around x (Kaiser and Bessel's bell). s values a sample are
///     f(m + q/s) = Σ_t weight(q, t) c(m - 3 + t),   q = 0 … s-1,  t = 0 … 7.                            (3)
///
/// Accuracy  of a mode k: 9e-8 at 0, 8e-7 at π/2, 5e-3 at 3π/4, 1 at π, the sum of φ^(2πj ± k) over φ^(k).
/// Cost      8 multiplications a value, where an inverse transform padded with zeros takes 5 log2 and more.
///
/// J. A. Fessler, B. P. Sutton, Nonuniform fast Fourier transforms using min-max interpolation, IEEE Trans.
/// Signal Process. 51 (2003) 560-574.
#pragma once

#include "transform/plan.hpp"

namespace asperity {

class Interpolation {
 public:
  static constexpr Index taps = 8, before = 3;  ///< samples around a value; so many stand before its own

  /// s values a sample; s is a power of two.
  explicit Interpolation(Index s);

  /// 1/φ^(k): what (1) has to be prepared with.
  static double prepared(double k);

  /// The weights of (3) for q.
  const double* weights(Index q) const { return weights_.data() + q * taps; }
  /// out[j] = f(j/s) for j < count; samples[0] is c(-3). Writes up to padded(count) values.
  void refine(const double* samples, Index count, double* out) const;
  Index padded(Index count) const { return (count + lanes_ - 1) / lanes_ * lanes_; }

 private:
  Index s_, lanes_;                ///< values made at a time: 8, or s if that is more
  AlignedVector<double> weights_;  ///< [q][t]
  AlignedVector<double> matrix_;   ///< [sample][lane]: of the samples around a run of lanes
};

}  // namespace asperity
