/// The area of contact: its outline and what that says of the area within, and its connected patches.
///
/// A cell counts as a whole once its pressure is above 0, so the area of all such cells is too large by a
/// share of the cells that the outline runs through. With N sides between a cell of the set and one that is
/// not,
///     A* = A - (π - 1 + ln 2)/24 · N ΔxΔy                                                        (1)
/// is free of that bias [1], where S Δx of the paper is N ΔxΔy on square cells. What is left of A* is
/// scatter, as the outline falls between the grid's lines: it adds up as √N, or as √(N m) where m - 1
/// symmetries repeat each piece of the outline m times. Under a limit pressure no area is below load / limit.
/// Patches that are at it have no such bias: what (1) takes off is in doubt by the share of the area that is
/// plastic.
///
/// Two cells in contact belong to one patch where they share a side (4-connected: cells that meet at a corner
/// alone touch in a point). Along a periodic axis cells at opposite edges share a side too. A patch
/// percolates along an axis
///     free      if it has cells at both ends of the domain,                                      (2)
///     periodic  if it is connected with its own image one or more periods away.                  (3)
/// For (3) each cell holds its offset, in periods, from the root of its patch. Two cells of one patch that
/// meet again with another offset have gone around the domain [2]. Patches are numbered from 1 by falling
/// size; of equal ones, that whose first cell comes first in memory.
///
/// Symbols   A area of the cells [m²]   A* corrected area [m²]   N sides   Δx, Δy cell [m]   S perimeter [m]
/// Accuracy  |A* - true| ≤ (0.5 √(N m) + 0.03 N) ΔxΔy, and A lies no further off than that and its bias:
///           validation/contact_grid_error shows how often.
/// Cost      the outline one pass over the cells; patches one pass of union-find by size with halving of
///           paths and one to number them, 32 bytes a cell.
///
/// [1] V. A. Yastrebov, G. Anciaux, J.-F. Molinari, On the accurate computation of the true contact-area in
///     mechanical contact of random rough surfaces, Tribol. Int. 114 (2017) 161-171, eq. (20).
/// [2] J. Machta, Y. S. Choi, A. Lucke, T. Schweizer, L. V. Chayes, Invaded cluster algorithm for Potts
///     models, Phys. Rev. E 54 (1996) 1332-1345.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

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

/// Of the cells from one state to the other: by default all in contact, from Contact::plastic on those at the
/// limit pressure, up to Contact::elastic those that carry a further load. The edge of a free domain is no
/// side.
Outline outline(const Grid& grid, const Contact& contact, Contact::State least = Contact::elastic,
                Contact::State most = Contact::plastic);

/// (1) [m²].
double corrected_area(const Grid& grid, const Contact& contact, const Outline& outline,
                      double limit_pressure = std::numeric_limits<double>::infinity());
/// Its scatter, and the doubt of plastic patches [m²].
double corrected_area_error(const Grid& grid, const Contact& contact, const Outline& outline);
/// The scatter of a corrected area [m²].
double area_scatter(const Grid& grid, const Outline& outline);
/// By how much the area of whole cells may be too large [m²]: its bias and the scatter.
double area_excess(const Grid& grid, const Outline& outline);

struct Patches {
  std::vector<std::int32_t> label;  ///< of each cell; 0: not in contact
  std::vector<Index> cells;         ///< of patch 1, 2, …; falls
  bool percolates_x = false, percolates_y = false;

  Index count() const { return static_cast<Index>(cells.size()); }
  Index largest() const { return cells.empty() ? 0 : cells.front(); }  ///< cells of the largest patch
};

/// The patches of the cells whose state is not 0, in the order of a Field.
Patches find_patches(const Grid& grid, std::span<const std::int8_t> state);

}  // namespace asperity
