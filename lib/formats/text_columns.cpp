#include "formats/text_columns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/ranges.h>

#include "formats/refuse.hpp"
#include "formats/text_coordinates.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_units.hpp"

namespace asperity {
namespace {

using Labels = std::vector<Label>;

std::string list_of(const Labels& labels) {
  std::vector<std::string> names;
  for (const Label& label : labels) names.push_back(label.name);
  return one_line(fmt::format("{}", fmt::join(names, ", ")), 100);
}

// Where the names put x, y and z, or in the order of the columns.
std::vector<Index> guessed(const Labels& labels, Index columns) {
  std::vector<Index> out;
  const auto taken = [&](Index column) { return std::ranges::find(out, column) != out.end(); };
  for (const CoordinateRole role : {CoordinateRole::x, CoordinateRole::y, CoordinateRole::z}) {
    if (std::ssize(out) == columns || (columns == 2 && role == CoordinateRole::y)) continue;
    const auto named = std::ranges::find_if(labels, [&](const Label& l) { return role_of(l.name) == role; });
    Index column = named == labels.end() ? 0 : named - labels.begin();
    while (taken(column)) column = (column + 1) % columns;
    out.push_back(column);
  }
  return out;
}

[[noreturn]] void refuse_columns(std::string_view what, const Labels& labels, Index columns) {
  Columns shown{.of = guessed(labels, columns), .units = {}};
  for (const Index column : shown.of)
    shown.units.push_back(labels.empty() ? "" : labels[static_cast<std::size_t>(column)].unit);
  refuse(
      "{}: tell asperity-convert which columns are x, y and z, and their units (`xyz` {}), or that all are "
      "heights (`xyz` none)",
      what, example_of(shown));
}

// ---- as told ----

Index column_named(const Labels& labels, const std::string& name, Index columns) {
  if (const auto number = whole_number_of(name)) {
    if (*number < 1 || *number > columns)
      refuse("`xyz` asks for column {}: the text has {}", name, counted(columns, "column"));
    return *number - 1;
  }
  std::optional<Index> out;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (lower(labels[i].name) != lower(name)) continue;
    if (out) refuse("`xyz` asks for {}: two columns have this name, give the number", quoted(name));
    out = static_cast<Index>(i);
  }
  if (!out && is_length(name))
    refuse("`xyz` gives a unit without a column: write it for each, as in 1/um,2/um,3/nm");
  if (!out && std::ranges::all_of(labels, [](const Label& l) { return l.name.empty(); }))
    refuse("`xyz` asks for {}: the text names no columns, give numbers from 1", quoted(name));
  if (!out) refuse("`xyz` asks for {}: the text has {}", quoted(name), list_of(labels));
  return *out;
}

bool is_column(const Labels& labels, const std::string& name) {
  return whole_number_of(name).has_value() ||
         std::ranges::any_of(labels, [&](const Label& l) { return lower(l.name) == lower(name); });
}

// A name or a number, perhaps with a unit: of length, or behind the last slash of any quantity.
Label told_label(const Labels& labels, std::string_view told) {
  const Label label = label_of(told);
  const std::size_t slash = told.rfind('/');
  if (!label.unit.empty() || slash == told.npos || is_column(labels, label.name)) return label;
  const Label out{std::string(trimmed(told.substr(0, slash))), std::string(trimmed(told.substr(slash + 1)))};
  if (!is_column(labels, out.name)) return label;
  if (!is_unit(out.unit))
    refuse("`xyz` gives {} the unit {}, which is unknown", quoted(out.name), quoted(out.unit));
  return out;
}

Columns told_columns(const Table& table, const Labels& labels, std::string_view told) {
  Columns out;
  while (true) {
    const std::size_t end = told.find(',');
    const Label label = told_label(labels, told.substr(0, end));
    const Index column = column_named(labels, label.name, table.columns);
    if (std::ranges::find(out.of, column) != out.of.end())
      refuse("`xyz` asks for {} twice", quoted(label.name));
    const std::string own = labels.empty() ? "" : labels[static_cast<std::size_t>(column)].unit;
    if (!label.unit.empty() && !own.empty() && !same_length(label.unit, own))
      refuse("`xyz` gives {} the unit {}: the text has {}", quoted(label.name), quoted(label.unit),
             quoted(own));
    out.of.push_back(column);
    out.units.push_back(label.unit.empty() ? own : label.unit);
    if (end == told.npos) break;
    told.remove_prefix(end + 1);
  }
  if (out.of.size() > 3)
    refuse("`xyz` names {}: give z, x,z or x,y,z", counted(std::ssize(out.of), "column"));
  return out;
}

// ---- as labelled ----

std::vector<Index> with_role(const Labels& labels, CoordinateRole role) {
  std::vector<Index> letters, out;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (role_of(labels[i].name) != role) continue;
    out.push_back(static_cast<Index>(i));
    if (is_letter(labels[i].name)) letters.push_back(static_cast<Index>(i));
  }
  return letters.empty() ? out : letters;
}

Columns with_units(std::vector<Index> of, const Labels& labels) {
  Columns out{.of = std::move(of), .units = {}};
  for (const Index column : out.of) out.units.push_back(labels[static_cast<std::size_t>(column)].unit);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (std::ranges::find(out.of, static_cast<Index>(i)) == out.of.end() && !labels[i].name.empty())
      out.left_out.push_back(labels[i].name);
  return out;
}

bool all_lengths(const Labels& labels) {
  return std::ranges::all_of(labels, [](const Label& l) { return is_length(l.unit); });
}

