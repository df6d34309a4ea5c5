/// Gwyddion's export of a channel as text.
///
///     # Channel: ZSensor
///     # Width: 10.00 µm          along a line, x; and the height along y, each with a unit of its own
///     # Height: 10.00 µm
///     # Value units: m
/// and a line of values for each y, from the top of the image, which is the least y here. Its languages translate the
/// words: the two that are followed by a number and a length are the size, whatever they are called, the first of them the
/// width. Decimal commas and exponents of three digits are understood. The file says the size of pixels' whole area.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_gwyddion_text(std::string_view bytes);
Map decode_gwyddion_text(std::string_view bytes, const Reading& reading);
std::string encode_gwyddion_text(const Map& map, Order order);

}  // namespace asperity
