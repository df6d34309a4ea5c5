/// Numbers in plain text: a matrix of heights, one line for each x or for each y, or points of a surface.
///
/// A line of the form `# units: um` states the unit of the values. Neither that nor the size need be there: a matrix says
/// little about itself. How its numbers are separated is in formats/text_table.hpp. Lines of x z or x y z are read where
/// Reading says that they are (formats/text_points.hpp); a matrix whose first columns look like coordinates is refused
/// until it says what they are, for a map of its columns would be no error that anyone sees.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

Map decode_text_matrix(std::string_view bytes, const Reading& reading);
std::string encode_text_matrix(const Map& map, Order order);

}  // namespace asperity
