#include "tools/cli/layout.hpp"

#include <algorithm>
#include <utility>

#include "core/words.hpp"

namespace asperity::cli {

std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, Side side) {
  const std::string blanks(width - std::min(width, width_of(text)), ' ');
  return side == Side::left ? text + blanks : blanks + text;
}

std::size_t widest(const Words& texts) {
  std::size_t out = 0;
  for (const std::string& text : texts) out = std::max(out, width_of(text));
  return out;
}

Words wrapped(const std::string& text, std::size_t width) {
  Words lines(1);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    if (lines.back().empty())
      lines.back() = word;
    else if (width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

std::string line_of(std::string text, std::size_t width) {
  text.resize(text.find_last_not_of(' ') + 1);
  return (width_of(text) > width ? one_line(text, width) : text) + "\n";
}

void Shown::measure() { width = std::max(width_of(heading), cli::widest(texts)); }

std::size_t total(const std::vector<Shown>& columns) {
  std::size_t out = 0;
  for (const Shown& column : columns) out += (out ? gap_width : 0) + column.width;
  return out;
}

std::string row_of(const std::vector<Shown>& columns, std::size_t line) {
  std::string out;
  for (const Shown& column : columns)
    out += (&column == columns.data() ? "" : gap) +
           padded(line ? column.texts[line - 1] : column.heading, column.width, column.side);
  return out;
}

std::string block(const std::vector<Shown>& columns, std::size_t rows, std::size_t width) {
  std::string out;
  for (std::size_t line = 0; line <= rows; ++line) out += line_of(row_of(columns, line), width);
  return out;
}

}  // namespace asperity::cli
