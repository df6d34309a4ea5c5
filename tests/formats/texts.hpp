/// Texts to be read, and what is wrong with them.
#pragma once

#include "core/error.hpp"
#include "maps.hpp"

namespace asperity::test {

inline Field field(std::initializer_list<std::initializer_list<double>> rows) {
  Field out(static_cast<Index>(rows.size()), static_cast<Index>(rows.begin()->size()));
  Index i = 0;
  for (const auto& row : rows) {
    std::ranges::copy(row, out.row(i).begin());
    ++i;
  }
  return out;
}

inline std::string refusal(const std::string& text, const Reading& told = {}) {
  try {
    format::text.decode(text, told);
    return "read";
  } catch (const DataError& error) {
    return error.what();
  }
}

inline Reading told_columns(const std::string& columns) {
  Reading out;
  out.columns = columns;
  return out;
}

/// In UTF-16 with its mark, as Excel's "Unicode text"; characters of the basic plane only.
inline std::string utf16(std::u16string_view text, bool big = false) {
  std::string out = big ? "\xfe\xff" : "\xff\xfe";
  for (const char16_t c : text) {
    const char high = static_cast<char>(c >> 8), low = static_cast<char>(c & 0xff);
    out += big ? high : low;
    out += big ? low : high;
  }
  return out;
}

}  // namespace asperity::test
