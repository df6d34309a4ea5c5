/// Two elastic bodies, the gap between them before they touch, and Hertz's solutions for smooth ones.
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
/// A point contact, the undeformed gap h = A x² + B y² with A = 1/(2Rx) ≤ B = 1/(2Ry), is an ellipse with the
/// semi-axes a along x and b = k a along y [1]. With m = 1 - k² and complete elliptic integrals K(m), E(m),
///     B/A = [E/k² - K] / [K - E]                    gives k                                      (4)
///     a³  = 3Q (K - E) / (2π E* m A)                p₀ = 3Q / (2πab)       δ = p₀ b K / E*       (5)
///     p   = p₀ √(1 - x²/a² - y²/b²)                                                              (6)
/// and where A > B, x and y change places. In Carlson's forms [2], K = R_F(0, k², 1), K - E = m R_D(0, k²,
/// 1)/3, E/k² - K = m R_D(0, 1, k²)/3, nothing cancels for k → 1:
///     B/A = R_D(0, 1, k²) / R_D(0, k², 1)           a³ = Q R_D(0, k², 1) / (2π E* A)             (7)
/// For k = 1 these are the sphere's a = (3QR / 4E*)^⅓, δ = a²/R.
///
/// A line contact of parallel cylinders, of load q per length in plane strain, has
///     b = √(4qR / πE*)      p₀ = 2q / (πb)      p = p₀ √(1 - x²/b²)                              (8)
///     δ = q (1 + 2 ln(2d/b)) / (πE*),                                                            (9)
/// whose approach counts from a datum: the points at a distance d, which a line load does not move.
///
/// Symbols   E Young's modulus [Pa]   ν Poisson's ratio   R radius [m]   h gap [m]   z heights [m]
///           Q load [N]   q load per length [N/m]   a, b semi-axes of the contact, b half its width [m]
///           p₀ greatest pressure [Pa]   δ approach [m]   d datum [m]
/// Scope     (3) is the paraboloid of the bodies: relative error x²/(4R²). (5): both curvatures above 0, of
///           ratios up to 1e100. (8), (9): infinite length.
/// Accuracy  of (5) to (9) round-off, some 10 ε.
///
/// [1] H. Hertz, Über die Berührung fester elastischer Körper, J. reine angew. Math. 92 (1881) 156-171;
///     K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 3.3, 4.1, 4.2.
/// [2] B. C. Carlson, Computing elliptic integrals by duplication, Numer. Math. 33 (1979) 1-16.
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

/// A point contact.
struct Hertz {
  double radius = 0;    ///< √(ab) [m]: of the circle of equal area
  double pressure = 0;  ///< p₀ [Pa]
  double approach = 0;  ///< δ [m]
  double radius_x = 0;  ///< semi-axis along x [m]
  double radius_y = 0;  ///< semi-axis along y [m]
};

/// Whether (5) has an answer: both composite curvatures above 0 and finite, neither 1e100 times the other.
bool has_point_contact(const Bodies& bodies);

/// (5). Throws ParameterError("radius") where has_point_contact is false, ParameterError("load") where the
/// load is not above 0 and finite, and as Bodies::check does.
Hertz hertz(const Bodies& bodies, double load);

struct HertzLine {
  double half_width = 0;  ///< b [m]
  double pressure = 0;    ///< p₀ [Pa]
  double approach = 0;    ///< δ [m]; NaN without a datum
};

/// (8), (9) for the composite curvature 1/R [1/m], the load per length [N/m] and the datum [m].
HertzLine hertz_line(double composite_modulus, double curvature, double load_per_length,
                     double datum = std::numeric_limits<double>::quiet_NaN());

/// Whether the grid repeats along one axis and the bodies have a curvature across it.
bool has_line_contact(const Grid& grid, const Bodies& bodies);

/// (8), (9) of bodies in line contact under the load [N] on the grid, with its datum (contact/influence.hpp).
HertzLine hertz_line(const Grid& grid, const Bodies& bodies, double load);

}  // namespace asperity
