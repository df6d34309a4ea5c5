#include "formats/text_labels.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>

#include "core/error.hpp"
#include "dataset/units.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

bool is_alpha(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

std::string text(std::string_view words) { return std::string(trimmed(words)); }

// "x [mm]" or "Height (um)"; nothing without brackets at the end.
Label in_brackets(std::string_view cell) {
  const bool square = cell.ends_with(']');
  if (!square && !cell.ends_with(')')) return {};
  const std::size_t open = cell.find_last_of(square ? '[' : '(');
  if (open == cell.npos) return {};
  const std::string unit = text(cell.substr(open + 1, cell.size() - open - 2));
  if (unit.empty() || (!square && !is_length(unit))) return {};
  return {text(cell.substr(0, open)), unit};
}

// "z/nm", "x in mm", "x, mm", "z_um".
Label behind_mark(std::string_view cell) {
  for (const std::string_view mark : {"/", " in ", ","}) {
    const std::size_t at = cell.rfind(mark);
    if (at == cell.npos || at == 0) continue;
    const std::string unit = text(cell.substr(at + mark.size()));
    if (is_length(unit)) return {text(cell.substr(0, at)), unit};
  }
  for (const std::string_view unit : {"mm", "um", "\u00b5m", "\u03bcm", "nm"})
    if (cell.size() > unit.size() + 1 && cell.ends_with(unit) && cell[cell.size() - unit.size() - 1] == '_')
      return {text(cell.substr(0, cell.size() - unit.size() - 1)), std::string(unit)};
  return {};
}

// Cells of a line between blanks, those of units joined to their names.
std::vector<std::string> joined(const std::vector<std::string_view>& cells) {
  std::vector<std::string> out;
  bool open = false;
  for (const std::string_view cell : cells) {
    const bool unit = cell.starts_with('[') || cell.starts_with('(') || cell.starts_with('/');
    if (!out.empty() && (open || unit))
      out.back() += " " + std::string(cell);
    else
      out.emplace_back(cell);
    const bool begins = cell.starts_with('[') || cell.starts_with('(');
    open = (open || begins) && !cell.ends_with(']') && !cell.ends_with(')');
  }
  return out;
}

// A comment without the characters that make it one.
std::string_view without_mark(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("#%;"), line.size()));
  return trimmed(line);
}

// Of a line between `separator`, one for each column, or none.
std::vector<std::string> cells_between(const Table& table, std::string_view line, Separator separator,
                                       bool quotes) {
  const std::vector<std::string_view> cells = cells_of(line, separator, quotes);
  std::vector<std::string> out =
      separator == Separator::blank ? joined(cells) : std::vector<std::string>(cells.begin(), cells.end());
  const auto columns = static_cast<std::size_t>(table.columns);
  while (out.size() > columns && out.back().empty()) out.pop_back();
  const auto is_word = [](const std::string& cell) {
    return cell.empty() || (std::ranges::any_of(cell, is_alpha) && !number_of(cell));
  };
  if (out.size() != columns || !std::ranges::all_of(out, is_word)) return {};
  return out;
}

// A comment may have blanks between its words, whatever separates the numbers.
std::vector<std::string> cells_for(const Table& table, std::string_view line, bool quotes) {
  const Separator separator = table.dialect.separator;
  if (!is_comment(line, separator)) return cells_between(table, line, separator, quotes);
  line = without_mark(line);
  const std::vector<std::string> out = cells_between(table, line, separator, quotes);
  return out.empty() ? cells_between(table, line, Separator::blank, quotes) : out;
}

// A unit alone, perhaps in brackets.
std::string unit_alone(const std::string& cell) {
  const Label label = in_brackets(cell);
  if (label.name.empty() && !label.unit.empty()) return label.unit;
  return is_length(cell) ? cell : "";
}

bool are_units(const std::vector<std::string>& cells) {
  bool some = false;
  for (const std::string& cell : cells) {
    if (!cell.empty() && unit_alone(cell).empty()) return false;
    some |= !cell.empty();
  }
  return some;
}

bool some_role(const std::vector<std::string>& cells) {
  return std::ranges::any_of(cells,
                             [](const std::string& cell) { return role_of(cell) != CoordinateRole::other; });
}

bool has_roles(const std::vector<Label>& labels) {
  return std::ranges::any_of(labels, [](const Label& l) { return role_of(l.name) != CoordinateRole::other; });
}

}  // namespace

