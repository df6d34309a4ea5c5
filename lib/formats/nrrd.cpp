/// NRRD, nearly raw raster data, versions 1 to 5.
///
///     NRRD0004
///     type: double               integers of 8 to 64 bits, float, double, by all their names
///     dimension: 2               or more, if no more than two axes are longer than 1
///     sizes: 5 3                 points along x, the fastest axis, and y, in ascending order
///     spacings: 1e-06 2e-06      or axis mins and maxs (with centers), or the lengths of space directions:
///                            an axis against its direction is reversed, a mirrored map is refused; several
///                            must agree to a thousandth
///     units: "m" "m"             of each axis (space units with space directions); else the size is unknown
///     sample units: "m"          of the values, with quotes (Gwyddion) or without (teem)
///     content: heights           the title
///     endian: little             or big
///     encoding: raw              or text (ascii, txt), or gzip (gz)
/// in any order, then an empty line and the numbers. NaN is a missing point. Comments (#) and other fields
/// are ignored. A header with its data in another file is refused, because a file must not name others to
/// open; so are line skip and byte skip, and the encodings hex and bzip2.
///
/// Files are written with raw doubles, least significant byte first.
///
/// Definition of the NRRD file format, https://teem.sourceforge.net/nrrd/format.html
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "formats/format.hpp"
#include "formats/gzip.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t most_axes = 16;  // as in teem

struct Type {
  NumberType type;
  std::string_view names;  // between bars
};

constexpr Type nrrd_types[] = {
    {NumberType::int8, "|signed char|int8|int8_t|"},
    {NumberType::uint8, "|uchar|unsigned char|uint8|uint8_t|"},
    {NumberType::int16, "|short|short int|signed short|signed short int|int16|int16_t|"},
    {NumberType::uint16, "|ushort|unsigned short|unsigned short int|uint16|uint16_t|"},
    {NumberType::int32, "|int|signed int|int32|int32_t|"},
    {NumberType::uint32, "|uint|unsigned int|uint32|uint32_t|"},
    {NumberType::int64,
     "|longlong|long long|long long int|signed long long|signed long long int|int64|int64_t|"},
    {NumberType::uint64, "|ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t|"},
    {NumberType::float32, "|float|"},
    {NumberType::float64, "|double|"},
};

// A field with two spellings, with a blank and without.
std::string_view field(const Head& head, std::string_view name) {
  std::string joined(name);
  std::erase(joined, ' ');
  const std::string_view out = head.text(name), other = head.text(joined);
  if (!out.empty() && !other.empty() && out != other)
    refuse("{} is given twice in the header: remove one", name);
  return out.empty() ? other : out;
}

// The first of these characters from a position, or the end.
std::size_t find_end(std::string_view text, std::string_view ends, std::size_t from) {
  return std::min(text.find_first_of(ends, from), text.size());
}

// Words between blanks, quotes or parentheses.
Words field_words(std::string_view text) {
  Words out;
  while (!(text = trimmed(text)).empty()) {
    if (out.size() == most_axes) refuse("the array has more than 16 dimensions, a map has 2");
    const bool in_quotes = text.front() == '"', in_parentheses = text.front() == '(',
               inside = in_quotes || in_parentheses;
    const std::size_t end = find_end(text, in_quotes ? "\"" : in_parentheses ? ")" : " \t", inside);
    out.push_back(text.substr(inside, end - inside));
    text.remove_prefix(std::min(end + inside, text.size()));
  }
  return out;
}

// One word of a field, "" if there is none.
std::string_view word(const Head& head, std::string_view name, std::size_t place) {
  const Words words = field_words(field(head, name));
  return place < words.size() ? words[place] : std::string_view();
}

double nrrd_number(const Head& head, std::string_view name, std::size_t place) {
  const std::string_view text = word(head, name, place);
  const auto out = number_of(text);
  if (!out) refuse("{} {} in the header is not a number", name, quoted(text));
  return *out;
}

struct Axes {
  std::size_t x = 0, y = 1;
  Shape shape;
};

