/// The stiffness of a contact: how its load grows with the approach.
///
/// While no cell changes state, the gap stays 0 on the free cells C and the other pressures stay constant;
/// q = dp/dδ obeys
///     K q = 1 on C,   q = 0 elsewhere,                                                       (1)
///     S = dQ/dδ = ΔxΔy Σ q,                                                                   (2)
/// as for a flat punch with the outline of the contact, solved by conjugate gradients on C. For an
/// approximate q with u = K q,
///     S ≈ ΔxΔy Σ q (2 - u)                                                                    (3)
/// is low by ΔxΔy (q* - q)·K(q* - q), of the second order in the residual max|1 - u| on C; (2) errs by that
/// residual at most, relative, where q* ≥ 0.
///
/// Without free cells S = 0. Where every cell is free and K has no answer to a constant pressure (a periodic
/// surface in full contact), S = ∞. In its partial contact S is the fall of load with the mean gap.
///
/// Symbols   p pressure [Pa]   p_Y limit pressure [Pa]   q dp/dδ [Pa/m]   K elastic operator [m/Pa]
///           Q load [N]   S stiffness [N/m]   δ approach [m]   Δx, Δy cell [m]   a contact radius [m]
/// Scope     the solution's C: S is a staircase that steps up where a cell joins.
/// Accuracy  (3): round-off, 1e-10 or so at the residual of 1e-6 that is required. The outline's cells leave
///           of Hertz's 2aE* some 0.05 Δx/a, 0.2 Δx/a at most where the contact has 20 cells or more.
/// Cost      about half the convolutions of the solution, on its window: 5 for smooth spheres, up to 16 for
///           rough ones, 8…25 for periodic surfaces, more the sparser the contact.
///
/// J. R. Barber, Bounds on the electrical resistance between contacting elastic rough bodies,
/// Proc. R. Soc. Lond. A 459 (2003) 53-66.
#pragma once

#include <limits>

#include "contact/elastic_operator.hpp"

namespace asperity {

struct Stiffness {
  double value = std::numeric_limits<double>::quiet_NaN();     ///< S [N/m]; NaN where not converged
  double residual = std::numeric_limits<double>::quiet_NaN();  ///< max|1 - u| on C, from a fresh convolution
  double convolutions = 0, preconditionings = 0;               ///< on the body's cells
};

/// The residual at which S is accepted.
inline constexpr double stiffness_tolerance = 1e-6;

/// S for a solved pressure on the body's cells, within about this many convolutions.
Stiffness contact_stiffness(ElasticOperator& body, const Field& pressure, double limit_pressure,
                            double cell_area, double convolutions, int threads = 1);

}  // namespace asperity
