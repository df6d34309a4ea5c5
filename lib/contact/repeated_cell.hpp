/// Displacement of an elastic half-space under cells that repeat along one axis.
///
/// Over the periods L of an axis, here x, the sum of Love's integrals I(x, y) of contact/influence.hpp grows
/// as the logarithm of their number: a half-space under a line load q has no displacement of its own, only
///     u(y) = -(2q / πE*) ln(|y|/d),                                                          (1)
/// counted from the points at a distance d from the line, the datum, which is arbitrary [1]. With it
///     S(x, y) = lim_{N→∞} Σ_{|m|≤N} I(x + mL, y) - (8ab/L) ln((2N+1) L/d),                   (2)
/// whose mean along x is πE* times (1), averaged over the cell's width. Three cells are summed as they are.
/// The others are smooth in x: an even polynomial through ten points of each row. There cells up to |m| = M
/// are summed too, and the rest is, by Euler and Maclaurin's formula from X = x + (M + ½)L on,
///     Σ_{m>M} 1/r(x + mL) = [-ln((X + r)/d) - s² P₁/24 + 7 s⁴ P₃/960 - 31 s⁶ P₅/8064
///                            + 127 s⁸ P₇/30720 + …] / L,   r² = X² + y²,   s = L/r,          (3)
/// with Legendre's polynomials Pₙ(X/r), averaged over the cell by Gauss's rule.
///
/// Symbols   u displacement into the body [m]   q load per length [N/m]   E* composite modulus [Pa]
///           a, b half sides of a cell along and across [m]   L period [m]   d datum [m]
/// Accuracy  1e-12 of S(0, 0), against sums over 10⁵ images; (3) with M ≥ 12 leaves 1e-13 of 8ab/L.
/// Cost      set-up: some 7 µs a row, more where a cell is longer across than the period. Then 30 ns a value.
///
/// [1] K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), sections 2.2, 4.2.
#pragma once

#include <array>
#include <vector>

#include "core/field.hpp"

namespace asperity {

/// S of (2) between the cells of a grid.
class RepeatedCell {
 public:
  /// Cells of half sides a, b [m], of which `period` repeat, for distances of up to rows - 1 cells across.
  RepeatedCell(double a, double b, Index period, Index rows, double datum, int threads = 1);

  /// S [m] at a distance of i cells along, |i| ≤ period/2, and j across, 0 ≤ j < rows.
  double operator()(Index i, Index j) const;

 private:
  static constexpr std::size_t points = 10;
  using Series = std::array<double, points>;  ///< of Chebyshev's polynomials of 8 (x/L)² - 1

  Series far_cells(double y, double datum) const;

  double a_, b_, length_;
  std::vector<Series> far_;  ///< of each row
};

}  // namespace asperity
