/// The head of a NetCDF file in its classic formats (CDF-1, CDF-2, CDF-5), looked over before the library reads it.
///
/// The library takes memory for as many names, attributes and variables as the head claims, before it looks whether they
/// are there. Here every count is compared with the bytes that are left: a head that passes needs memory of the order of
/// its own length. And beyond the end of a file on disk the library reads zeros: here the values of every variable, which begin
/// where the head says, must end within the file.
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

/// Throws DataError("dataset", …) for the bytes of a classic file whose head claims more than they hold, or less, or is none.
void check_classic_head(std::string_view bytes);

/// The head at the front of a file of CDF-2 or CDF-5, for dimensions of these lengths and variables whose values (of one
/// record, where the length of their first dimension is and stays 0) have these bytes: they follow it in order, each
/// padded to four bytes.
std::string resized_head(std::string file, const std::vector<std::uint64_t>& lengths,
                         const std::vector<std::uint64_t>& bytes);

}  // namespace asperity
