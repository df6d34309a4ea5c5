/// Sliding friction: a surface traction in proportion to the pressure.
///
/// Where one body slides over the other everywhere, Coulomb's law gives the traction on the loaded surface
///     q = μ p (cos α, sin α),                                                                          (1)
/// α being the direction, from x towards y, in which the other body slides over this one. The traction is taken
/// not to alter the pressure, which is exact for bodies of the same material and small otherwise [1].
///
/// [1] K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.2.
#pragma once

#include <array>

#include "stress/component.hpp"

namespace asperity {

struct Friction {
  double coefficient = 0;  ///< μ ≥ 0
  double angle = 0;        ///< α [rad], a turn either way at the most

  /// Throws ParameterError("friction") or ("friction-angle").
  void check() const;
  /// What acts per unit pressure, by stress::Traction: 1, μ cos α, μ sin α. An angle within 1e-12 of a multiple of
  /// 90° is taken as that, and then only one traction acts.
  std::array<double, 3> weights() const;
};

/// The tractions whose weights are not zero.
stress::Tractions acting(const std::array<double, 3>& weights);

}  // namespace asperity
