#include "formats/text_columns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/ranges.h>

#include "formats/refuse.hpp"

namespace asperity {
namespace {

using Labels = std::vector<Label>;
using enum CoordinateRole;

std::string names_of(const Labels& labels) {
  std::vector<std::string> names;
  for (const Label& label : labels) names.push_back(label.name);
  return one_line(fmt::format("{}", fmt::join(names, ", ")), 100);
}

std::string own_unit(const Labels& labels, Index column) {
  return labels.empty() ? "" : labels[static_cast<std::size_t>(column)].unit;
}

bool contains(const std::vector<Index>& columns, Index column) {
  return std::ranges::find(columns, column) != columns.end();
}

// Where the names put x, y and z, or in the order of the columns; with the units of the text.
Columns guessed(const Labels& labels, Index columns) {
  Columns out;
  for (const CoordinateRole role : {x, y, z}) {
    if (std::ssize(out.of) == columns || (columns == 2 && role == y)) continue;
    const auto named = std::ranges::find_if(labels, [&](const Label& l) { return role_of(l.name) == role; });
    Index column = named == labels.end() ? 0 : named - labels.begin();
    while (contains(out.of, column)) column = (column + 1) % columns;
    out.of.push_back(column);
    out.units.push_back(own_unit(labels, column));
  }
  return out;
}

[[noreturn]] void refuse_columns(std::string_view what, const Labels& labels, Index columns) {
  refuse(
      "{}: say which columns are x, y and z, and their units (`xyz` {}), or that all are heights (`xyz` "
      "none)",
      what, example_of(guessed(labels, columns)));
}

// ---- as Reading::columns says ----

// The columns of this name.
std::vector<Index> columns_named(const Labels& labels, const std::string& name) {
  std::vector<Index> out;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (lower(labels[i].name) == lower(name)) out.push_back(static_cast<Index>(i));
  return out;
}

Index column_of(const Labels& labels, const std::string& name, Index columns) {
  if (const auto number = whole_number_of(name)) {
    if (*number < 1 || *number > columns)
      refuse("`xyz` asks for column {}: the text has {}", name, counted(columns, "column"));
    return *number - 1;
  }
  const std::vector<Index> found = columns_named(labels, name);
  if (found.size() == 1) return found[0];
  if (!found.empty()) refuse("`xyz` asks for {}: two columns have this name, give the number", quoted(name));
  if (is_length(name)) refuse("`xyz` gives a unit without a column: write it for each, as in 1/um,2/um,3/nm");
  if (std::ranges::all_of(labels, [](const Label& l) { return l.name.empty(); }))
    refuse("`xyz` asks for {}: the text names no columns, give numbers from 1", quoted(name));
  refuse("`xyz` asks for {}: the text has {}", quoted(name), names_of(labels));
}

// A name or a number, perhaps with a unit: of length, or after the last slash of any quantity.
Label asked_label(const Labels& labels, std::string_view word) {
  const auto is_column = [&](const std::string& name) {
    return whole_number_of(name) || !columns_named(labels, name).empty();
  };
  const Label label = label_of(word);
  const std::size_t slash = word.rfind('/');
  if (!label.unit.empty() || slash == word.npos || is_column(label.name)) return label;
  const Label out{std::string(trimmed(word.substr(0, slash))), std::string(trimmed(word.substr(slash + 1)))};
  if (!is_column(out.name)) return label;
  if (!is_unit(out.unit))
    refuse("`xyz` gives {} the unit {}, which is unknown", quoted(out.name), quoted(out.unit));
  return out;
}

Columns asked_columns(const Labels& labels, std::string_view words, Index columns) {
  Columns out;
  while (words.data() != nullptr) {
    const std::size_t end = words.find(',');
    const Label label = asked_label(labels, words.substr(0, end));
    words = end == words.npos ? std::string_view() : words.substr(end + 1);
    const Index column = column_of(labels, label.name, columns);
    const std::string own = own_unit(labels, column);
    if (contains(out.of, column)) refuse("`xyz` asks for {} twice", quoted(label.name));
    if (!label.unit.empty() && !own.empty() && !same_length(label.unit, own))
      refuse("`xyz` gives {} the unit {}: the text has {}", quoted(label.name), quoted(label.unit),
             quoted(own));
    out.of.push_back(column);
    out.units.push_back(label.unit.empty() ? own : label.unit);
  }
  if (out.of.size() > 3)
    refuse("`xyz` names {}: give z, x,z or x,y,z", counted(std::ssize(out.of), "column"));
  return out;
}

// ---- as the labels say ----

// Those of a role; if some have its letter, these only.
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
  for (const Index column : out.of) out.units.push_back(own_unit(labels, column));
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (!contains(out.of, static_cast<Index>(i)) && !labels[i].name.empty())
      out.left_out.push_back(labels[i].name);
  return out;
}

// Nothing if the labels name no coordinate.
std::optional<Columns> labelled_columns(const Labels& labels, Index columns) {
  const auto xs = with_role(labels, x), ys = with_role(labels, y), zs = with_role(labels, z);
  if (xs.empty() && (ys.empty() || zs.empty())) return std::nullopt;
  const auto named = std::ranges::count_if(labels, [](const Label& l) { return !l.name.empty(); });
  if (named == 2 && xs.size() == 1 && ys.size() == 1) return with_units({xs[0], ys[0]}, labels);
  const auto unclear = [&] { refuse_columns("the columns are " + names_of(labels), labels, columns); };
  if (xs.size() != 1 || ys.size() > 1 || zs.size() != 1) unclear();
  const Columns out =
      with_units(ys.empty() ? std::vector{xs[0], zs[0]} : std::vector{xs[0], ys[0], zs[0]}, labels);
  const bool letters = std::ranges::all_of(
      out.of, [&](Index column) { return is_letter(labels[static_cast<std::size_t>(column)].name); });
  if (!out.left_out.empty() && !(letters && out.of.size() == 3)) unclear();
  return out;
}

// Of heights in all columns: the unit of their labels, if all are alike.
Columns all_heights(const Labels& labels, bool told) {
  if (labels.empty() || (labels.size() == 1 && names_coordinates(labels[0].name))) return {{}, {""}};
  const std::string& unit = labels[0].unit;
  const auto other = std::ranges::find_if(labels, [&](const Label& l) { return !same_length(l.unit, unit); });
  if (other == labels.end()) return {{}, {unit}};
  if (told) return {{}, {""}};
  refuse("the columns have the units {} and {}: choose some (`xyz`), or give that of all (`unit`)",
         quoted(unit), quoted(other->unit));
}

Columns decided(const Table& table, const Labels& labels, const Reading& reading, bool bare) {
  if (!reading.columns.empty() && reading.columns != "none")
    return asked_columns(labels, reading.columns, table.columns);
  if (reading.columns == "none" || bare) return all_heights(labels, reading.unit_told);
  if (const auto columns = labelled_columns(labels, table.columns)) return *columns;
  const Coordinates found = coordinates_in(table.field());
  const auto length = [](const Label& l) { return is_length(l.unit); };
  if (found == Coordinates::columns && (labels.size() == 2 || labels.size() == 3) &&
      std::ranges::all_of(labels, length))
    return with_units(labels.size() == 2 ? std::vector<Index>{0, 1} : std::vector<Index>{0, 1, 2}, labels);
  if (found == Coordinates::columns)
    refuse_columns("the first columns look like coordinates", labels, table.columns);
  if (found == Coordinates::line)
    refuse(
        "the first line looks like coordinates: remove it and give the size (`size`), or say that all are "
        "heights (`xyz` none)");
  return all_heights(labels, reading.unit_told);
}

// ---- words above the numbers that may be numbers ----

// Two letters side by side.
bool is_word(std::string_view cell) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  };
  return std::ranges::adjacent_find(cell, [&](char a, char b) { return letter(a) && letter(b); }) !=
         cell.end();
}