// Removes last axes of length 1 until two remain.
Axes axes_of(const Head& head) {
  const Words words = field_words(head.text("sizes"));
  const Index dimension = head.count("dimension"), count = static_cast<Index>(words.size());
  if (count != dimension) refuse("the header has {} for dimension {}", counted(count, "size"), dimension);
  const auto size = [&](std::size_t axis) { return whole_number_of(words[axis]).value_or(0); };
  std::vector<std::size_t> axes(words.size());
  std::iota(axes.begin(), axes.end(), 0);
  for (std::size_t axis = words.size(); axis-- > 0 && axes.size() > 2;)
    if (size(axis) == 1) std::erase(axes, axis);
  if (axes.size() != 2)
    refuse("the array has {}, a map has 2", counted(static_cast<Index>(axes.size()), "dimension"));
  return {axes[0], axes[1], {size(axes[0]), size(axes[1])}};
}

// The components of a space direction; empty for "none".
std::vector<double> components_of(std::string_view direction) {
  std::vector<double> out;
  while (!direction.empty() && direction != "none") {
    const std::size_t end = find_end(direction, ",", 0);
    const auto component = number_of(trimmed(direction.substr(0, end)));
    if (!component) refuse("space directions {} in the header is not a number", quoted(direction));
    out.push_back(*component);
    direction.remove_prefix(std::min(end + 1, direction.size()));
  }
  return out;
}

// In the units of the space.
double direction_length(const std::vector<double>& direction, const Head& head) {
  double length = direction.empty() ? Map::unknown : 0;
  for (std::size_t i = 0; i < direction.size(); ++i) {
    const std::string_view unit = word(head, "space units", i);
    if (unit.empty()) return Map::unknown;
    length = std::hypot(length, direction[i] * metres_per(unit));
  }
  return length;
}

// Reverses an axis that runs against its direction. A map may be rotated in the plane, but not mirrored.
void orient(Field& values, const Head& head, const Axes& axes) {
  const std::vector<double> x = components_of(word(head, "space directions", axes.x)),
                            y = components_of(word(head, "space directions", axes.y));
  const auto flat = [](const std::vector<double>& d) {
    return d.size() == 2 || (d.size() == 3 && d[2] == 0);
  };
  if (!flat(x) || !flat(y)) return;
  if (x[1] != 0 || y[0] != 0) {
    if (x[0] * y[1] < x[1] * y[0]) refuse("space directions mirror the map: write it along x and y");
    return;
  }
  if (x[0] < 0) values = values.colwise().reverse().eval();
  if (y[1] < 0) values = values.rowwise().reverse().eval();
}

bool agree(double a, double b) { return std::abs(a - b) <= 1e-3 * std::abs(b); }

// Of axis mins and maxs in the unit of the axis. Without centers they are those of pixels, unless those of
// points give the spacing that is known.
double range_step(const Head& head, std::size_t axis, Index points, double known) {
  if (field(head, "axis mins").empty() || field(head, "axis maxs").empty()) return Map::unknown;
  const double range = nrrd_number(head, "axis maxs", axis) - nrrd_number(head, "axis mins", axis);
  const double pixels = range / static_cast<double>(points), nodes = range / static_cast<double>(points - 1);
  const std::string_view centers = word(head, head.has("centers") ? "centers" : "centerings", axis);
  return centers == "node" || (centers.empty() && agree(nodes, known)) ? nodes : pixels;
}

double axis_spacing(const Head& head, std::size_t axis, Index points) {
  const std::string_view unit = word(head, "units", axis);
  double out = direction_length(components_of(word(head, "space directions", axis)), head);
  const auto settle = [&](const char* name, double spacing) {
    if (std::isnan(out)) out = spacing;
    if (!std::isnan(spacing) && !agree(spacing, out))
      refuse("the header gives the spacing {} m, and {} m by its {}: remove one", out, spacing, name);
  };
  if (const double metres = unit.empty() ? 0 : metres_per(unit); metres > 0) {
    if (!field(head, "spacings").empty()) settle("spacings", nrrd_number(head, "spacings", axis) * metres);
    settle("axis mins and maxs", range_step(head, axis, points, out / metres) * metres);
  }
  if (!std::isnan(out) && !(out > 0 && std::isfinite(out)))
    refuse("the spacing in the header is not positive");
  return out;
}

