/// ESRI's ASCII grid, as GDAL and geographic programs write it.
///
///     ncols 5                    points along a line, x
///     nrows 3                    lines, y; the first is the north, the largest y
///     xllcorner 0                where the grid stands (or xllcenter): required by others, of no meaning here
///     yllcorner 0
///     cellsize 1e-06             spacing; or dx and dy where the two differ, as GDAL has them
///     NODATA_value -9999         a missing point; may be left out, and may be nan
/// and nrows·ncols numbers, however they are broken into lines. Words in any case and order. The file knows no units:
/// lengths are taken for metres, and heights are metres until something else is said.
///
/// A value is missing when it is NODATA to within single precision, as which many programs hold it. NODATA is -9999 in what is
/// written, or a power of ten below everything where heights come near that.
///
/// GDAL, AAIGrid driver, https://gdal.org/drivers/raster/aaigrid.html
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_esri(std::string_view bytes);
Map decode_esri(std::string_view bytes, const Reading& reading);
/// Throws DataError("map", …) for a map without a size.
std::string encode_esri(const Map& map, Order order);

}  // namespace asperity
