#include "formats/text_head.hpp"

#include <algorithm>
#include <utility>

#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

std::string text_in(std::string_view words) { return std::string(trimmed(words)); }

// ---- labels ----

// "x [mm]" or "Height (um)"; nothing without brackets at the end.
Label in_brackets(std::string_view cell) {
  const bool square = cell.ends_with(']');
  if (!square && !cell.ends_with(')')) return {};
  const std::size_t open = cell.find_last_of(square ? '[' : '(');
  if (open == cell.npos) return {};
  const std::string unit = text_in(cell.substr(open + 1, cell.size() - open - 2));
  if (unit.empty() || (!square && !is_length(unit))) return {};
  return {text_in(cell.substr(0, open)), unit};
}

// "z/nm", "x in mm", "x, mm", "z_um".
Label after_mark(std::string_view cell) {
  for (const std::string_view mark : {"/", " in ", ","}) {
    const std::size_t at = cell.rfind(mark);
    if (at == cell.npos || at == 0) continue;
    const std::string unit = text_in(cell.substr(at + mark.size()));
    if (is_length(unit)) return {text_in(cell.substr(0, at)), unit};
  }
  for (const std::string_view unit : {"mm", "um", "\u00b5m", "\u03bcm", "nm"})
    if (cell.size() > unit.size() + 1 && cell.ends_with(unit) && cell[cell.size() - unit.size() - 1] == '_')
      return {text_in(cell.substr(0, cell.size() - unit.size() - 1)), std::string(unit)};
  return {};
}

// Cells of a line between blanks, those of units joined to their names.
std::vector<std::string> joined_cells(const std::vector<std::string_view>& cells) {
  std::vector<std::string> out;
  bool open = false;
  for (const std::string_view cell : cells) {
    const bool begins = cell.starts_with('[') || cell.starts_with('(');
    if (!out.empty() && (open || begins || cell.starts_with('/')))
      out.back() += " " + std::string(cell);
    else
      out.emplace_back(cell);
    open = (open || begins) && !cell.ends_with(']') && !cell.ends_with(')');
  }
  return out;
}

// Of a line between `separator`, one for each column, or none.
std::vector<std::string> cells_between(const Table& table, std::string_view line, Separator separator) {
  const auto cells = cells_of(line, {separator, Comma::none, table.dialect.quotes});
  std::vector<std::string> out = separator == Separator::blank
                                     ? joined_cells(cells)
                                     : std::vector<std::string>(cells.begin(), cells.end());
  const auto columns = static_cast<std::size_t>(table.columns);
  while (out.size() > columns && out.back().empty()) out.pop_back();
  const auto is_word = [](const std::string& cell) {
    return cell.empty() || (std::ranges::any_of(cell, is_alpha) && !number_of(cell));
  };
  if (out.size() != columns || !std::ranges::all_of(out, is_word)) return {};
  return out;
}

// A comment may have blanks between its words, whatever separates the numbers.
std::vector<std::string> cells_for(const Table& table, std::string_view line, bool comment) {
  if (comment) line = trimmed(line.substr(std::min(line.find_first_not_of("#%;"), line.size())));
  const std::vector<std::string> out = cells_between(table, line, table.dialect.separator);
  return comment && out.empty() ? cells_between(table, line, Separator::blank) : out;
}

// A unit alone, perhaps in brackets.
std::string unit_alone(const std::string& cell) {
  const Label label = in_brackets(cell);
  if (label.name.empty() && !label.unit.empty()) return label.unit;
  return is_length(cell) ? cell : "";
}

// One label for each cell; of a line of units alone, without names.
std::vector<Label> labels_in(const std::vector<std::string>& cells) {
  const auto empty = [](const std::string& cell) { return cell.empty(); };
  const bool alone = !std::ranges::all_of(cells, empty) && std::ranges::all_of(cells, [&](const auto& cell) {
    return empty(cell) || !unit_alone(cell).empty();
  });
  std::vector<Label> out(cells.size());
  std::ranges::transform(cells, out.begin(), [&](const std::string& cell) {
    return alone ? Label{"", unit_alone(cell)} : label_of(cell);
  });
  return out;
}

bool has_units(const std::vector<Label>& labels) {
  return std::ranges::any_of(labels, [](const Label& l) { return !l.unit.empty(); });
}

bool has_names(const std::vector<Label>& labels) {
  return std::ranges::any_of(labels, [](const Label& l) { return !l.name.empty(); });
}

bool has_roles(const std::vector<Label>& labels) {
  return std::ranges::any_of(labels, [](const Label& l) { return role_of(l.name) != CoordinateRole::other; });
}

// The last line that names coordinates, or else the last; with the last line of units alone.
std::vector<Label> chosen_labels(const std::vector<std::vector<Label>>& rows) {
  std::vector<Label> out, units;
  for (const std::vector<Label>& row : rows) {
    if (has_units(row) && !has_names(row))
      units = row;
    else if (has_roles(row) || !has_roles(out))
      out = row;
  }
  if (out.empty()) return units;
  for (std::size_t i = 0; i < units.size(); ++i)
    if (out[i].unit.empty()) out[i].unit = units[i].unit;
  return out;
}

}  // namespace

Label label_of(std::string_view cell) {
  cell = trimmed(cell);
  if (const Label out = in_brackets(cell); !out.unit.empty()) return out;
  if (const Label out = after_mark(cell); !out.unit.empty()) return out;
  return {std::string(cell), ""};
}

TextHead head_of(const Table& table) {
  constexpr Index most_labels = 4096;   // more columns are those of a matrix
  constexpr std::size_t most_rows = 8;  // names, units and comments of plotting programs are three
  TextHead out;
  std::vector<std::vector<Label>> rows;
  for (const HeadLine& line : table.head) {
    const bool comment = is_comment(line.text, table.dialect.separator);
    std::vector<Label> row = labels_in(cells_for(table, line.text, comment));
    if (!has_units(row)) out.others.push_back(line);
    const bool counts = !comment || has_roles(row) || (has_units(row) && !has_names(row));
    if (!row.empty() && counts && table.columns <= most_labels) rows.push_back(std::move(row));
    if (rows.size() > most_rows) rows.erase(rows.begin());
  }
  out.labels = chosen_labels(rows);
  return out;
}

bool names_points(const Table& table) {
  if (table.columns != 2 && table.columns != 3) return false;
  const std::vector<Label> labels = head_of(table).labels;
  return !labels.empty() &&
         std::ranges::all_of(labels, [](const Label& l) { return role_of(l.name) != CoordinateRole::other; });
}

}  // namespace asperity
