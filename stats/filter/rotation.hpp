/// Maps turned and mirrored.
///
/// Turns go from x towards y. Quarter turns and mirrors move points and change none. Another angle φ has its
/// grid, of the same spacing, about the turned corners; a point p has the height at the map's own R(-φ)p,
///     z'(p) = Σ_ab l_a(u) l_b(v) z(i+a, j+b),                                                        (1)
/// by Lagrange's polynomials through the 6 × 6 points around it, near an edge through those next to it.
/// Outside the centres of the outer cells, and where one of the 36 is missing, a point is missing. Periodic
/// axes lend points across the seam, but the turned map is not periodic.
///
/// Accuracy  of (1), a wave of amplitude A and wave number q along an axis of spacing Δ: A (qΔ)⁶ 5/1024, five
///           times as much next to an edge; 3e-4 A for 10 points a wave. Exact for polynomials of degree 5.
/// Cost      (1) 36 products and twelve weights a point.
#pragma once

#include "core/field.hpp"
#include "stats/filter/axis.hpp"

namespace asperity {

/// Turned by so many quarters: 1 is 90° counter-clockwise, -1 clockwise.
Field turned_quarters(const Field& z, int quarters);
Grid turned_quarters(const Grid& grid, int quarters);

/// The grid about the map turned by φ [rad]; multiples of 90°, to 1e-12, as turned_quarters.
Grid rotated_grid(const Grid& grid, double angle);
/// (1) on rotated_grid. Throws ParameterError("rotate") unless the angle is finite.
Field rotated(const Field& z, const Grid& grid, double angle, int threads = 1);

/// z(-x, y) or z(x, -y): along this axis the first point becomes the last.
Field mirrored(const Field& z, Axis1D axis);

}  // namespace asperity
