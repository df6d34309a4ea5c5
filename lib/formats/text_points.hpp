/// A map of points x z or x y z in any order.
///
/// The points lie on a grid (formats/text_grid.hpp). At least half of them must be given; the others are
/// missing. The spacing is the range of a coordinate divided by the number of steps. A profile x z has the
/// same spacing in y. Lines without any number are no points.
#pragma once

#include "formats/text_columns.hpp"

namespace asperity {

/// Heights in their own unit. Throws DataError("map", …) for points that are no grid, or given twice.
Map map_of_points(const Table& table, const Columns& columns);

}  // namespace asperity
