/// The header of a NetCDF file in the classic formats (CDF-1, CDF-2, CDF-5).
///
/// A header may claim any number of names, attributes and values. Here every count is compared with the
/// remaining bytes before memory is allocated, so that an accepted header needs memory proportional to its
/// length. All variables end within the file and share no byte with the header or each other; no name is
/// twice among the dimensions, the variables, or the attributes of one variable.
///
///     head = magic numrecs list(dimension) list(attribute) list(variable)
///     list = tag count element…     name = length text padding
/// with counts of 32 bits, of 64 in CDF-5, big-endian, and all things padded to four bytes.
///
/// The NetCDF Users Guide, appendix B: File Format Specifications.
#pragma once

#include <memory>
#include <string_view>

#include "dataset/dataset.hpp"
#include "dataset/unread.hpp"

namespace asperity {

/// The dataset of a classic file with all values unread. `bytes` are the whole file, of which only the header
/// is looked at, and what follows the values; `source` gives the same bytes. Throws DataError("dataset") for
/// a header that claims more or fewer bytes than the file has.
Dataset read_classic_head(std::string_view bytes, const std::shared_ptr<const Source>& source);

}  // namespace asperity
