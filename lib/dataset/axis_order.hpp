/// The order of axes in Asperity, and in viewers and most other programs.
///
///                   Asperity                     viewers
///     field         name(x, y)                   name(y, x)
///     volume        name(z, x, y)                name(z, y, x)
///     z             depth, positive = "down"     height -depth, positive = "up", the deepest layer first
///     x, y          axis = "X", "Y"              without: VTK takes these for longitude and latitude
///     table         name(k, l), name(p, q), …    name(l, k), name(q, p), …, from programs that transpose all
///     coordinates   ascending                    of rasters often descending
///
/// VTK and ParaView use the last dimension of NetCDF as their first axis, and draw a z that is positive
/// upwards in place: with the right column, x, y and z appear correctly. Stress components always refer to
/// the left column, z downwards.
///
/// Accuracy  exact: a conversion and back is equal to the last bit. Depth 0 becomes height 0, not -0.
/// Cost      one pass, in blocks that stay in the cache, over variables in the other order or on a
///           descending coordinate.
#pragma once

#include "dataset/dataset.hpp"

namespace asperity {

/// Converts any dataset. Where x, y, a depth, a lag or a wave number descends, it is reversed with all
/// variables on it, so that each value keeps its coordinate; `history` and the notes each get a line on it.
Dataset to_native_axes(Dataset dataset);
/// Converts a dataset in Asperity's order.
Dataset to_viewer_axes(Dataset dataset);

}  // namespace asperity
