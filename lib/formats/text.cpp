/// Numbers in plain text: a matrix of heights, one line for each x or for each y, or points of a surface.
///
/// Separators, decimal marks, lines of words and comments are described in formats/text_table.hpp, what the
/// columns are in formats/text_columns.hpp, points in formats/text_points.hpp, units in
/// formats/text_labels.hpp. UTF-8 and, with its byte-order mark, UTF-16 are read. Unit and size are optional.
///
/// Written are comments and then a matrix:
///     # units: m                 of the values
///     # spacing: 1e-06 2e-06     Δx and Δy [m], if known
///     # order: xy                a line for each x
/// Read again, these give the same map to the last bit, whatever order is asked for.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/ranges.h>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/refuse.hpp"
#include "formats/text_columns.hpp"
#include "formats/text_encoding.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_points.hpp"
#include "formats/text_table.hpp"
#include "formats/text_units.hpp"

namespace asperity {
namespace {

constexpr std::string_view states_units = "# units:", states_spacing = "# spacing:",
                           states_order = "# order:";

// What comments of this format say.
struct Stated {
  std::string_view units;
  std::array<double, 2> spacing{Map::unknown, Map::unknown};
  std::optional<Order> order;
};

std::array<double, 2> spacing_in(std::string_view words) {
  const std::size_t end = std::min(words.find(' '), words.size());
  const auto dx = number_of(words.substr(0, end)), dy = number_of(trimmed(words.substr(end)));
  if (!dx || !dy || !(*dx > 0 && std::isfinite(*dx) && *dy > 0 && std::isfinite(*dy)))
    refuse("the spacing {} is not two positive numbers in metres: correct or remove the line", quoted(words));
  return {*dx, *dy};
}

Order order_in(std::string_view words) {
  if (words != "xy" && words != "yx")
    refuse("the order {} is none of xy|yx: correct or remove the line", quoted(words));
  return words == "yx" ? Order::yx : Order::xy;
}

void take(std::string_view line, Stated& out) {
  const auto value = [&](std::string_view key) { return trimmed(line.substr(key.size())); };
  const auto set = [&](auto& stated, const auto& given, bool known) {
    if (known && stated != given) refuse("the line {} contradicts a former one: remove one", quoted(line));
    stated = given;
  };
  if (line.starts_with(states_units)) set(out.units, value(states_units), !out.units.empty());
  if (line.starts_with(states_spacing))
    set(out.spacing, spacing_in(value(states_spacing)), !std::isnan(out.spacing[0]));
  if (line.starts_with(states_order))
    set(out.order, std::optional(order_in(value(states_order))), out.order.has_value());
}

// Below the numbers only a unit may be stated: what begins like another map is refused.
void take_below(std::string_view text, Stated& out) {
  bool last = false;  // no numbers follow
  for (std::size_t at = text.find("# "); at != text.npos; at = text.find("# ", at + 1)) {
    if (at == 0 || (text[at - 1] != '\n' && text[at - 1] != '\r')) continue;
    std::string_view rest = text.substr(at);
    const std::string_view line = take_line(rest);
    if (!line.starts_with(states_units) && !line.starts_with(states_order)) continue;
    take(line, out);
    if (std::exchange(last, true)) continue;
    for (std::string_view next = rest; !next.empty();) {
      const std::string_view numbers = trimmed(take_line(next));
      if (!numbers.empty() && numbers.front() != '#') refuse_rest(text.substr(at), "map");
    }
  }
}

Stated stated_in(std::string_view text, const Table& table) {
  Stated out;
  const auto begins = static_cast<std::size_t>(table.begins - text.data());
  for (std::string_view above = text.substr(0, begins); !above.empty();) take(trimmed(take_line(above)), out);
  take_below(text.substr(begins), out);
  return out;
}

// The matrix, or its only column that counts.
Map map_of_matrix(Table table, const Columns& columns, const Stated& stated, const Reading& reading) {
  if (table.next_block > 0)
    refuse("line {}: numbers go on below {}: a file holds one map; remove the line, or all blocks but one",
           table.next_block, table.parted_by);
  Field lines = Eigen::Map<const Field>(table.values.data(), table.lines, table.columns);
  table.values = {};
  if (columns.of.size() == 1) lines = lines.col(columns.of[0]).eval();
  if (stated.order.value_or(reading.order) == Order::yx) lines.transposeInPlace();
  return {.values = std::move(lines), .spacing = stated.spacing};
}

// Of points, without what only a matrix has.
Map map_of_points(const Table& table, const Columns& columns, const Reading& reading) {
  if (reading.order == Order::yx)
    refuse("points come in any order: omit that of the lines of a matrix (`from-order`)");
  return map_of_points(table, columns);
}

// Of the values, by the label of their column, a line below the numbers or the head.
std::string unit_of(const Table& table, const Columns& columns, const Stated& stated, const Reading& reading,
                    bool quotes) {
  const std::string& label = columns.units.back();
  const bool labelled = !label.empty() || columns.points();
  const std::string out = unit_of_values(labelled ? without_labels(table, quotes) : table.head,
                                         label.empty() ? std::string(stated.units) : label, reading);
  if (!label.empty() && !stated.units.empty() && !same_length(label, std::string(stated.units)))
    refuse("the values have the unit {} in one line and {} in another: remove one", quoted(label),
           quoted(stated.units));
  const auto placed = columns.units.end() - 1;  // of x and y
  if (out.empty() && columns.points() && !reading.unit_told &&
      std::none_of(columns.units.begin(), placed, [](const std::string& unit) { return unit.empty(); }))
    refuse("the text gives no unit of z: give it to asperity-convert (`unit`)");
  return out;
}

std::string spacing_words(const Map& map, bool told) {
  if (told) return "";
  if (std::isnan(map.spacing[0])) return ", no size given";
  const auto length = [](double x) { return in_digits(x, 4) + " m"; };
  return ", spacing " + length(map.spacing[0]) +
         (map.spacing[0] == map.spacing[1] ? "" : " x " + length(map.spacing[1]));
}

std::string understood(const Map& map, const Table& table, const Columns& columns, Order order,
                       bool size_told) {
  const std::string what = columns.of.size() == 3   ? "points x y z"
                           : columns.of.size() == 2 ? "points x z"
                           : order == Order::yx     ? "a line for each y"
                                                    : "a line for each x";
  std::string out = fmt::format("read as a map of {} x {}, {}{}", map.values.rows(), map.values.cols(), what,
                                spacing_words(map, size_told));
  const Index missing = map.values.isNaN().count();
  if (missing > 0) out += fmt::format(", {} missing", counted(missing, "point"));
  if (table.columns > 1) out += ", " + described(table.dialect);
  if (table.head_lines > 0)
    out += fmt::format(", below {} of words", counted(static_cast<Index>(table.head_lines), "line"));
  for (const std::string& word : table.unseen) out += fmt::format(", no cell is {}", quoted(word));
  if (!columns.left_out.empty())
    out += fmt::format(", without {}", one_line(fmt::format("{}", fmt::join(columns.left_out, ", ")), 60));
  return out;
}

Map map_of_text(std::string_view text, const Reading& reading) {
  const bool quotes = text.find('"') != text.npos;
  Table table = table_with_head(text, reading);
  const Stated stated = stated_in(text, table);
  const Columns columns = columns_of(table, reading, quotes, stated.order.has_value());
  const std::string unit = unit_of(table, columns, stated, reading, quotes);
  Table shown = {.dialect = table.dialect, .values = {}};
  shown.columns = table.columns;
  shown.head_lines = table.head_lines;
  shown.unseen = table.unseen;
  Map map = columns.points() ? map_of_points(table, columns, reading)
                             : map_of_matrix(std::move(table), columns, stated, reading);
  map.understood = understood(map, shown, columns, stated.order.value_or(reading.order), reading.size_told);
  if (unit.empty()) return map;
  set_units(map, unit);
  map.understood += ", values in " + one_line(unit, 24);
  return map;
}

Map decode(std::string_view bytes, const Reading& reading) {
  refuse_without_mark(bytes, "map");
  if (!is_utf16(bytes)) return map_of_text(bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0), reading);
  reading.memory.require(1.5 * static_cast<double>(bytes.size()), "map");
  const std::string text = utf8_from_utf16(bytes);
  Reading beside = reading;
  beside.memory = reading.memory.beside(text.size());
  return map_of_text(text, beside);
}

std::string encode(const Map& map, Order order) {
  const auto [dx, dy] = map.spacing;
  std::string out = map.units.empty() ? "" : fmt::format("{} {}\n", states_units, map.units);
  if (dx > 0 && dy > 0) out += fmt::format("{} {} {}\n", states_spacing, shortest(dx), shortest(dy));
  out += fmt::format("{} {}\n", states_order, order == Order::yx ? "yx" : "xy");
  return out + (order == Order::yx ? text_of(map.values.transpose()) : text_of(map.values));
}

}  // namespace

const Format format::text{
    "text", "txt csv tsv dat asc xyz", "matrix or points in plain text", nullptr, decode, encode};

}  // namespace asperity
