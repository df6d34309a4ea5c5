/// What the grid leaves of a contact: the errors of its figures, from the same contact on coarser cells.
///
///     const CoarserContacts coarser = coarser_contacts(grid, gap, *influence, contact, parameters, bodies);
///     const GridErrors errors = grid_errors(grid, contact, coarser);
///
/// The contact of the mean gaps of 2 × 2 and of 4 × 4 cells is solved from the mean pressures. With a figure
/// v on n, n/2 and n/4 cells a side,
///     m = max(|v(n) - v(n/2)|, ¼ |v(n/2) - v(n/4)|)   (core/halved.hpp),                    (1)
/// and each error is a share of m (contact/grid_error.cpp). An order is not fitted: the figures of a rough
/// contact have none, and the first difference is near zero by accident. For the largest pressure the rise of
/// the parabolas through it and its neighbours counts too; the areas have errors of their own outline
/// (contact/outline.hpp). The load under an approach has the m of the mean gap, too, times the stiffness; the
/// elastic energy that of approach or gap, times the load; the work of flattening has the error of the
/// elastic energy at the least. Approaches count from the paraboloid (3) of contact/bodies.hpp at the cells'
/// centres, whose mean over 2 × 2 cells lies (Δx²/Rx + Δy²/Ry)/8 further apart; this is taken off.
///
/// The stiffness is that of a flat punch with the outline of the free cells, those in contact below the limit
/// pressure (contact/stiffness.hpp). Cells at the limit bear no further load, so the punch has an inner
/// outline around them, too. The area A_f of the free cells scatters by the root of the N sides of both, m
/// symmetries counted, and the stiffness follows the area:
///     error of the stiffness S   max(⅓ m, 0.3 √(N m)/A_f ΔxΔy S).                                    (2)
/// A wide ring of free cells has nearly this error; a narrow one less, as the logarithm of its width.
///
/// Symbols   v any figure   n cells along a side   Δx, Δy cell [m]   Rx, Ry radii of the gap [m]
/// Scope     a surface that the grid resolves (stats/hybrid/slopes.hpp); another has no contact to
///           converge to. The contact lies inside its domain. Errors are about the surface between the
///           samples as its own band limit has it, not as it was before it was sampled.
/// Accuracy  validation/contact_grid_error: how often the true error is within the stated one, by scene. Of
///           its hard scenes, held out when the shares were found: 96 to 100 % for every figure. Spheres on
///           8 to 40 cells the same. On 1 to 7 cells the largest pressure would be in 2 of 3 scenes: none
///           are told.
/// Cost      a quarter of the contact, or a third.
#pragma once

#include <array>
#include <limits>
#include <string>

#include "contact/bodies.hpp"
#include "contact/solver.hpp"

namespace asperity {

/// The contact on half as many cells along each side, and on a quarter as many.
struct CoarserContacts {
  std::array<Grid, 2> grid;
  std::array<Contact, 2> contact;
  bool under_approach = false;  ///< not under a load
  double limit_pressure = std::numeric_limits<double>::infinity();
  std::string unknown;  ///< why there are none; empty where there are
  double seconds = 0;
};

/// The sides that (1) needs: multiples of four, of 48 cells at least.
bool has_coarser_contacts(Shape shape);
/// Why no error of the grid can be given for a contact of so few cells, of its area neither; "" of more.
std::string too_few_cells(const Grid& grid, const Contact& contact);

/// Of a solved contact and what it was solved with, under its own load. Nothing is thrown: `unknown` says
/// why there are none.
CoarserContacts coarser_contacts(const Grid& grid, const Field& undeformed_gap, ElasticOperator& influence,
                                 const Contact& contact, const ContactParameters& parameters,
                                 const Bodies& bodies);

/// 95 % or so of true errors are smaller; NaN where not known, or given.
struct GridErrors {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double load = none;      ///< [N], under a prescribed approach
  double approach = none;  ///< [m], under a load
  double max_pressure = none, area = none, area_corrected = none, plastic_area = none, mean_gap = none,
         stiffness = none;                            ///< units as in Contact
  double elastic_energy = none, plastic_work = none;  ///< [J] (contact/energy.hpp)
};

GridErrors grid_errors(const Grid& grid, const Contact& contact, const CoarserContacts& coarser);

}  // namespace asperity
