/// Numbers in plain text: a matrix of heights, one line for each x or for each y, or points of a surface.
///
/// Lines and comments are described in formats/text_lines.hpp, separators and decimal marks in
/// formats/text_table.hpp, lines of words and units in formats/text_head.hpp, what the columns are in
/// formats/text_columns.hpp, points in its second part. UTF-8 and, with its byte-order mark, UTF-16
/// are read. Unit and size are optional.
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

#include "formats/format.hpp"
#include "formats/head.hpp"
#include "formats/refuse.hpp"
#include "formats/text_columns.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr std::string_view states_units = "# units", states_spacing = "# spacing", states_order = "# order";

// What comments of this format say.
struct Stated {
  std::string units;
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

Stated stated_in(const Head& head) {
  Stated out{.units = std::string(head.text(states_units)), .order = std::nullopt};
  if (head.has(states_spacing)) out.spacing = spacing_in(head.text(states_spacing));
  if (head.has(states_order)) out.order = order_in(head.text(states_order));
  return out;
}

// The text above the numbers.
std::string_view text_above(const Table& table, std::string_view text) {
  if (table.head.empty()) return {};
  const std::string_view last = table.head.back().text;
  return text.substr(0, static_cast<std::size_t>(last.data() + last.size() - text.data()));
}

// The matrix, or its only column that counts.
Map map_of_matrix(Table table, const Columns& columns, Order order, std::array<double, 2> spacing) {
  if (table.next_block > 0)
    refuse("line {}: numbers go on below {}: a file holds one map; remove the line, or all blocks but one",
           table.next_block, table.parted_by);
  Field lines = table.field();
  table.values = {};
  if (columns.of.size() == 1) lines = lines.col(columns.of[0]).eval();
  if (order == Order::yx) lines.transposeInPlace();
  return {.values = std::move(lines), .spacing = spacing};
}

// Of the values, by the label of their column, a comment of this format or other lines of the head.
std::string unit_of(const Table& table, const TextHead& head, const Columns& columns, const Stated& stated,
                    const Reading& reading) {
  const std::string& label = columns.units.back();
  const bool labelled = !label.empty() || columns.points();
  const std::string out =
      unit_of_values(labelled ? head.others : table.head, label.empty() ? stated.units : label, reading);
  if (!label.empty() && !stated.units.empty() && !same_length(label, stated.units))
    refuse("the values have the unit {} in one line and {} in another: remove one", quoted(label),
           quoted(stated.units));
  const auto placed = columns.units.end() - 1;  // of x and y
  if (out.empty() && columns.points() && !reading.unit_told &&
      std::none_of(columns.units.begin(), placed, [](const std::string& unit) { return unit.empty(); }))
    refuse("the text gives no unit of z: give it (`unit`)");
  return out;
}

std::string spacing_words(const Map& map, bool told) {
  if (told) return "";
  if (std::isnan(map.spacing[0])) return ", no size given";
  const auto length = [](double x) { return in_digits(x, 4) + " m"; };
  return ", spacing " + length(map.spacing[0]) +
         (map.spacing[0] == map.spacing[1] ? "" : " x " + length(map.spacing[1]));
}

// In words, without the size and what follows it.
std::string layout_of(const Columns& columns, Order order) {
  return columns.of.size() == 3   ? "points x y z"
         : columns.of.size() == 2 ? "points x z"
         : order == Order::yx     ? "a line for each y"
                                  : "a line for each x";
}

// How the text was read, after its size.
std::string details_of(const Table& table, const Columns& columns) {
  std::string out;
  if (table.columns > 1) out += ", " + described(table.dialect);
  if (table.words > 0) out += fmt::format(", below {} of words", counted(table.words, "line"));
  for (const std::string& word : table.unseen) out += fmt::format(", no cell is {}", quoted(word));
  if (!columns.left_out.empty())
    out += fmt::format(", without {}", one_line(fmt::format("{}", fmt::join(columns.left_out, ", ")), 60));
  return out;
}

Map map_of_text(std::string_view text, const Reading& reading) {
  Table table = table_with_head(text, reading);
  const TextHead head = head_of(table);
  const Stated stated = stated_in(Head(text_above(table, text), ":"));
  const Columns columns = columns_of(table, head.labels, reading, stated.order.has_value());
  const std::string unit = unit_of(table, head, columns, stated, reading),
                    details = details_of(table, columns);
  const Order order = stated.order.value_or(reading.order);
  if (columns.points() && reading.order == Order::yx)
    refuse("points come in any order: omit that of the lines of a matrix (`from-order`)");
  Map map = columns.points() ? map_of_points(table, columns)
                             : map_of_matrix(std::move(table), columns, order, stated.spacing);
  const Index missing = map.values.isNaN().count();
  const std::string how = std::exchange(map.understood, "");
  map.understood = fmt::format("read as a map of {} x {}, {}{}{}{}", map.values.rows(), map.values.cols(),
                               layout_of(columns, order), spacing_words(map, reading.size_told),
                               missing > 0 ? ", " + counted(missing, "point") + " missing" : "", details);
  if (!unit.empty()) {
    set_units(map, unit);
    map.understood += ", values in " + one_line(unit, 24);
  }
  if (!how.empty()) map.understood += "; " + how;
  return map;
}

Map decode_text(std::string_view bytes, const Reading& reading) {
  refuse_without_mark(bytes, "map");
  if (!is_utf16(bytes)) return map_of_text(bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0), reading);
  reading.memory.require(1.5 * static_cast<double>(bytes.size()), "map");
  const std::string text = utf8_from_utf16(bytes);
  Reading left = reading;
  left.memory = reading.memory.beside(text.size());
  return map_of_text(text, left);
}

std::string encode_text(const Map& map, Order order) {
  const auto [dx, dy] = map.spacing;
  std::string out = map.units.empty() ? "" : fmt::format("{}: {}\n", states_units, map.units);
  if (dx > 0 && dy > 0) out += fmt::format("{}: {} {}\n", states_spacing, shortest(dx), shortest(dy));
  out += fmt::format("{}: {}\n", states_order, order == Order::yx ? "yx" : "xy");
  return out + (order == Order::yx ? text_of(map.values.transpose()) : text_of(map.values));
}

}  // namespace

const Format format::text{
    "text", "txt csv tsv dat asc xyz", "matrix or points in plain text", nullptr, decode_text, encode_text};

}  // namespace asperity
