/// A map on a grid of another spacing.
///
/// The heights are the waves and the form of transform/refinement.hpp, evaluated at the centres of the new
/// cells: up, all waves of the map; down, those longer than two new cells, so that none is taken for another
/// (the anti-alias filter, with a sharp limit: heights with steps ring by a tenth of the step).
///
/// A periodic axis keeps its length L, in n' = round(L/Δ') cells of L/n'. A free axis has the spacing Δ'
/// exactly, and as many cells as fit into its length, in its middle.
///
/// Accuracy  round-off for waves of a periodic axis below the limit, and for forms of degree 2 along a free
///           one; waves of a free axis as transform/refinement.hpp.
/// Cost      transforms of each row and column, three times their length on a free axis. Memory: the new
///           field, one of nx × n'y, and a transform of a row and a column per thread.
#pragma once

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"

namespace asperity {

/// The new grid. Throws ParameterError("spacing") unless 0 < Δ' ≤ half the length of each axis of more than
/// one point. An axis of one point stays.
Grid resampled_grid(const Grid& grid, double dx, double dy);

/// Heights on resampled_grid; throws DataError("heights", …) if a point is missing: fill it first.
Field resampled(const Field& z, const Grid& grid, double dx, double dy, int threads = 1);

// ---- maps turned and mirrored ----

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
