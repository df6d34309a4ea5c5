/// NRRD, nearly raw raster data, versions 1 to 5.
///
///     NRRD0004
///     type: double               signed or unsigned integers of 8 to 64 bits, float, double, by all their names
///     dimension: 2               or more, if no more than two axes are longer than 1
///     sizes: 5 3                 points along x, the fastest axis, and y, from the least on
///     spacings: 1e-06 2e-06      or axis mins and axis maxs (with centers), or space directions, whose lengths are taken:
///                            an axis against its space is turned around, a mirrored map refused
///     units: "m" "m"             of each axis (space units with space directions); where none is stated the size is unknown
///     sample units: "m"          of the values, with quotes (Gwyddion) or without (teem); nothing is assumed where there is none
///     content: heights           the title
///     endian: little             or big
///     encoding: raw              or text (ascii, txt), or gzip (gz)
/// in any order, then an empty line and the numbers. NaN is a missing point. Comments (#) and fields that say something else
/// are passed over. A header whose data stand in another file is refused, since a file that is read names no others to be
/// opened; so are line skip and byte skip, and the encodings hex and bzip2.
///
/// Written are raw doubles, the least significant byte first.
///
/// Definition of the NRRD file format, https://teem.sourceforge.net/nrrd/format.html
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_nrrd(std::string_view bytes);
Map decode_nrrd(std::string_view bytes, const Reading& reading);
std::string encode_nrrd(const Map& map, Order order);

}  // namespace asperity
