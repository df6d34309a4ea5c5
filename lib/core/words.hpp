/// Numbers, counts and other people's text, as they stand in a line that is read by eyes.
///
/// Text from files, units, names, titles and heads, may be no UTF-8, speak to the terminal (sequences of ISO
/// 6429), reverse what follows it, or be as long as the file. A dataset keeps it as it came; what is shown
/// passes through one_line, what must be UTF-8, as in JSON, through utf8_of. Bytes that are no UTF-8 are
/// taken as Latin-1, which instruments write: "\xb5m" is µm.
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace asperity {

/// The number that a text begins with, and what follows it. No locale matters; a plus is no sign.
template <class T>
struct Leading {
  T number = 0;           ///< where it is beyond the range of T, the nearest one that T has, an infinity too
  std::string_view rest;  ///< the whole text where it begins with no number
  bool found = false, in_range = false;
};

/// Zero, or an infinity: of a number that is too small or too large, as text.
double beyond_range(std::string_view number);

template <class T>
Leading<T> leading_number(std::string_view text) {
  Leading<T> out;
  const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), out.number);
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

/// A whole word as a number; nothing where it is none, or beyond the range of T.
template <class T>
std::optional<T> to_number(std::string_view word) {
  const Leading<T> out = leading_number<T>(word);
  return out.in_range && out.rest.empty() ? std::optional(out.number) : std::nullopt;
}

/// The shortest text that reads back as the same number; "nan" whatever its sign.
std::string shortest(double value);
/// The same behind a text.
void append_number(std::string& text, double value);
/// At most so many significant digits, as C's %.*g.
std::string in_digits(double value, int digits);
/// To three digits, for messages.
inline std::string number(double value) { return in_digits(value, 3); }
/// "1 surface", "2 surfaces": of what has its plural in s.
std::string counted(std::int64_t count, std::string_view thing);

/// Whether text is well-formed UTF-8 (Unicode 15, table 3-7).
bool is_utf8(std::string_view text);
/// The text itself if it is UTF-8; each byte that is none of a character becomes the one of that number,
/// Latin-1's.
std::string utf8_of(std::string_view text);

/// Characters of a line, at most; a name of a file is shorter, but for its folders.
inline constexpr std::size_t longest_line = 1000;
/// UTF-8 with blanks for what ends a line, speaks to a terminal or turns the direction of writing, or that
/// XML does not know. Of more characters than `most` the middle gives way to an ellipsis: a message's
/// beginning says where, its end what to do.
std::string one_line(std::string_view text, std::size_t most = longest_line);

}  // namespace asperity
