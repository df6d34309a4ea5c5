/// A matrix of numbers in plain text: one line for each x, or for each y.
///
/// Lines that begin with # are comments; one of the form `# units: um` states the unit of the values. Neither that nor
/// the size need be there: a matrix says little about itself.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

Map decode_text_matrix(std::string_view bytes, Order order);
std::string encode_text_matrix(const Map& map, Order order);

}  // namespace asperity
