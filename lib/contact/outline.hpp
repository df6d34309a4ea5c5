/// The outline of a set of cells, and what it tells of the area within.
///
/// A cell counts as a whole once its pressure is above 0, so the area of all such cells is too large by a
/// share of the cells that the outline runs through. With N sides between a cell of the set and one that is
/// not,
///     A* = A - (π - 1 + ln 2)/24 · N ΔxΔy                                                        (1)
/// is free of that bias [1], where S Δx of the paper is N ΔxΔy on square cells. What is left of A* is
/// scatter, as the outline falls between the grid's lines: it adds up as √N, or as √(N m) where m - 1
/// symmetries repeat each piece of the outline m times.
///
/// Symbols   A area of the cells [m²]   A* corrected area [m²]   N sides   Δx, Δy cell [m]   S perimeter [m]
/// Under a limit pressure no area is below load / limit. Patches that are at it have no such bias: what (1)
/// takes off is in doubt by the share of the area that is plastic.
///
/// Accuracy  |A* - true| ≤ (0.5 √(N m) + 0.03 N) ΔxΔy, and A lies no further off than that and its bias: how
///           often, validation/contact_grid_error tells.
/// Cost      one pass over the cells.
///
/// [1] V. A. Yastrebov, G. Anciaux, J.-F. Molinari, On the accurate computation of the true contact-area in
///     mechanical contact of random rough surfaces, Tribol. Int. 114 (2017) 161-171, eq. (20).
#pragma once

#include <cmath>
#include <limits>

#include "contact/solver.hpp"

namespace asperity {

struct Outline {
  Index sides_x = 0, sides_y = 0;  ///< between neighbours along x (each Δy long) and along y (Δx)
  Index images = 1;  ///< mirrorings, turns and shifts by whole cells that carry the cells into themselves

  double sides() const { return static_cast<double>(sides_x + sides_y); }
  /// √(N m).
  double scatter() const { return std::sqrt(sides() * static_cast<double>(images)); }
  double perimeter(const Grid& grid) const {
    return static_cast<double>(sides_x) * grid.dy + static_cast<double>(sides_y) * grid.dx;
  }
};

/// Of the cells in this state or beyond: Contact::elastic for all in contact, Contact::plastic for those at
/// the limit pressure. The edge of a free domain is no side.
Outline outline(const Grid& grid, const Contact& contact, Contact::State least = Contact::elastic);

/// (1) [m²].
double corrected_area(const Grid& grid, const Contact& contact, const Outline& outline,
                      double limit_pressure = std::numeric_limits<double>::infinity());
/// Its scatter, and the doubt of plastic patches [m²].
double corrected_area_error(const Grid& grid, const Contact& contact, const Outline& outline);
/// The scatter of a corrected area [m²].
double area_scatter(const Grid& grid, const Outline& outline);
/// By how much the area of whole cells may be too large [m²]: its bias and the scatter.
double area_excess(const Grid& grid, const Outline& outline);

}  // namespace asperity