bool is_length(std::string_view unit) try {
  if (unit.empty() || std::ranges::any_of(unit.substr(0, 1), [](char c) { return c == '-' || c == '('; }))
    return false;
  metres_per(unit);
  return true;
} catch (const DataError&) {
  return false;
}

bool is_unit(std::string_view unit) try {
  return !unit.empty() && is_alpha(unit.front()) && unit_factor(std::string(unit), std::string(unit)) > 0;
} catch (const std::invalid_argument&) {
  return false;
}

bool same_length(const std::string& a, const std::string& b) {
  return a == b || (is_length(a) && is_length(b) && metres_per(a) == metres_per(b));
}

Label label_of(std::string_view cell) {
  cell = trimmed(cell);
  if (const Label out = in_brackets(cell); !out.unit.empty()) return out;
  if (const Label out = behind_mark(cell); !out.unit.empty()) return out;
  return {std::string(cell), ""};
}

bool is_letter(const std::string& name) {
  return !name.empty() && is_alpha(name[0]) && (name.size() == 1 || !is_alpha(name[1]));
}

CoordinateRole role_of(const std::string& name) {
  constexpr std::string_view along[] = {"position", "distance", "lateral", "abstand", "strecke"},
                             up[] = {"height", "h\u00f6he", "h\xf6he",   "hoehe",
                                     "profil", "altitude",  "topograph", "elevation"},
                             neither[] = {"length", "width",      "number", "count",
                                          "filter", "l\u00e4nge", "breite"};
  const std::string word = lower(name);
  if (is_letter(word))
    return word[0] == 'x'   ? CoordinateRole::x
           : word[0] == 'y' ? CoordinateRole::y
           : word[0] == 'z' ? CoordinateRole::z
                            : CoordinateRole::other;
  const auto in_word = [&](std::string_view part) { return word.find(part) != word.npos; };
  const bool x = std::ranges::any_of(along, in_word), z = std::ranges::any_of(up, in_word);
  if (x == z || std::ranges::any_of(neither, in_word)) return CoordinateRole::other;
  return x ? CoordinateRole::x : CoordinateRole::z;
}

std::vector<Label> labels_of(const Table& table, bool quotes) {
  constexpr Index most_labels = 4096;   // more columns are those of a matrix
  constexpr std::size_t most_rows = 8;  // names, units and comments of plotting programs are three
  std::vector<std::vector<std::string>> rows;
  std::vector<Label> out, units;
  for (const HeadLine& line : table.columns > most_labels ? std::vector<HeadLine>() : table.head) {
    std::vector<std::string> cells = cells_for(table, line.text, quotes);
    const bool comment = is_comment(line.text, table.dialect.separator);
    if (!cells.empty() && !(comment && !some_role(cells) && !are_units(cells)))
      rows.push_back(std::move(cells));
    if (rows.size() > most_rows) rows.erase(rows.begin());
  }
  for (const std::vector<std::string>& cells : rows) {
    std::vector<Label> labels(cells.size());
    const bool alone = are_units(cells);
    std::ranges::transform(cells, labels.begin(), [&](const std::string& cell) {
      return alone ? Label{"", unit_alone(cell)} : label_of(cell);
    });
    if (alone)
      units = std::move(labels);
    else if (has_roles(labels) || !has_roles(out))
      out = std::move(labels);
  }
  if (out.empty()) return units;
  for (std::size_t i = 0; i < units.size(); ++i)
    if (out[i].unit.empty()) out[i].unit = units[i].unit;
  return out;
}

bool names_points(const Table& table, bool quotes) {
  if (table.columns != 2 && table.columns != 3) return false;
  const std::vector<Label> labels = labels_of(table, quotes);
  return !labels.empty() &&
         std::ranges::all_of(labels, [](const Label& l) { return role_of(l.name) != CoordinateRole::other; });
}

std::vector<HeadLine> without_labels(const Table& table, bool quotes) {
  std::vector<HeadLine> out;
  std::ranges::copy_if(table.head, std::back_inserter(out), [&](const HeadLine& line) {
    const std::vector<std::string> cells = cells_for(table, line.text, quotes);
    const auto has_unit = [](const std::string& cell) { return !label_of(cell).unit.empty(); };
    return !are_units(cells) && std::ranges::none_of(cells, has_unit);
  });
  return out;
}

}  // namespace asperity
