/// Two elastic bodies and the gap between them before they touch.
///
/// In the half-space approximation the two act as one elastic half-space against one rigid profile, with
///     1/E* = (1 - ν₁²)/E₁ + (1 - ν₂²)/E₂                 composite modulus                     (1)
///     1/Rx = 1/Rx₁ + 1/Rx₂,   1/Ry = 1/Ry₁ + 1/Ry₂       composite curvatures                  (2)
///     h    = x²/(2Rx) + y²/(2Ry) - z₁ - z₂               undeformed gap                        (3)
/// z₁ and z₂ are the heights of either body above its smooth form at the same (x, y), each positive towards
/// the other body; a counter body that was measured face up is to be mirrored in x or y first. Rx is the
/// radius of the section along x; the principal axes of both bodies lie along x and y. A sphere has Rx = Ry,
/// a cylinder along y has Ry = ∞, a flat both; a hollow's radius is negative, no smaller than that of what is
/// in it.
///
/// Symbols   E Young's modulus [Pa]   ν Poisson's ratio   R radius [m]   h gap [m]   z heights [m]
/// Scope     (3) is the paraboloid of the bodies: relative error x²/(4R²).
///
/// K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 4.1, 4.2.
#pragma once

#include <array>
#include <limits>

#include "core/extent.hpp"
#include "core/field.hpp"

namespace asperity {

/// Radii of curvature along x and y [m]; infinity is straight. A sphere is one number.
struct Radii {
  double x = std::numeric_limits<double>::infinity(), y = std::numeric_limits<double>::infinity();

  Radii() = default;
  Radii(double sphere) : x(sphere), y(sphere) {}
  Radii(double along_x, double along_y) : x(along_x), y(along_y) {}
};

struct Bodies {
  std::array<Radii, 2> radius{};              ///< flats unless given
  std::array<double, 2> young{208e9, 208e9};  ///< Young's modulus [Pa]; infinity is a rigid body
  std::array<double, 2> poisson{0.3, 0.3};    ///< Poisson's ratio

  /// Throws ParameterError unless radius ≠ 0, curvatures ≥ 0, young > 0, not both infinite, -1 < poisson ≤ ½.
  void check() const;
  double composite_modulus() const;  ///< E* of (1) [Pa]
  double curvature_x() const;        ///< 1/Rx of (2) [1/m]; 0 between flats
  double curvature_y() const;        ///< 1/Ry of (2) [1/m]
  bool flat() const { return curvature_x() == 0 && curvature_y() == 0; }
};

/// (3) for z₁ = z₂ = 0 at the cell centres: the bodies touch in the middle of the domain.
Field undeformed_gap(const Grid& grid, const Bodies& bodies);
/// Some rows of it.
Field undeformed_gap(const Grid& grid, const Bodies& bodies, Extent rows);

}  // namespace asperity
