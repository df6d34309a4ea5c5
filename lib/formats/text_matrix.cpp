#include "formats/text_matrix.hpp"

#include "formats/text_numbers.hpp"

namespace asperity {

Map decode_text_matrix(std::string_view bytes, Order order) {
  constexpr std::string_view states_units = "# units:";
  std::string numbers(bytes);
  std::string_view units;
  for (std::string_view rest = bytes; !rest.empty();) {
    const auto begin = static_cast<std::size_t>(rest.data() - bytes.data());
    const std::string_view line = take_line(rest);
    if (!line.starts_with('#')) continue;
    if (line.starts_with(states_units)) units = trimmed(line.substr(states_units.size()));
    numbers.replace(begin, line.size(), line.size(), ' ');
  }
  Map map{.values = matrix_of(numbers, "map")};
  if (order == Order::yx) map.values.transposeInPlace();
  if (!units.empty()) set_units(map, units);
  return map;
}

std::string encode_text_matrix(const Map& map, Order order) {
  const std::string head = map.units.empty() ? "" : "# units: " + map.units + "\n";
  return head + (order == Order::yx ? text_of(map.values.transpose()) : text_of(map.values));
}

}  // namespace asperity
