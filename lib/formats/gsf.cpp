#include "formats/gsf.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::string_view magic = "Gwyddion Simple Field 1.0\n";
constexpr Raster floats{NumberType::float32, std::endian::little, Order::yx};

// The size is 1 where it is not stated, of no unit where that is not stated.
double spacing_of(const Head& head, std::string_view key, Index points) {
  const double size = head.has(key) ? head.positive(key) : 1;
  const std::string_view unit = head.text("XYUnits");
  return unit.empty() ? Map::unknown : size * metres_per(unit, "map") / static_cast<double>(points);
}

std::string head_of(const Map& map) {
  const auto nx = static_cast<double>(map.values.rows()), ny = static_cast<double>(map.values.cols());
  const auto entry = [](std::string_view key, auto value) { return head_line(key, " = ", value); };
  std::string out(magic);
  out += entry("XRes", std::to_string(map.values.rows())) + entry("YRes", std::to_string(map.values.cols()));
  if (std::isfinite(map.spacing[0]) && std::isfinite(map.spacing[1]))
    out += entry("XReal", map.spacing[0] * nx) + entry("YReal", map.spacing[1] * ny) + entry("XYUnits", "m");
  if (!map.units.empty()) out += entry("ZUnits", map.units);
  if (!map.title.empty()) out += entry("Title", map.title);
  return out;
}

}  // namespace

bool recognises_gsf(std::string_view bytes) { return bytes.starts_with(magic); }

Map decode_gsf(std::string_view bytes, const Reading& reading) {
  if (!recognises_gsf(bytes)) throw DataError("map", "it does not begin as a Gwyddion Simple Field");
  const std::size_t end = bytes.find('\0');
  if (end == bytes.npos) throw DataError("map", "its head has no end");
  const Head head(bytes.substr(magic.size(), end - magic.size()), "=");
  const Shape shape{head.count("XRes"), head.count("YRes")};
  const std::string_view numbers = bytes.substr(std::min(4 * (end / 4 + 1), bytes.size()));
  Map map{.values = field_from(numbers, shape, floats, "map", reading.memory),
          .title = std::string(head.text("Title"))};
  map.spacing = {spacing_of(head, "XReal", shape.nx), spacing_of(head, "YReal", shape.ny)};
  if (const std::string_view units = head.text("ZUnits"); !units.empty()) set_units(map, units);
  return map;
}

std::string encode_gsf(const Map& map, Order) {
  std::string out = head_of(map);
  out.append(4 - out.size() % 4, '\0');
  return out + bytes_of(map.values, floats);
}

}  // namespace asperity
