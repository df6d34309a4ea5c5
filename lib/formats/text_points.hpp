/// Points of a surface in lines of text, x z or x y z, and whether a table holds such points.
///
/// The coordinates are those of a grid: along each axis evenly spaced to a twentieth of the spacing, in any order. A point that
/// is not given is missing; at least half of them are there. The spacing is the range of the coordinate by the number of
/// steps. A profile x z has its spacing in y too.
#pragma once

#include "formats/map.hpp"

namespace asperity {

/// Whether the columns are not all heights, to the eye: the first one ascends or descends in even steps where the last one
/// does not; the first of two does so steadily; the first two of three stand on a grid, or one of them never turns; or the
/// first line ascends evenly too, whatever stands in the corner.
bool has_coordinates(const Field& lines);

/// The map of lines of x z or x y z, x and y in `metres`. Throws DataError("map", …) where they are no grid.
Map map_of_points(const Field& lines, double metres);

}  // namespace asperity
