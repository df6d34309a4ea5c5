/// The head of a NetCDF file in its classic formats (CDF-1, CDF-2, CDF-5), before the library reads it.
///
/// The library takes memory for as many names, attributes and variables as the head claims, and beyond the
/// end of a file on disk it reads zeros. Here every count is compared with the bytes that are left, so that a
/// head that passes needs memory of the order of its own length, and the values of every variable must end
/// within the file.
///
///     head = magic numrecs list(dimension) list(attribute) list(variable)
///     list = tag count element…     name = length text padding
/// with counts of 32 bits, of 64 in CDF-5, big-endian, and all things padded to four bytes.
///
/// The NetCDF Users Guide, appendix B: File Format Specifications.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Throws DataError("dataset", …) for a classic file whose head claims more or less than there is.
void check_classic_head(std::string_view bytes);

/// The head at the front of a file of CDF-2 or CDF-5, for dimensions of these lengths and variables whose
/// values (of one record, where the length of their first dimension is and stays 0) have these bytes: they
/// follow it in order, each padded to four bytes.
std::string resized_head(std::string file, const std::vector<std::uint64_t>& lengths,
                         const std::vector<std::uint64_t>& bytes);

}  // namespace asperity
