/// The grid that the coordinates x and y of a dataset make, whatever program wrote them.
#pragma once

#include <string>
#include <vector>

#include "core/field.hpp"
#include "dataset/dataset.hpp"

namespace asperity {

/// The grid of a dataset. Of an axis whose attribute length and points agree, the finer of the two tells the spacing:
/// the points where the length is in single precision and they are not, else the length; where they do not agree, as
/// after cropping by a program that does not know the attribute, the points, and the grid is not periodic whatever its
/// axes say. Throws DataError when x or y is missing, has no size, or is not evenly spaced.
Grid grid_of(const Dataset& dataset);
/// Gives x and y the lengths and the `periodic` that grid_of takes, and returns a line on each length that was another.
std::vector<std::string> settle_lengths(Dataset& dataset);

}  // namespace asperity
