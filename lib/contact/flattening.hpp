/// The plastic flattening that remains when a contact at its limit pressure is unloaded.
///
/// Where p = p_Y the pressed bodies would overlap by δ - g > 0 (contact/problem.hpp). This amount has yielded
/// and remains after unloading to p = 0; the elastic displacement springs back:
///     w  = max(0, -gap) where p = p_Y, 0 elsewhere      plastic flattening                     (1)
///     z' = z - w                                        heights of the unloaded surface        (2)
/// Under the same load z' carries the same pressure elastically: the undeformed gap is h + w, and
///     h + w + K p - δ = gap + w,  which is gap ≥ 0 where p = 0,  0 where 0 < p < p_Y,  0 where p = p_Y,  (3)
/// the conditions of elastic contact, whose solution is unique: the surface has shaken down.
///
/// Symbols   z heights [m]   w flattening [m]   gap, p, p_Y, δ, h, K as in contact/solver.hpp
/// Scope     no residual stress, no pile-up: what yields is gone from between the bodies.
/// Accuracy  (3) holds with the residual ε of the contact.
#pragma once

#include "contact/solver.hpp"

namespace asperity {

/// Limit pressure over the yield stress in tension (D. Tabor, The Hardness of Metals, 1951).
inline constexpr double hardness = 3;

/// w of (1) [m], with what loads before have left.
inline Field plastic_flattening(const Contact& contact) {
  Field out = (-contact.gap).max(0.0);
  const std::int8_t* state = contact.state.data() + contact.slabs().own().first * out.cols();
  for (Index i = 0; i < out.size(); ++i)
    if (state[i] != Contact::plastic) out.data()[i] = 0;
  if (contact.flattening.size() > 0) out += contact.flattening;
  return out;
}

}  // namespace asperity
