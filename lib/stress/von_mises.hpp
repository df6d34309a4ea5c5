/// The von Mises equivalent stress,
///     σ_vM² = ½ [(σxx-σyy)² + (σyy-σzz)² + (σzz-σxx)²] + 3 (σxy² + σxz² + σyz²),                       (1)
/// which is √3 times the root of the second invariant of the stress deviator and reaches the yield stress
/// where a ductile material begins to flow.
///
/// R. von Mises, Nachr. Ges. Wiss. Göttingen, Math.-Phys. Kl. (1913) 582-592.
#pragma once

#include <cmath>

#include "core/field.hpp"
#include "stress/layers.hpp"

namespace asperity {

inline double von_mises(double sxx, double syy, double szz, double sxy, double sxz, double syz) {
  const double a = sxx - syy, b = syy - szz, c = szz - sxx;
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * (sxy * sxy + sxz * sxz + syz * syz));
}

inline double von_mises(const stress::Tensor& s) {
  return von_mises(s[stress::xx], s[stress::yy], s[stress::zz], s[stress::xy], s[stress::xz], s[stress::yz]);
}

/// (1) along a row of `count` points, of which all components are known.
inline void von_mises(const StressRow& s, Index count, double* out) {
  using namespace stress;
  for (Index j = 0; j < count; ++j)
    out[j] = von_mises(s[xx][j], s[yy][j], s[zz][j], s[xy][j], s[xz][j], s[yz][j]);
}

}  // namespace asperity
