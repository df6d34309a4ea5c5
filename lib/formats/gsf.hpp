/// GSF, the Gwyddion Simple Field 1.0.
///
///     Gwyddion Simple Field 1.0
///     XRes = 5                   points along a line, x; required, as is YRes, the number of lines
///     XReal = 6.25e-07           size of the pixels' whole area, 1 if it is not stated; so is YReal
///     XYUnits = m                a unit of length, else the size is unknown
///     ZUnits = m                 of the values; nothing is assumed where it is not stated
///     Title = heights
/// then one to four NULs up to a multiple of four bytes, and the values: 32-bit floats, least significant byte first, line by
/// line from the top of the image, which is the least y here. NaN is a missing point. Other keys (XOffset, YOffset) are passed
/// over. Numbers are written with 24 bits, a relative error of 6e-8; those beyond 3.4e38 are refused.
///
/// Gwyddion user guide, Gwyddion Simple Field file format, http://gwyddion.net/documentation/user-guide-en/gsf.html
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_gsf(std::string_view bytes);
Map decode_gsf(std::string_view bytes, const Reading& reading);
std::string encode_gsf(const Map& map, Order order);

}  // namespace asperity
