/// Poisson's ratio of an isotropic elastic body, -1 < ν ≤ ½: in this range the bulk modulus, E/3(1-2ν), and
/// the shear modulus, E/2(1+ν), are positive. At ½ the body is incompressible, below 0 it widens when
/// stretched.
#pragma once

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {

constexpr bool is_poisson_ratio(double nu) { return nu > -1 && nu <= 0.5; }

/// Throws ParameterError("poisson") unless nu is in this range.
inline void check_poisson(double nu) {
  check_parameter(is_poisson_ratio(nu), "poisson", in_digits(nu, 6) + " must lie above -1 and not above 0.5");
}

}  // namespace asperity
