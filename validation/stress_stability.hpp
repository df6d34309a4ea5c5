/// Round-off of the stress where it may hurt: flat cells, depths far from the cells' size, pressures of many
/// orders.
#pragma once

namespace asperity {

/// Rows of one loaded cell, and of a pressure over twelve decades, against the same sums in long double: the
/// largest error in a layer, over the largest pressure and over the layer's largest stress, the worst for ν =
/// 0 … ½ without friction and with μ = 0.5 at 0.6 rad.
void print_stability();

}  // namespace asperity
