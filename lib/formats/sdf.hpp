/// SDF, the surface data file of ISO 25178-71, in text and in binary.
///
///     aISO-1.0                   a for text, b for binary; ISO-1.0, ISO-2.0, or the proposal's BCR-1.0 before it
///     ManufacID = Asperity       10 characters in binary; CreateDate and ModDate 12 (day, month, year, hour, minute)
///     NumPoints = 5              points of a line, x; two bytes in binary, four in ISO-2.0. NumProfiles the lines, y
///     Xscale = 1e-6              spacing [m]; a double in binary, as are Yscale, Zscale, Zresolution
///     Zscale = 1                 metres of one unit of a number
///     Compression = 0            one byte in binary, as are DataType and CheckType; another than 0 is refused
///     DataType = 7               0 to 2 unsigned, 4 to 6 signed integers of 8, 16, 32 bits, 3 floats, 7 doubles
///     CheckType = 0
///     *
/// and the numbers, line by line from the least y, which end with another * or the file; text that follows is passed over, and a second map is refused. Names
/// stand in any order in text, and are left out in binary, where all is least significant byte first (the standard knows
/// no other) and the numbers follow the 81 bytes (85) at once; two fields of four bytes that Olympus puts between are known.
/// Yscale means nothing, and the spacing is unknown, where there is a single line.
///
/// A missing point is BAD in text. In binary it is NaN or the number that is furthest from 0 of a floating type, the
/// greatest of an unsigned one, and of a signed one the least; BCR means the greatest by it, and there both are missing.
///
/// Gwyddion's reader of text knows no missing points, neither the standard's BAD nor any other: it refuses `sdf-ascii`
/// that has some. Of binary it masks them; `sdf` is for it.
///
/// `sdf` is written with doubles, missing points NaN, `sdf-ascii` with the shortest decimal fractions: both exact. Each holds
/// heights in metres only, and 65535 points along each side at the most. Their dates are the first day of 2000, so that the
/// same map makes the same bytes.
///
/// ISO 25178-71:2017; the types and the missing values of BCR as Gwyddion 2.61 and sdfio read them.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_sdf(std::string_view bytes);
bool recognises_sdf_text(std::string_view bytes);
/// Of either kind.
Map decode_sdf(std::string_view bytes, const Reading& reading);
/// Throw DataError("map", …) for a map without a size, too large a one, or one of something else than heights.
std::string encode_sdf(const Map& map, Order order);
std::string encode_sdf_text(const Map& map, Order order);

}  // namespace asperity
