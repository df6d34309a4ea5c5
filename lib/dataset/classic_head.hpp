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

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "dataset/dataset.hpp"
#include "dataset/unread.hpp"

namespace asperity {

// ---- what the reader and the writer share ----

namespace classic {

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

}  // namespace classic

// Numbers in the byte order of these formats, in place or appended to bytes.

/// The unsigned integer of as many bytes.
template <std::size_t bytes>
using BitsOf =
    std::conditional_t<bytes == 1, std::uint8_t,
                       std::conditional_t<bytes == 2, std::uint16_t,
                                          std::conditional_t<bytes == 4, std::uint32_t, std::uint64_t>>>;

/// Native order from big-endian, or back.
template <class Element>
Element swapped(Element value) {
  if constexpr (std::endian::native == std::endian::big || sizeof(Element) == 1) return value;
  const auto bits = std::bit_cast<BitsOf<sizeof(Element)>>(value);
  if constexpr (sizeof(Element) == 2) return std::bit_cast<Element>(__builtin_bswap16(bits));
  if constexpr (sizeof(Element) == 4) return std::bit_cast<Element>(__builtin_bswap32(bits));
  if constexpr (sizeof(Element) == 8) return std::bit_cast<Element>(std::uint64_t{__builtin_bswap64(bits)});
}

template <class Element>
void swap_bytes(std::span<Element> values) {
  for (Element& value : values) value = swapped(value);
}

template <class Element>
void append_big_endian(std::string& bytes, std::span<const Element> values) {
  const std::size_t before = bytes.size();
  bytes.resize(before + values.size_bytes());
  for (char* at = bytes.data() + before; const Element value : values) {
    const Element big = swapped(value);
    std::memcpy(at, &big, sizeof big);
    at += sizeof big;
  }
}

// ---- the reader ----

/// The dataset of a classic file with all values unread. `bytes` are the whole file, of which only the header
/// is looked at, and what follows the values; `source` gives the same bytes. Throws DataError("dataset") for
/// a header that claims more or fewer bytes than the file has.
Dataset read_classic_head(std::string_view bytes, const std::shared_ptr<const Source>& source);

}  // namespace asperity
