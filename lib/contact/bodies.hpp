/// Two elastic bodies of revolution and the gap between them before they touch.
///
/// Under the half-space approximation the two act as one elastic half-space against one rigid profile, with
///     1/E* = (1 - ν₁²)/E₁ + (1 - ν₂²)/E₂        composite modulus                              (1)
///     1/R  = 1/R₁ + 1/R₂                        composite curvature                            (2)
///     h    = (x² + y²)/(2R) - z                 undeformed gap                                 (3)
/// where z are heights above the smooth profile, positive towards the other body, of both bodies together.
///
/// Symbols   E Young's modulus [Pa]     ν Poisson's ratio     R radius [m]     h gap [m]     z heights [m]
/// Scope     (3) is the paraboloid of the sphere: relative error (x² + y²)/(4R²).
///
/// K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 4.1, 4.2.
#pragma once

#include <array>
#include <limits>

#include "grid/field.hpp"

namespace asperity {

struct Bodies {
  /// Radius [m]; infinity is a flat.
  std::array<double, 2> radius{std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::infinity()};
  std::array<double, 2> young{208e9, 208e9};  ///< Young's modulus [Pa]; infinity is a rigid body
  std::array<double, 2> poisson{0.3, 0.3};    ///< Poisson's ratio

  /// Throws ParameterError: radius > 0, young > 0 and not both infinite, -1 < poisson ≤ 1/2.
  void check() const;
  double composite_modulus() const;    ///< E* of (1) [Pa]
  double composite_curvature() const;  ///< 1/R of (2) [1/m]; 0 between flats
};

/// (3) for z = 0 at the cell centres: the bodies touch in the middle of the domain.
Field undeformed_gap(const Grid& grid, const Bodies& bodies);

}  // namespace asperity
