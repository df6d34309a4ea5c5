/// The error that a grid leaves in the largest stress below a contact, and what it misses at an edge.
///
/// With m of core/halved.hpp over the maxima below the contact on n, n/2 and n/4 cells, and the depth in
/// cells c = max(1, z/h),
///     error of the value   max(0.28 m, 0.03/c² of it, 2e-5 of it),                               (1)
///     error of its depth   max(0.2 √c m', 0.02/c² z, 2e-4 z, 0.3 h exp(-2π(c - 1))),           (2)
///                          0.4 for 0.2 at a limit pressure;
/// m' with a tenth of the second difference in place of a quarter: depths on coarse cells jump. √c: the
/// deeper the maximum, the flatter, and the less its place settles from grid to grid. Cells hold the means of
/// a pressure, which lack (kh)²/24 of a wave k; those with k ~ 1/z make the maximum, so value and depth
/// lack a share of 1/c² although all grids may tell them alike. The steps between the cells fade as
/// exp(-2πz/h); down to one cell the search looks below the cells' centres alone, and the maximum jumps by
/// 0.3 h or so. What the search leaves: 2e-5, 2e-4. Where the limit pressure is reached and z < 2h the stress
/// is that of single cells' edges: a tenth of the value is added to (1), z to (2).
///
/// At an edge coarser cells hide what cells hide, and (1) does not show it. Friction stretches the surface
/// behind a contact and compresses it in front. At the trailing edge, where neither pressure nor traction
/// acts, the surface stresses of a sphere [1] and of a cylinder across the motion [2] are, in units of the
/// largest pressure,
///     σxx = (1-2ν)/3 + π(4+ν) μ/8,   σyy = -(1-2ν)/3 + 3πν μ/8,                                       (3)
///     σxx = 2μ,                      σyy = 2νμ,                                                        (4)
/// the first at rest in pure shear all along the edge. No tension of a sphere is larger than there; its von
/// Mises stress is the largest from μ = 0.305 on if ν = 0.3 (0.142, 0.194, 0.250 if ν = 0, 0.1, 0.2), below
/// that in the depth. From the edge the stress falls as the root of the distance: cells of side h find a
/// share of √(h/a) less, a the contact's radius. In front of the edge the stress is nearly level. At μ = 0.4
/// a grid of fewer than 40 cells to the radius, at 0.5 one of fewer than 90, finds the level, 7 and 4 % less.
/// Coarser grids are on the level together and agree within 0.3 %, and an extrapolation at order ½ leaves 1
/// to 5 %. What (3) and (4) make of the largest pressure does show it, without another grid: the cells have
/// that pressure within order 2.
///
/// Symbols   z depth of the largest stress [m]   n cells along a side
///           h side of a cell [m], of unequal ones √((Δx² + Δy²)/2), as their errors add
/// Scope     (3), (4): contacts whose pressure falls to 0 as a root, not at a limit pressure, where it falls
///           from its largest value within a narrow rim, and the stress of a sliding edge grows as the
///           logarithm of that. On a rough surface each contact has a largest pressure of its own, and (3) of
///           the largest of all is a bound.
/// Accuracy  validation/contact_grid_error: of 180 hard scenes, held out when (1) and (2) were found, 98 % of
///           the values and of the depths lie within their errors. Not in (2) is another maximum, as large
///           within its own error, that finer cells show instead: seen in 3 of 570 scenes. With friction:
///           tests/stress/maximum_error.cpp. At an edge, on 20 to 170 cells to a sphere's radius, 1.2 to 1.6
///           times what is missing of von Mises stress, 1.1 to 2.4 times of a tension
///           (validation/stress_edge).
///
/// [1] G. M. Hamilton, Explicit equations for the stresses beneath a sliding spherical contact, Proc. Inst.
///     Mech. Engrs 197C (1983) 53-59.
/// [2] K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.2.
#pragma once

#include <array>

#include "stress/maximum.hpp"

namespace asperity {

/// The larger of (3) and (4), in the largest pressure.
double edge_stress(Criterion of, double poisson, double friction);

/// How much larger the maximum may be because of an edge [Pa]: what is missing to edge_stress of the largest
/// pressure, and 1.5 % of that pressure, for the edge of cells is a stair. 0 where nothing is missing, and
/// under a periodic load that acts on every cell. At the limit pressure NaN, not known, where friction acts
/// or tension is searched for; otherwise 0. The search must begin at the surface.
double edge_error(const StressMaximum& maximum, Criterion of, const LoadedBody& body, bool at_limit_pressure);

/// Errors of the value and of the depth, from the maxima on n, n/2 and n/4 cells, the first below this body.
/// Where the search begins at the surface, (1) is no less than edge_error(), and both are NaN where that is.
StressMaximum maximum_error(const LoadedBody& body, const std::array<StressMaximum, 3>& maxima,
                            const StressSearch& search, bool at_limit_pressure);

}  // namespace asperity
