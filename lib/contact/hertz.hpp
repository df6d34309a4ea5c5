/// Hertz's contacts: the closed forms that a smooth solution is measured against.
///
/// A point contact, the undeformed gap h = A x² + B y² with A = 1/(2Rx) ≤ B = 1/(2Ry), is an ellipse with the
/// semi-axes a along x and b = k a along y. With m = 1 - k² and the complete elliptic integrals K(m), E(m),
///     B/A = [E/k² - K] / [K - E]                    gives k                                      (1)
///     a³  = 3Q (K - E) / (2π E* m A)                p₀ = 3Q / (2πab)       δ = p₀ b K / E*       (2)
///     p   = p₀ √(1 - x²/a² - y²/b²)                                                              (3)
/// and where A > B, x and y change places. In Carlson's forms [2], K = R_F(0, k², 1), K - E = m R_D(0, k²,
/// 1)/3, E/k² - K = m R_D(0, 1, k²)/3, nothing cancels for k → 1:
///     B/A = R_D(0, 1, k²) / R_D(0, k², 1)           a³ = Q R_D(0, k², 1) / (2π E* A)             (4)
/// For k = 1 these are the sphere's a = (3QR / 4E*)^⅓, δ = a²/R.
///
/// A line contact of parallel cylinders, of load q per length in plane strain, has
///     b = √(4qR / πE*)      p₀ = 2q / (πb)      p = p₀ √(1 - x²/b²)                              (5)
///     δ = q (1 + 2 ln(2d/b)) / (πE*),                                                            (6)
/// whose approach counts from a datum: the points at a distance d, which a line load does not move.
///
/// Symbols   Q load [N]   q load per length [N/m]   E* composite modulus [Pa]   Rx, Ry, R composite radii [m]
///           a, b semi-axes of the contact, b half its width [m]   p₀ greatest pressure [Pa]   δ approach [m]
///           d datum [m]
/// Scope     (2): both curvatures above 0, of ratios up to 1e100. (5), (6): infinite length.
/// Accuracy  round-off, some 10 ε.
///
/// [1] H. Hertz, Über die Berührung fester elastischer Körper, J. reine angew. Math. 92 (1881) 156-171;
///     K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 3.3, 4.2.
/// [2] B. C. Carlson, Computing elliptic integrals by duplication, Numer. Math. 33 (1979) 1-16.
#pragma once

#include <limits>

#include "contact/bodies.hpp"

namespace asperity {

/// A point contact.
struct Hertz {
  double radius = 0;    ///< √(ab) [m]: of the circle of equal area
  double pressure = 0;  ///< p₀ [Pa]
  double approach = 0;  ///< δ [m]
  double radius_x = 0;  ///< semi-axis along x [m]
  double radius_y = 0;  ///< semi-axis along y [m]
};

/// Whether (2) has an answer: both composite curvatures above 0 and finite, neither 1e100 times the other.
bool has_point_contact(const Bodies& bodies);

/// (2). Throws ParameterError("radius") where has_point_contact is false, ParameterError("load") where the
/// load is not above 0 and finite, and as Bodies::check does.
Hertz hertz(const Bodies& bodies, double load);

struct HertzLine {
  double half_width = 0;  ///< b [m]
  double pressure = 0;    ///< p₀ [Pa]
  double approach = 0;    ///< δ [m]; NaN without a datum
};

/// (5), (6) for the composite curvature 1/R [1/m], the load per length [N/m] and the datum [m].
HertzLine hertz_line(double composite_modulus, double curvature, double load_per_length,
                     double datum = std::numeric_limits<double>::quiet_NaN());

/// Whether the grid repeats along one axis and the bodies have a curvature across it.
bool has_line_contact(const Grid& grid, const Bodies& bodies);

/// (5), (6) of bodies in line contact under the load [N] on the grid, with its datum (contact/influence.hpp).
HertzLine hertz_line(const Grid& grid, const Bodies& bodies, double load);

}  // namespace asperity
