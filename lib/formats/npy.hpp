/// NumPy's .npy, versions 1, 2 and 3.
///
///     \x93NUMPY, two bytes of version, the head's length (two bytes in version 1, else four, the least significant first)
///     {'descr': '<f8', 'fortran_order': False, 'shape': (5, 3), }
///     padded with blanks and ended by a line feed, and then the numbers
/// descr is < or > (the least or most significant byte first) or | (one byte), and f2, f4, f8, i1, i2, i4, i8, u1, u2, u4,
/// u8 or b1 (truth, 0 or 1). Arrays of two dimensions are read; Order says which index of the array is x, whichever way
/// the numbers lie in the file. NaN is a missing point. The file knows neither size nor units.
///
/// Written are doubles, '<f8', the last index fastest, in version 1 with the numbers at a multiple of 64 bytes.
///
/// NumPy reference, numpy.lib.format, https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html
#pragma once

#include <string>
#include <string_view>

#include "formats/map.hpp"

namespace asperity {

bool recognises_npy(std::string_view bytes);
Map decode_npy(std::string_view bytes, const Reading& reading);
std::string encode_npy(const Map& map, Order order);

}  // namespace asperity
