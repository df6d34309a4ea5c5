/// The largest stress at an edge of a smooth contact, which a grid shows in part only, and what it misses.
///
/// Friction draws the surface behind a contact and presses it in front. At the trailing edge, where neither
/// pressure nor traction acts, the surface stresses of a sphere [1] and of a cylinder across the motion [2]
/// are, in units of the largest pressure,
///     σxx = (1-2ν)/3 + π(4+ν) μ/8,   σyy = -(1-2ν)/3 + 3πν μ/8,                                       (1)
///     σxx = 2μ,                      σyy = 2νμ,                                                        (2)
/// the first at rest in pure shear all along the edge. No tension of a sphere is larger than there; its von
/// Mises stress is the largest from μ = 0.305 on if ν = 0.3 (0.142, 0.194, 0.250 if ν = 0, 0.1, 0.2), below
/// that in the depth.
///
/// From the edge the stress falls as the root of the distance: cells of side h find a share of √(h/a) less, a
/// the contact's radius. In front of the edge the stress is nearly level. At μ = 0.4 a grid of fewer than 40
/// cells to the radius, at 0.5 one of fewer than 90, finds the level, 7 and 4 % less. Coarser grids do not
/// tell: they are on the level together and agree within 0.3 %, and an extrapolation at order ½ leaves 1 to
/// 5 %. What (1) and (2) make of the largest pressure does tell, without another grid: the cells have that
/// pressure within order 2.
///
/// Scope     contacts whose pressure falls to 0 as a root: not at a limit pressure, where it falls from its
///           largest value within a narrow rim, and the stress of a sliding edge grows as the logarithm of
///           that. On a rough surface each contact has a largest pressure of its own, and (1) of the largest
///           of all is a bound.
/// Accuracy  on 20 to 170 cells to a sphere's radius 1.2 to 1.6 times what is missing of von Mises stress,
///           1.1 to 2.4 times of a tension (validation/stress_edge).
///
/// [1] G. M. Hamilton, Explicit equations for the stresses beneath a sliding spherical contact, Proc. Inst.
///     Mech. Engrs 197C (1983) 53-59.
/// [2] K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.2.
#pragma once

#include "stress/load.hpp"
#include "stress/maximum.hpp"

namespace asperity {

/// The larger of (1) and (2), in the largest pressure.
double edge_stress(Criterion of, double poisson, double friction);

/// How much larger the maximum may be because of an edge [Pa]: what is missing to edge_stress of the largest
/// pressure, and 1.5 % of that pressure, for the edge of cells is a stair. 0 where nothing is missing, and
/// under a periodic load that acts on every cell. At the limit pressure NaN, not known, where friction acts
/// or tension is asked for; otherwise 0. The search is one from the surface on.
double edge_error(const StressMaximum& maximum, Criterion of, const LoadedBody& body, bool at_limit_pressure);

}  // namespace asperity
