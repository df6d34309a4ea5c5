/// Numbers, counts and foreign text in printed lines.
///
/// Text from files (units, names, titles, headers) may be invalid UTF-8, control the terminal (sequences of
/// ISO 6429), reverse the direction of writing, or be as long as the file. A dataset keeps it unchanged;
/// printed text passes through one_line, and text that must be UTF-8, as in JSON, through utf8_of. Invalid
/// bytes are read as Latin-1, which instruments write: "\xb5m" is µm.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace asperity {

/// The number at the beginning of a text, and the rest. Independent of the locale; a plus sign is refused.
template <class T>
struct Leading {
  T number = 0;           ///< beyond the range of T the nearest value of T, which may be an infinity
  std::string_view rest;  ///< the whole text if it does not begin with a number
  bool found = false, in_range = false;
};

/// As std::from_chars, of which libc++ has only that of whole numbers.
std::from_chars_result read_number(std::string_view text, double& number);
/// Zero or an infinity, for text of a number that is too small or too large.
double beyond_range(std::string_view number);

template <class T>
Leading<T> leading_number(std::string_view text) {
  Leading<T> out;
  std::from_chars_result read{};
  if constexpr (std::is_floating_point_v<T>)
    read = read_number(text, out.number);
  else
    read = std::from_chars(text.data(), text.data() + text.size(), out.number);
  out.rest = text.substr(static_cast<std::size_t>(read.ptr - text.data()));
  out.found = read.ec != std::errc::invalid_argument;
  out.in_range = read.ec == std::errc();
  if (read.ec != std::errc::result_out_of_range) return out;
  const std::string_view number = text.substr(0, text.size() - out.rest.size());
  if constexpr (std::is_floating_point_v<T>)
    out.number = beyond_range(number);
  else
    out.number = number.starts_with('-') ? std::numeric_limits<T>::min() : std::numeric_limits<T>::max();
  return out;
}

/// A whole word as a number; nothing if it is not a number, or beyond the range of T.
template <class T>
std::optional<T> to_number(std::string_view word) {
  const Leading<T> out = leading_number<T>(word);
  return out.in_range && out.rest.empty() ? std::optional(out.number) : std::nullopt;
}

/// The shortest text that reads back as the same number; "nan" for any NaN.
std::string shortest(double value);
/// Appends the same to a text.
void append_number(std::string& text, double value);
/// At most `digits` significant digits, like C's %.*g.
std::string in_digits(double value, int digits);
/// To three digits, for messages.
inline std::string number(double value) { return in_digits(value, 3); }
/// "1 surface", "2 surfaces": for plurals in s.
std::string counted(std::int64_t count, std::string_view thing);

/// Whether text is well-formed UTF-8 (Unicode 15, table 3-7).
bool is_utf8(std::string_view text);
/// The text itself if it is UTF-8; invalid bytes are converted from Latin-1.
std::string utf8_of(std::string_view text);

/// Largest number of characters in a line; longer than any file name without its folders.
inline constexpr std::size_t longest_line = 1000;
/// UTF-8 with blanks in place of line ends, control characters, changes of the direction of writing, and
/// characters not allowed in XML. If longer than `most` characters, an ellipsis replaces the middle: the
/// beginning of a message says where, its end what to do.
std::string one_line(std::string_view text, std::size_t most = longest_line);

}  // namespace asperity
