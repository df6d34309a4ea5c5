/// The largest shear stress over all planes through a point, half the difference of the outer principal stresses,
///     τ_max = (σ1 - σ3) / 2,                                                                           (1)
/// which reaches half the yield stress in tension where Tresca's material begins to flow.
///
/// H. Tresca, C. R. Acad. Sci. Paris 59 (1864) 754-758.
#pragma once

#include "stress/principal.hpp"

namespace asperity {

inline double max_shear_stress(const stress::Tensor& s) {
  const PrincipalStress p = principal_stress(s);
  return 0.5 * (p.value[0] - p.value[2]);
}

/// (1) along a row of `count` points, of which all components are known.
inline void max_shear_stress(const StressRow& s, Index count, double* out) {
  for (Index j = 0; j < count; ++j) out[j] = max_shear_stress(tensor_of(s, j));
}

}  // namespace asperity
