/// Numbers in the byte order of NetCDF's classic formats, in place or appended to bytes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

namespace asperity {

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

}  // namespace asperity
