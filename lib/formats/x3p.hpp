/// X3P, ISO 5436-2 and ISO 25178-72: a zip archive of main.xml, which describes the map, and of its numbers.
///
///     Record1/Axes          CX, CY: AxisType I, Increment [m]; CZ: DataType I (int16), L (int32), F, D, and an Increment
///                           and Offset [m] that the numbers are multiplied by and shifted, 1 and 0 where they are absent
///     Record3               MatrixDimension SizeX, SizeY, SizeZ; DataLink to a file of numbers, little-endian, x running
///                           fastest, with its MD5; or DataList, a Datum each
///     md5checksum.hex       the MD5 of main.xml
/// Lengths are metres. A missing point is NaN, an empty Datum, or one whose bit (the least first) is 0 in the file that
/// ValidPointsLink names. Integers are signed, as openGPS and Gwyddion have them; SurfaceTopography's are not.
/// Elements are known by their names whatever the name space. A checksum that is there must be right. Profiles (PRF)
/// and clouds of points (PCL) are no maps, nor is more than one layer. Beside a DataList main.xml has at most 1 MiB, and
/// md5checksum.hex 64 KiB.
///
/// Memory    of reading, twice the map, and main.xml. A DataList is parsed by pieces.
///
/// Written are doubles, NaN where missing, stored without deflation, which saves 4 % of a measured surface's bytes.
///
/// ISO 25178-72:2017, Geometrical product specifications: Surface texture: Areal, part 72, XML file format x3p.
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_x3p(std::string_view bytes);
Map decode_x3p(std::string_view bytes, const Reading& reading);
/// Throws DataError for a map without a size, or of another quantity than a length.
std::string encode_x3p(const Map& map, Order order);

/// The MD5 of bytes, 32 digits in lower case.
std::string md5_of(std::string_view bytes);

}  // namespace asperity
