/// Deflated bytes in memory, read and written; no other code calls zlib.
#pragma once

#include <string>
#include <string_view>

#include "dataset/bytes.hpp"
#include "dataset/memory_bound.hpp"

namespace asperity {

/// Largest expansion by deflate: bytes from one compressed byte.
inline constexpr std::size_t most_inflated = 1032;

/// What is around the deflated bytes.
enum class Wrapper { gzip, zlib };

/// Inflates `bytes` to `size` bytes. Throws DataError("map", …) before allocation when `bytes` are too few
/// for this size, and when they are damaged, give another size, or are followed by other bytes
/// (dataset/bytes.hpp). Memory: the bytes inflated so far.
std::string inflated(std::string_view bytes, std::size_t size, Wrapper wrapper = Wrapper::gzip);

/// The content of a file that gzip has made, of less than 4 GiB; other bytes as they are. Throws as
/// inflated() does, and where it needs more memory than `memory` allows.
Bytes gunzipped(Bytes bytes, const MemoryBound& memory);

/// The same bytes between zlib's head and checksum, as inflated(…, Wrapper::zlib) reads them; at most 4 GiB.
std::string deflated(std::string_view bytes);

}  // namespace asperity
