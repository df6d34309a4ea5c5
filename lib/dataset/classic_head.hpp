/// Checks the header of a NetCDF file in the classic formats (CDF-1, CDF-2, CDF-5) before the library reads
/// it.
///
/// The library allocates memory for as many names, attributes and variables as the header claims, and reads
/// zeros beyond the end of a file on disk. Here every count is compared with the remaining bytes, so that an
/// accepted header needs memory proportional to its length, and all variables end within the file.
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

/// Throws DataError("dataset", …) for a classic file whose header claims more or fewer bytes than it has.
void check_classic_head(std::string_view bytes);

/// The header of a CDF-2 or CDF-5 file, changed to dimensions of these lengths and variables of these sizes
/// in bytes (of one record, if the length of the first dimension is and stays 0). The values follow in order,
/// each padded to four bytes.
std::string resized_head(std::string file, const std::vector<std::uint64_t>& lengths,
                         const std::vector<std::uint64_t>& bytes);

}  // namespace asperity
