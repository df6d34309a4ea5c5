/// What a load leaves in a contact: elastic energy, plastic flattening and its work.
///
///     U   = ½ ∫ p u dA               elastic energy, given back on unloading                 (1)
///     W_p = p_Y ∫ w dA               work of plastic flattening, lost                        (2)
/// With E(δ) the least of ½ p·Kp + (h - δ)·p under 0 ≤ p ≤ p_Y (contact/problem.hpp), dE/dδ = -Q, and the
/// conditions of contact make E = -U - W_p: along a rising load, from where the bodies first touch,
///     U + W_p = ∫ Q dδ.                                                                       (3)
/// On a periodic grid K moves no mean plane, and (3) holds for δ between the mean planes. Where it repeats
/// along one axis alone, U and δ count from the same datum (contact/influence.hpp).
///
/// Where p = p_Y the pressed bodies would overlap by δ - g > 0. This amount has yielded and remains after
/// unloading to p = 0; the elastic displacement springs back:
///     w  = max(0, -gap) where p = p_Y, 0 elsewhere      plastic flattening                     (4)
///     z' = z - w                                        heights of the unloaded surface        (5)
/// Under the same load z' carries the same pressure elastically: the undeformed gap is h + w, and
///     h + w + K p - δ = gap + w,  which is gap ≥ 0 where p = 0,  0 where 0 < p < p_Y,  0 where p = p_Y,  (6)
/// the conditions of elastic contact, whose solution is unique: the surface has shaken down.
///
/// Symbols   p pressure [Pa]   p_Y limit pressure [Pa]   u = K p displacement [m]   w flattening [m]
///           Q load [N]   δ approach [m]   h undeformed gap [m]   z heights [m]   gap: contact/solver.hpp
/// Scope     no residual stress, no pile-up: what yields is gone from between the bodies.
/// Accuracy  (1) errs by the square of the residual ε of the contact, (2) and (6) by ε.
///
/// K. L. Johnson, Contact Mechanics, Cambridge University Press (1985), section 5.3, for (1) and (3) of
/// elastic bodies.
#pragma once

#include "contact/solver.hpp"

namespace asperity {

/// Limit pressure over the yield stress in tension (D. Tabor, The Hardness of Metals, 1951).
inline constexpr double hardness = 3;

/// U of (1) [J].
double elastic_energy(const Grid& grid, const Contact& contact);

/// W_p of (2) [J]; 0 without a limit pressure.
double plastic_work(const Grid& grid, const Contact& contact, double limit_pressure);

/// w of (4) [m], with the flattening that an earlier, larger load left.
Field plastic_flattening(const Contact& contact);

}  // namespace asperity
