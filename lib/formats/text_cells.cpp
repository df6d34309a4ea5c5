#include "formats/text_cells.hpp"

#include <algorithm>

#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

// The end of a quoted cell: behind its second quote, a doubled one is part of it.
std::size_t end_of_quotes(std::string_view line) {
  std::size_t at = line.find('"', 1);
  while (at != line.npos && at + 1 < line.size() && line[at + 1] == '"') at = line.find('"', at + 2);
  return at == line.npos ? line.size() : at + 1;
}

}  // namespace

char character_of(Separator separator) {
  return separator == Separator::tab ? '\t' : separator == Separator::comma ? ',' : ';';
}

std::string_view take_cell(std::string_view& line, Separator separator, bool quotes) {
  const bool word = separator == Separator::blank;
  std::size_t from = 0;
  if (quotes) {
    const std::size_t first = line.find_first_not_of(separator == Separator::tab ? " " : blanks);
    if (first != line.npos && line[first] == '"') from = first + end_of_quotes(line.substr(first));
  }
  const std::size_t end = word ? line.find_first_of(blanks, from) : line.find(character_of(separator), from);
  std::string_view cell = trimmed(line.substr(0, end));
  line = end == line.npos ? std::string_view() : line.substr(end + 1);
  if (word && line.data() != nullptr)
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  if (from > 0 && cell.size() > 1 && cell.ends_with('"')) cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

std::string_view content_of(std::string_view line, Separator separator) {
  return separator == Separator::tab && line.find('\t') != line.npos ? line : trimmed(line);
}

bool is_comment(std::string_view line, Separator separator, const std::vector<std::string>& missing) {
  const bool semicolon = line.starts_with(';') && separator != Separator::semicolon;
  if (!line.starts_with('#') && !line.starts_with('%') && !semicolon) return false;
  std::string_view rest = line;
  const std::string_view first = take_cell(rest, separator, false);
  const bool blank = separator == Separator::blank;
  if (std::ranges::find(missing, first) != missing.end() && (first.size() > 1 || !blank)) return false;
  const auto is_number = [](std::string_view cell) {
    return number_of(cell) || number_of(cell, Comma::decimal_and_points);
  };
  if (first == "%") return blank || rest.data() == nullptr || !is_number(take_cell(rest, separator, false));
  if (!number_of(first)) return true;
  if (first.find_first_not_of('#') != first.npos) return false;
  bool number = false;
  for (; rest.data() != nullptr;) {
    const std::string_view cell = take_cell(rest, separator, false);
    if (!cell.empty() && !is_number(cell)) return true;
    number |= !cell.empty() && cell.front() != '#';
  }
  return !number;
}

std::vector<std::string_view> cells_of(std::string_view line, Separator separator, bool quotes) {
  std::vector<std::string_view> out;
  for (std::string_view rest = line; rest.data() != nullptr;)
    out.push_back(take_cell(rest, separator, quotes));
  return out;
}

}  // namespace asperity
