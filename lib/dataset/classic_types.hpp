/// What the reader and the writer of NetCDF's classic formats share: numbers of types, tags of lists, limits.
#pragma once

#include <array>
#include <cstdint>

#include "dataset/dataset.hpp"

namespace asperity::classic {

enum Tag : std::uint32_t { absent = 0, dimensions = 10, variables = 11, attributes = 12 };

/// NC_MAX_NAME, NC_MAX_VAR_DIMS, NC_MAX_VARS and NC_MAX_ATTRS of the NetCDF library, which overruns buffers
/// of the first two sizes, and compares each name with all before it.
constexpr std::uint64_t longest_name = 256, highest_rank = 1024, longest_list = 8192;

/// One for each alternative of Values, in their order: NC_CHAR, NC_BYTE, NC_UBYTE, …
constexpr std::array<std::uint32_t, std::variant_size_v<Values>> types{2, 1, 7, 3, 8, 4, 9, 10, 11, 5, 6};

constexpr std::uint32_t type_of(const Values& values) { return types[values.index()]; }
/// CDF-2 ends at NC_DOUBLE.
constexpr bool needs_cdf5(const Values& values) { return type_of(values) > 6; }

constexpr std::uint64_t padded(std::uint64_t bytes) { return (bytes + 3) / 4 * 4; }

constexpr const char* kind_of(Tag tag) {
  return tag == dimensions ? " dimensions" : tag == variables ? " variables" : " attributes";
}

}  // namespace asperity::classic
