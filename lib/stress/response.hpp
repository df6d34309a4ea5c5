/// What the modes of the pressure answer in a layer: the product of (1) in stress/layer_influence.hpp, with friction.
///
/// A traction μx p along x and μy p along y has the modes of the pressure itself, so that of each mode
///     σ^ = (-i)^m (S + iT) p^,   T = ±μx X ± μy Y,                                                       (1)
/// where X and Y, the symbols of the tractions, stand a quarter turn from S for the one parity in which they differ.
#pragma once

#include "stress/layer_influence.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// `product` of component c for block b, from the block of the pressure. The weights are those of the tractions, per
/// pressure (stress/friction.hpp).
void respond(LayerInfluence& influence, const std::array<double, 3>& weights, stress::Component c, Index b,
             const PrunedTransform& transform, const Complex* pressure, Complex* product);

}  // namespace asperity
