/// The form of a surface and its removal: the F-operation of ISO 25178-2.
///
/// Heights are measured from the polynomial of total degree d in x and y that fits them best in least
/// squares,
///     z(i,j) ≈ Σ_{a+b≤d} c_ab P_a(i) P_b(j),   c_ab = Σ_ij P_a(i) P_b(j) z(i,j),                      (1)
/// with P_0, P_1, … orthonormal over the indices (Gram's polynomials). On a full grid their products are
/// orthonormal too, and (1) is an exact projection. Degree 0 is the mean, 1 the mean plane, 2 removes a
/// spherical cap. Along an axis of n points the degree is at most n-1. If heights are missing, the sums run
/// over the measured points,
///     Σ_{a'b'} G_{ab,a'b'} c_a'b' = Σ P_a P_b z,                                                      (2)
///     G_{ab,a'b'} = Σ P_a(i) P_b(j) P_a'(i) P_b'(j) over the measured points,                         (3)
/// the unit matrix less the sum over the missing points. Missing points stay missing.
///
/// Accuracy  z(0,0) is subtracted first, an exact operation where heights vary by less than a factor of two:
///           roughness of 1 nm on an offset of 1 m keeps all its digits. (1) is applied once more to the
///           remaining heights: within ε √(nx ny) of the form's rms. (2) is solved three times; points for
///           which a pivot of (3) is below 1e-10 of the largest are refused.
/// Cost      degree 0: two passes over the data; else two of 4 (d+1) products a point; with missing heights
///           three, (d+1)² more a point and (d+1)⁴/4 a row.
///
/// J. P. Gram, J. reine angew. Math. 94 (1883) 41-73.
#pragma once

#include <array>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

inline constexpr int largest_form_degree = 20;

/// P_0, P_1, … up to the degree, or n - 1, over n points: a column each.
Eigen::MatrixXd gram_polynomials(Index n, int degree);
/// The products P_a P_b with a + b ≤ degree.
AxisProducts polynomials(Shape field, int degree);

/// A mean as the sum of a height of the field and a small difference, which has more digits than one double.
struct Mean {
  double base = 0, above = 0;

  double value() const { return base + above; }
};
/// Throws DataError("heights", …) when every point is missing.
Mean mean_above_base(const Field& z);
inline double mean(const Field& z) { return mean_above_base(z).value(); }

/// The heights above (1), or (2), in their place. Throws ParameterError("remove-form") unless 0 ≤ degree ≤ 20
/// and if the measured points do not determine the form, DataError as mean_above_base.
Field remove_form(Field heights, int degree = 0);

// ---- spheres and cylinders ----

/// Spheres and cylinders as forms: the F-operation of ISO 25178-2 for balls, lenses, pins and journals.
///
/// A sphere or a cylinder of curvature κ = 1/R passes through (0, 0, c) over the middle of the field, with
/// the unit normal n there. With d = (x, y, h), h = z - c,
///     F = κ/2 dᵀ M d + n·d = 0,   M = 1 (sphere),  M = 1 - a aᵀ (cylinder of axis a, a·n = 0).        (1)
/// Its solution h(x,y) near zero stays finite as κ → 0, the plane. The form makes the sum of squares
///     Σ (z(i,j) - c - h(x_i, y_j))²                                                                  (2)
/// least over c, n, κ and a: 4 or 5 parameters. (2) measures along z, as the heights of a map are given, not
/// along the normal. Gauss and Newton's iteration, damped by Levenberg and Marquardt, from the parabola
/// z ≈ Σ_{p+q≤2} c_pq x^p y^q.
///
/// R > 0 is a dome, whose centre lies below the heights, R < 0 a bowl. Periodic axes are treated as free.
///
/// Scope     The points must be within the sphere or the cylinder, to within their roughness: a map with the
///           foot of a ball is to be cropped or masked first.
/// Accuracy  round-off on an exact form: heights to 10 ε of their range, R to ε R²/L² of itself (L half the
///           diagonal of the field). Roughness σ of N independent points leaves an error of R about
///           10 R² σ/(L² √N).
/// Cost      a pass over the points a step, 3 to 10 steps.
///
/// J. J. Moré, The Levenberg-Marquardt algorithm, in: Numerical Analysis, Springer (1978) 105-116.

enum class CurvedShape { sphere, cylinder };

/// What fits best.
struct CurvedForm {
  CurvedShape shape = CurvedShape::sphere;
  double radius = 0;  ///< [m]; above zero a dome, below a bowl
  /// Of the sphere; of the cylinder the axis' point next to (0, 0, c) [m]. (0, 0) is the field's middle.
  std::array<double, 3> centre{};
  std::array<double, 3> axis{};    ///< a: of the cylinder, zero for a sphere
  std::array<double, 3> normal{};  ///< n
  double level = 0, rise = 0;      ///< c = level + rise [m], level the mean of the heights
  double rms = 0;                  ///< of the heights above the form [m]
  int steps = 0;                   ///< of the iteration

  /// The form's height above `level` at (x, y) [m]; NaN beyond its outline.
  double above_level(double x, double y) const;
};

/// Throws ParameterError("remove-form") where the points do not determine the form: fewer of them than it has
/// parameters, in a line, a curvature within three standard errors of zero (as if heights were independent),
/// or no convergence within 100 steps. Missing points do not count.
CurvedForm fit_curved_form(const Field& z, const Grid& grid, CurvedShape shape, int threads = 1);

/// Heights above the form; missing points stay missing.
Field above_form(const Field& z, const Grid& grid, const CurvedForm& form);

}  // namespace asperity
