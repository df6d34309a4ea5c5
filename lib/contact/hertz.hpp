/// Hertz's point contact of two spheres: the closed form that a smooth solution is measured against.
///
///     a = (3QR / 4E*)^⅓      p₀ = 3Q / (2πa²)      δ = a²/R                                     (1)
///     p(r) = p₀ √(1 - r²/a²)                                                                    (2)
///
/// Symbols   Q load [N]   E* composite modulus [Pa]   R composite radius [m]   a contact radius [m]
///           p₀ greatest pressure [Pa]   δ approach [m]
///
/// H. Hertz, Über die Berührung fester elastischer Körper, J. reine angew. Math. 92 (1881) 156-171.
#pragma once

#include <cmath>
#include <numbers>

#include "contact/bodies.hpp"

namespace asperity {

struct Hertz {
  double radius = 0;    ///< a [m]
  double pressure = 0;  ///< p₀ [Pa]
  double approach = 0;  ///< δ [m]
};

/// (1); the composite curvature must not be 0.
inline Hertz hertz(const Bodies& bodies, double load) {
  const double curvature = bodies.composite_curvature();
  const double a = std::cbrt(0.75 * load / (bodies.composite_modulus() * curvature));
  return {a, 1.5 * load / (std::numbers::pi * a * a), a * a * curvature};
}

}  // namespace asperity
