/// The largest stress of a sliding contact at its trailing edge, and what a grid misses of it.
///
/// Above some coefficient of friction a smooth sphere that slides bears its largest von Mises stress not in
/// the depth but at the surface, where the contact begins [1]. In front of that edge the stress is nearly
/// level, and at it rises as the root of the distance, on both sides. A grid that does not see the rise finds
/// the level: 7 % less at μ = 0.4 and 4 % at μ = 0.5 (ν = 0.3). One that does, from 40 or 85 cells across the
/// contact's radius a on, finds 0.44 √(h/a) of the stress less. Coarser grids do not tell that error: they
/// are on the level together and agree within 0.2 % where 4 % is missing, and an extrapolation at order ½ is
/// still 1 to 5 % off (validation/stress_edge). So only a bound is stated, shallow_error (stress/layers.hpp).
/// Tension is largest at an edge with friction or without; it converges at order ½ under friction, and at
/// rest is 5 % too large on every grid, by the steps of the edge.
///
/// [1] G. M. Hamilton, Explicit equations for the stresses beneath a sliding spherical contact, Proc. Inst.
///     Mech. Engrs 197C (1983) 53-59.
#pragma once

#include "stress/load.hpp"
#include "stress/maximum.hpp"

namespace asperity {

/// The coefficient of friction from which that edge of a smooth sphere bears the largest von Mises stress:
/// 0.305 for ν = 0.3, within 2e-3 for every ν; 0 where it does at rest, below ν = -0.34.
double edge_friction(double poisson);

/// Whether the load ends somewhere: not where a periodic one acts on every cell.
bool has_edge(const LoadedBody& body);

/// Whether a maximum is that of an edge: there is one, it lies above the accurate depth, and is one of
/// tension, or of friction not below edge_friction.
bool is_at_edge(const StressMaximum& maximum, Criterion of, const LoadedBody& body);

/// How far it may be from the largest stress, which lies between the cells [Pa]: shallow_error of the largest
/// pressure, for a tension 26 μ % of it more. For contacts ten cells in radius and more.
double edge_error(const LoadedBody& body, Criterion of);

}  // namespace asperity
