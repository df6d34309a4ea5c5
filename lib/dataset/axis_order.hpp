/// The order of axes: Asperity's own, and that of viewers and of most other programs.
///
///                   Asperity                     viewers
///     field         name(x, y)                   name(y, x)
///     volume        name(z, x, y)                name(z, y, x)
///     z             depth, positive = "down"     height -depth, positive = "up", the deepest layer first
///     x, y          axis = "X", "Y"              without, for VTK takes these for longitude and latitude
///     table         name(k, l), name(p, q), …    name(l, k), name(q, p), …, where a program transposes all
///     coordinates   ascending                    of rasters often descending
///
/// VTK and ParaView make NetCDF's last dimension their first axis, and place a z that is positive upwards
/// where it is: the right column shows x, y and z as they lie. Components of stress remain those of the left
/// column, z downwards.
///
/// Accuracy  exact: there and back is equal to the last bit. A depth of 0 is a height of 0, not of -0.
/// Cost      a pass, in blocks that stay in the cache, over what is in the other order or lies on a
///           coordinate that descends.
#pragma once

#include "dataset/dataset.hpp"

namespace asperity {

/// Of any dataset. Where x, y, a depth, a lag or a wave number descends, it and all that lies on it are
/// turned around, each value at its coordinate; a line in front of `history` and one of the notes say so.
Dataset to_native_axes(Dataset dataset);
/// Of a dataset in Asperity's order.
Dataset to_viewer_axes(Dataset dataset);

}  // namespace asperity