// Nothing if the labels name no coordinate.
std::optional<Columns> labelled_columns(const Labels& labels, Index columns) {
  const auto x = with_role(labels, CoordinateRole::x), y = with_role(labels, CoordinateRole::y),
             z = with_role(labels, CoordinateRole::z);
  if (x.empty() && (y.empty() || z.empty())) return std::nullopt;
  const auto named = std::ranges::count_if(labels, [](const Label& l) { return !l.name.empty(); });
  if (named == 2 && x.size() == 1 && y.size() == 1) return with_units({x[0], y[0]}, labels);
  const auto unclear = [&] { refuse_columns("the columns are " + list_of(labels), labels, columns); };
  if (x.size() != 1 || y.size() > 1 || z.size() != 1) unclear();
  const Columns out = with_units(y.empty() ? std::vector{x[0], z[0]} : std::vector{x[0], y[0], z[0]}, labels);
  const auto name = [&](Index column) { return labels[static_cast<std::size_t>(column)].name; };
  const bool letters = std::ranges::all_of(out.of, [&](Index column) { return is_letter(name(column)); });
  if (!out.left_out.empty() && !(letters && out.of.size() == 3)) unclear();
  return out;
}

// Of values in all columns: theirs, if all are alike.
std::string common_unit(const Labels& labels, bool told) {
  if (labels.empty() || (labels.size() == 1 && names_coordinates(labels[0].name))) return "";
  const std::string& unit = labels[0].unit;
  const auto other = std::ranges::find_if(labels, [&](const Label& l) { return !same_length(l.unit, unit); });
  if (other == labels.end()) return unit;
  if (told) return "";
  refuse("the columns have the units {} and {}: choose some (`xyz`), or give that of all (`unit`)",
         quoted(unit), quoted(other->unit));
}

// ---- words above the numbers that may be numbers ----

bool is_word(std::string_view cell) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  for (std::size_t i = 0; i + 1 < cell.size(); ++i)
    if (letter(cell[i]) && letter(cell[i + 1])) return true;
  return false;
}

// A line of as many cells as there are columns, or one that begins with a number and has another, might have
// been meant as numbers, one of them misspelt, and so may a single cell above one column that begins like a
// number; not so where a word stands for a coordinate, as in
// "Points;512".
void check_line(const Table& table, const HeadLine& line, bool coordinate_first, bool quotes) {
  const auto cells = cells_of(line.text, table.dialect.separator, quotes);
  std::string_view word;
  Index numbers = 0, finite = 0, words = 0;
  bool label = true, same = true;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    const auto number = number_of(cell, table.dialect.comma);
    number ? ++numbers : ++words;
    finite += number && std::isfinite(*number);
    if (number) continue;
    if (word.empty()) word = cell;
    same = same && cell == word;
    label = label && (is_word(cell) || is_letter(std::string(cell))) && !begins_like_number(cell);
  }
  const auto count = static_cast<Index>(cells.size());
  const bool of_numbers = finite > 1 && number_of(cells[0], table.dialect.comma);
  const bool misspelt =
      table.columns == 1 && count == 1 && begins_like_number(cells[0]) && !cells[0].starts_with("--");
  if (!of_numbers && !misspelt && (count < 2 || (count != table.columns && count != table.columns + 1)))
    return;
  const bool key = coordinate_first && is_word(cells[0]) && !number_of(cells[0], table.dialect.comma);
  const bool marks = same && words == count && !is_length(word);
  if (key || (label && !marks && numbers == 0)) return;
  refuse(
      "line {}: {} is not a number: begin lines of words with #, or tell asperity-convert if it means a "
      "missing point (`missing`)",
      line.number, quoted(word));
}

void check_head(const Table& table, const Columns& columns, const Reading& reading, bool quotes) {
  const bool coordinate_first = columns.points() && columns.of.back() != 0;
  for (const HeadLine& line : table.head)
    if (!is_comment(line.text, table.dialect.separator, reading.missing))
      check_line(table, line, coordinate_first, quotes);
}

Columns decided(const Table& table, const Labels& labels, const Reading& reading, bool bare) {
  if (!reading.columns.empty() && reading.columns != "none")
    return told_columns(table, labels, reading.columns);
  const auto heights = [&] { return Columns{{}, {common_unit(labels, reading.unit_told)}}; };
  if (reading.columns == "none" || bare) return heights();
  if (const auto columns = labelled_columns(labels, table.columns)) return *columns;
  const Coordinates found = coordinates_in({table.values.data(), table.lines, table.columns});
  const bool few = labels.size() == 2 || labels.size() == 3;
  if (found == Coordinates::columns && few && all_lengths(labels))
    return with_units(labels.size() == 2 ? std::vector<Index>{0, 1} : std::vector<Index>{0, 1, 2}, labels);
  if (found == Coordinates::columns)
    refuse_columns("the first columns look like coordinates", labels, table.columns);
  if (found == Coordinates::line)
    refuse(
        "the first line looks like coordinates: remove it and give asperity-convert the `size`, or tell it "
        "that all are heights (`xyz` none)");
  return heights();
}

}  // namespace

std::string example_of(const Columns& columns) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < columns.of.size(); ++i) {
    const char* const unit = !columns.units[i].empty() ? "" : i + 1 < columns.of.size() ? "/um" : "/nm";
    out.push_back(fmt::format("{}{}", columns.of[i] + 1, unit));
  }
  return fmt::format("{}", fmt::join(out, ","));
}

Columns columns_of(const Table& table, const Reading& reading, bool quotes, bool bare) {
  const Columns out = decided(table, labels_of(table, quotes), reading, bare);
  check_head(table, out, reading, quotes);
  return out;
}

}  // namespace asperity
