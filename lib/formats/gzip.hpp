/// Gzip in memory, the only door to zlib.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Deflating makes of a byte this many at the most.
inline constexpr std::size_t most_inflated = 1032;

/// The `size` bytes that `bytes` inflate to. Throws DataError("map", …) before memory is taken for a size
/// that so few cannot yield, and when they are damaged, fewer or more, or followed by other bytes
/// (dataset/bytes.hpp). Memory: what has been inflated, whatever is claimed.
std::string inflated(std::string_view bytes, std::size_t size);

}  // namespace asperity
