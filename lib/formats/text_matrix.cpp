#include "formats/text_matrix.hpp"

#include "core/error.hpp"
#include "dataset/rest.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_points.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

// Of the last line "# units: …", behind which no second matrix may stand.
std::string_view units_in(std::string_view text) {
  constexpr std::string_view states_units = "# units:";
  std::string_view units, second;
  for (bool numbers = false; !text.empty();) {
    const std::string_view all = text, line = take_line(text);
    if (line.starts_with(states_units)) {
      units = trimmed(line.substr(states_units.size()));
      if (numbers && second.empty()) second = all;
    } else if (!line.empty() && line.front() != '#') {
      numbers = true;
      if (!second.empty()) refuse_rest(second, "map");
    }
  }
  return units;
}

Map map_of_lines(Field lines, const Reading& reading) {
  if (reading.coordinate > 0) return map_of_points(lines, reading.coordinate);
  if (!reading.heights && has_coordinates(lines))
    throw DataError(
        "map",
        "its first columns look like coordinates, not heights: tell asperity-convert the unit of the "
        "points in lines of x z or x y z, or that every column is of heights");
  if (reading.order == Order::yx) lines.transposeInPlace();
  return {.values = std::move(lines)};
}

}  // namespace

Map decode_text_matrix(std::string_view bytes, const Reading& reading) {
  Map map = map_of_lines(matrix_of(bytes, "map", 1, reading), reading);
  if (const std::string_view units = units_in(bytes); !units.empty()) set_units(map, units);
  return map;
}

std::string encode_text_matrix(const Map& map, Order order) {
  const std::string head = map.units.empty() ? "" : "# units: " + map.units + "\n";
  return head + (order == Order::yx ? text_of(map.values.transpose()) : text_of(map.values));
}

}  // namespace asperity
