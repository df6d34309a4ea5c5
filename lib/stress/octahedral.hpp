/// The shear stress on the planes equally inclined to the principal stresses,
///     τ_oct = ⅓ √[(σ1-σ2)² + (σ2-σ3)² + (σ3-σ1)²] = (√2/3) σ_vM,                                      (1)
/// the measure of distortion that fatigue criteria of rolling contact are written in.
///
/// A. Nadai, Theory of Flow and Fracture of Solids, McGraw-Hill 1950.
#pragma once

#include <numbers>

#include "stress/von_mises.hpp"

namespace asperity {

inline constexpr double octahedral_over_von_mises = std::numbers::sqrt2 / 3;

inline double octahedral_shear(const stress::Tensor& s) { return octahedral_over_von_mises * von_mises(s); }

/// (1) along a row of `count` points, of which all components are known.
inline void octahedral_shear(const StressRow& s, Index count, double* out) {
  von_mises(s, count, out);
  for (Index j = 0; j < count; ++j) out[j] *= octahedral_over_von_mises;
}

}  // namespace asperity