NumberType nrrd_type(const Head& head) {
  const std::string name = lower(head.text("type"));
  for (const Type& type : nrrd_types)
    if (name.find('|') == name.npos && type.names.find("|" + name + "|") != type.names.npos) return type.type;
  refuse("number type {} is not supported", quoted(name));
}

std::endian endian_of(const Head& head, NumberType type) {
  const std::string name = lower(head.text("endian"));
  if (name == "big") return std::endian::big;
  if (name != "little" && size_of(type) > 1)
    refuse("endian {} in the header is not little or big", quoted(name));
  return std::endian::little;
}

Field values_of(const Head& head, std::string_view bytes, Shape shape, const Reading& reading) {
  const std::string encoding = lower(head.text("encoding"));
  const NumberType type = nrrd_type(head);
  if (encoding == "text" || encoding == "txt" || encoding == "ascii")
    return field_of_lines(bytes, shape, head.lines() + 1, reading);
  const Raster raster{type, endian_of(head, type)};
  if (encoding == "raw") return field_from(bytes, shape, raster, reading.memory);
  if (encoding != "gzip" && encoding != "gz")
    refuse("encoding {} is not supported: write raw, text or gzip", quoted(encoding));
  check_shape(shape, most_inflated * bytes.size() / size_of(type));
  reading.memory.require_map(shape, "map");
  const std::size_t size = static_cast<std::size_t>(shape.cells()) * size_of(type);
  return field_from(inflated(bytes, size), shape, raster, reading.memory);
}

void check_attached(const Head& head) {
  if (!field(head, "data file").empty())
    refuse("data in another file are not supported: write header and data into one file");
  for (const std::string_view skip : {"line skip", "byte skip"})
    if (const auto value = field(head, skip); !value.empty() && value != "0")
      refuse("{} in the header is not supported", skip);
}

bool is_nrrd(std::string_view bytes) {
  return bytes.size() > 8 && bytes.starts_with("NRRD000") && bytes[7] >= '1' && bytes[7] <= '5' &&
         (bytes[8] == '\n' || bytes[8] == '\r');
}

Map decode_nrrd(std::string_view bytes, const Reading& reading) {
  if (!is_nrrd(bytes)) refuse("the file is not NRRD, version 1 to 5");
  const auto empty = [](std::string_view line) { return line.empty(); };
  const Head head(take_head(bytes, empty), ":");
  check_attached(head);
  const Axes axes = axes_of(head);
  const std::array spacing{axis_spacing(head, axes.x, axes.shape.nx),
                           axis_spacing(head, axes.y, axes.shape.ny)};
  Map map{.values = values_of(head, bytes, axes.shape, reading),
          .spacing = spacing,
          .title = std::string(head.text("content"))};
  leave_out_infinite(map);
  orient(map.values, head, axes);
  const std::string_view stated = field(head, "sample units"),
                         units = stated.starts_with('"') ? word(head, "sample units", 0) : stated;
  if (!units.empty()) set_units(map, units);
  return map;
}

std::string encode_nrrd(const Map& map, Order) {
  std::string out =
      fmt::format("NRRD0004\ntype: double\ndimension: 2\nsizes: {} {}\nspacings: {} {}\nunits: \"m\" \"m\"\n",
                  map.values.rows(), map.values.cols(), shortest(map.spacing[0]), shortest(map.spacing[1]));
  if (!map.units.empty()) out += fmt::format("sample units: \"{}\"\n", one_line(map.units));
  if (!map.title.empty()) out += fmt::format("content: {}\n", one_line(map.title));
  return out + "endian: little\nencoding: raw\n\n" + bytes_of(map.values);
}

}  // namespace

const Format format::nrrd{"nrrd", "nrrd", "NRRD, nearly raw raster data", is_nrrd, decode_nrrd, encode_nrrd};

}  // namespace asperity
