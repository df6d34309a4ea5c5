/// Refusals of a map's file.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"

namespace asperity {

/// Throws DataError("map", …).
template <class... Parts>
[[noreturn]] void refuse(fmt::format_string<Parts...> message, Parts&&... parts) {
  throw DataError("map", fmt::format(message, std::forward<Parts>(parts)...));
}

/// The same words in every format.
[[noreturn]] inline void refuse_cut_header() { refuse("the file is cut short: its header has no end"); }

/// Text from a file in quotes, shortened in the middle.
inline std::string quoted(std::string_view words) { return "'" + one_line(words, 24) + "'"; }

}  // namespace asperity
