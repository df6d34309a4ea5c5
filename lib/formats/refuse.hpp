/// How a map's file is refused, and what of it is shown.
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

/// The beginning and the end of a file's words, quoted.
inline std::string quoted(std::string_view words) { return "'" + one_line(words, 24) + "'"; }

}  // namespace asperity
