/// What the load has put into a contact: elastic energy, and the work of flattening.
///
///     U   = ½ ∫ p u dA               elastic energy, given back on unloading                 (1)
///     W_p = p_Y ∫ w dA               work of plastic flattening, lost                        (2)
/// With E(δ) the least of ½ p·Kp + (h - δ)·p under 0 ≤ p ≤ p_Y (contact/problem.hpp), dE/dδ = -Q, and the
/// conditions of contact make E = -U - W_p: along a rising load, from where the bodies first touch,
///     U + W_p = ∫ Q dδ.                                                                       (3)
/// On a periodic grid K moves no mean plane, and (3) holds for δ as told there, to the mean planes. Where it
/// repeats along one axis alone, U and δ count from the same datum (contact/influence.hpp).
///
/// Symbols   p pressure [Pa]   p_Y limit pressure [Pa]   u = K p displacement [m]   w flattening [m]
///           Q load [N]   δ approach [m]   h undeformed gap [m]
/// Accuracy  (1) errs by the square of the residual ε, (2) by ε.
///
/// K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), section 5.3, for (1) and (3) of
/// elastic bodies.
#pragma once

#include "contact/solver.hpp"

namespace asperity {

/// U of (1) [J].
double elastic_energy(const Grid& grid, const Contact& contact);

/// W_p of (2) [J]; 0 without a limit pressure.
double plastic_work(const Grid& grid, const Contact& contact, double limit_pressure);

}  // namespace asperity
