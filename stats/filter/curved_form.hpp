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
/// Scope     The points must lie within the sphere or the cylinder, to within their roughness: a map with the
///           foot of a ball is to be cropped or masked first.
/// Accuracy  round-off on an exact form: heights to 10 ε of their range, R to ε R²/L² of itself (L half the
///           diagonal of the field). Roughness σ of N independent points leaves an error of R about
///           10 R² σ/(L² √N).
/// Cost      a pass over the points a step, 3 to 10 steps.
///
/// J. J. Moré, The Levenberg-Marquardt algorithm, in: Numerical Analysis, Springer (1978) 105-116.
#pragma once

#include <array>

#include "core/field.hpp"

namespace asperity {

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
