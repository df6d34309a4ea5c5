/// GSF, the Gwyddion Simple Field 1.0.
///
///     Gwyddion Simple Field 1.0
///     XRes = 5                   points along a line, x; required, as is YRes, the number of lines
///     XReal = 6.25e-07           size of the area of all pixels, default 1; YReal likewise
///     XYUnits = m                a unit of length; otherwise the size is unknown
///     ZUnits = m                 unit of the values; unknown if missing
///     Title = heights
/// then one to four NULs up to a multiple of four bytes, and the values: 32-bit floats, least significant
/// byte first, line by line from the top of the image, which is the smallest y here. NaN is a missing point.
/// Other keys (XOffset, YOffset) are ignored. Numbers are written with 24 bits, a relative error of 6e-8;
/// values beyond 3.4e38 are refused.
///
/// Gwyddion user guide, Gwyddion Simple Field file format,
/// http://gwyddion.net/documentation/user-guide-en/gsf.html
#include <cmath>

#include "formats/format.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::string_view gsf_magic = "Gwyddion Simple Field 1.0\n";
constexpr Raster floats{.type = NumberType::float32};

double gsf_spacing(const Head& head, std::string_view key, Index points) {
  const double size = head.has(key) ? head.positive(key) : 1;
  const std::string_view unit = head.text("XYUnits");
  return unit.empty() ? Map::unknown : size * metres_per(unit) / static_cast<double>(points);
}

bool is_gsf(std::string_view bytes) { return bytes.starts_with(gsf_magic); }

Map decode_gsf(std::string_view bytes, const Reading& reading) {
  if (!is_gsf(bytes)) refuse("the file is not a Gwyddion Simple Field");
  const std::size_t end = bytes.find('\0');
  if (end == bytes.npos) refuse_cut_header();
  const Head head(bytes.substr(gsf_magic.size(), end - gsf_magic.size()), "=");
  const Shape shape{head.count("XRes"), head.count("YRes")};
  const std::string_view numbers = bytes.substr(std::min(4 * (end / 4 + 1), bytes.size()));
  Map map{.values = field_from(numbers, shape, floats, reading.memory),
          .title = std::string(head.text("Title"))};
  map.spacing = {gsf_spacing(head, "XReal", shape.nx), gsf_spacing(head, "YReal", shape.ny)};
  leave_out_infinite(map);
  if (const std::string_view units = head.text("ZUnits"); !units.empty()) set_units(map, units);
  return map;
}

std::string encode_gsf(const Map& map, Order) {
  const auto [nx, ny] = shape_of(map.values);
  const double lx = map.spacing[0] * static_cast<double>(nx), ly = map.spacing[1] * static_cast<double>(ny);
  std::string out = fmt::format("{}XRes = {}\nYRes = {}\n", gsf_magic, nx, ny);
  if (std::isfinite(map.spacing[0]) && std::isfinite(map.spacing[1]))
    out += fmt::format("XReal = {}\nYReal = {}\nXYUnits = m\n", shortest(lx), shortest(ly));
  if (!map.units.empty()) out += fmt::format("ZUnits = {}\n", one_line(map.units));
  if (!map.title.empty()) out += fmt::format("Title = {}\n", one_line(map.title));
  out.append(4 - out.size() % 4, '\0');
  return out + bytes_of(map.values, floats);
}

}  // namespace

const Format format::gsf{
    "gsf", "gsf", "Gwyddion Simple Field, 32-bit floats", is_gsf, decode_gsf, encode_gsf, Numbers::singles};

}  // namespace asperity
