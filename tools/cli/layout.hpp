/// Columns of text below headings, in lines as long as a terminal is wide.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace asperity::cli {

using Words = std::vector<std::string>;

inline constexpr std::size_t gap_width = 2;  ///< between columns
inline constexpr const char* gap = "  ";

enum class Side { left, right };

/// Places on a terminal: a µ takes one, and two bytes.
std::size_t width_of(std::string_view text);
std::size_t widest(const Words& texts);
/// Beside blanks; `side` is that of the text.
std::string padded(const std::string& text, std::size_t width, Side side);
/// Broken at blanks into lines of `width`; a longer word has a line of its own.
Words wrapped(const std::string& text, std::size_t width);
/// With an end of line, and an ellipsis where it is too long.
std::string line_of(std::string text, std::size_t width);

/// A column: what stands below a heading.
struct Shown {
  std::string heading;
  Words texts;
  Side side = Side::left;
  std::size_t width = 0;

  void measure();  ///< sets `width`
};

/// Of columns beside each other.
std::size_t total(const std::vector<Shown>& columns);
/// Line 0 is the headings.
std::string row_of(const std::vector<Shown>& columns, std::size_t line);
/// The headings and all rows.
std::string block(const std::vector<Shown>& columns, std::size_t rows, std::size_t width);

}  // namespace asperity::cli