// "Profile", "x"; not "?", "2x".
bool may_be_label(std::string_view cell) {
  return (is_word(cell) || is_letter(std::string(cell))) && !begins_like_number(cell);
}

// A line of as many cells as there are columns, or one that begins with a number and has another, might have
// been meant as numbers, one of them misspelt, and so may a single cell above one column that begins like a
// number; not so where a word stands for a coordinate, as in "Points;512".
void check_line(const Table& table, const HeadLine& line, bool coordinate_first) {
  const auto cells = cells_of(line.text, table.dialect);
  const auto number = [&](std::string_view cell) { return number_of(cell, table.dialect.comma); };
  std::vector<std::string_view> words;
  Index numbers = 0, finite = 0;
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    const auto value = number(cell);
    value ? static_cast<void>(++numbers) : words.push_back(cell);
    finite += value && std::isfinite(*value);
  }
  const auto count = static_cast<Index>(cells.size());
  const bool of_numbers = finite > 1 && number(cells[0]);
  const bool misspelt =
      table.columns == 1 && count == 1 && begins_like_number(cells[0]) && !cells[0].starts_with("--");
  const bool as_many = count > 1 && (count == table.columns || count == table.columns + 1);
  if (!of_numbers && !misspelt && !as_many) return;
  const bool key = coordinate_first && is_word(cells[0]) && !number(cells[0]);
  const bool labels = numbers == 0 && std::ranges::all_of(words, may_be_label);
  const bool marks =
      std::ranges::count(words, words.empty() ? "" : words[0]) == count && !is_length(words[0]);
  if (key || (labels && !marks)) return;
  refuse(
      "line {}: {} is not a number: begin lines of words with #, or, if it means a missing point, give it "
      "(`missing`)",
      line.number, quoted(words.empty() ? "" : words[0]));
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

Columns columns_of(const Table& table, const Labels& labels, const Reading& reading, bool bare) {
  const Columns out = decided(table, labels, reading, bare);
  const bool coordinate_first = out.points() && out.of.back() != 0;
  for (const HeadLine& line : table.head)
    if (!is_comment(line.text, table.dialect.separator, reading.missing))
      check_line(table, line, coordinate_first);
  return out;
}

}  // namespace asperity
