/// Fields of a dataset for a page: small enough to be carried, in full where they are.
///
/// A field of more points is shown by means over blocks of them, states and counts by the point in the middle
/// of each block; single points may then be higher or lower than what is shown, and the page says so.
#pragma once

#include <string>
#include <vector>

#include "dataset/dataset.hpp"

namespace asperity::report {

/// The fields on more than one row and column, `first` before the others; none without a grid.
std::vector<std::string> fields_of(const Dataset& data, const std::string& first);
/// Whether there is a von Mises stress on ascending depths, which viewer() shows below a field.
bool has_volume(const Dataset& data);

/// These fields alone, in SI, with at most so many blocks along a side. Missing: blocks without a point.
Dataset in_blocks(const Dataset& data, const std::vector<std::string>& names, Index most);

/// The live field: controls, canvases, and the data that field.js reads, of whole numbers of 16 bits, those
/// of the von Mises stress of 8. "" without a field.
std::string viewer(const Dataset& data, const std::vector<std::string>& names);

}  // namespace asperity::report
