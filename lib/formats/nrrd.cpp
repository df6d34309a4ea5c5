#include "formats/nrrd.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/gzip.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t most_axes = 16;  // teem's own

struct Type {
  NumberType type;
  std::string_view names;  // between bars
};

constexpr Type types[] = {
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

[[noreturn]] void refuse(const std::string& what) { throw DataError("map", what); }

std::string quoted(std::string_view text) { return "'" + one_line(text, 24) + "'"; }

// A field that has two spellings, with a blank and without.
std::string_view field(const Head& head, std::string_view name) {
  if (head.has(name)) return head.text(name);
  std::string joined(name);
  std::erase(joined, ' ');
  return head.text(joined);
}

// The first of some characters from a place on, or the end.
std::size_t find_end(std::string_view text, std::string_view ends, std::size_t from) {
  return std::min(text.find_first_of(ends, from), text.size());
}

// Words between blanks, or what is between quotes, or between parentheses.
Words words_of(std::string_view text) {
  Words out;
  while (!(text = trimmed(text)).empty()) {
    if (out.size() == most_axes) refuse("it has more than 16 axes");
    const bool in_quotes = text.front() == '"', in_parentheses = text.front() == '(',
               inside = in_quotes || in_parentheses;
    const std::size_t end = find_end(text, in_quotes ? "\"" : in_parentheses ? ")" : " \t", inside);
    out.push_back(text.substr(inside, end - inside));
    text.remove_prefix(std::min(end + inside, text.size()));
  }
  return out;
}

std::string_view word(const Words& words, std::size_t place) {
  return place < words.size() ? words[place] : std::string_view();
}

std::string_view unquoted(std::string_view text) {
  return text.starts_with('"') ? word(words_of(text), 0) : text;
}

double number_in(const Words& words, std::size_t place, std::string_view name) {
  const auto out = number_of(word(words, place));
  if (!out)
    refuse("its " + std::string(name) + " have " + quoted(word(words, place)) + ", which is no number");
  return *out;
}

struct Axes {
  std::size_t x = 0, y = 1;
  Shape shape;
};

// The last axes of 1 are left out until there are two.
Axes axes_of(const Head& head) {
  const Words words = words_of(head.text("sizes"));
  const Index dimension = head.count("dimension");
  if (static_cast<Index>(words.size()) != dimension)
    refuse("it has " + counted(static_cast<std::int64_t>(words.size()), "size") + " for a dimension of " +
           std::to_string(dimension));
  std::vector<Index> sizes;
  std::vector<std::size_t> axes;
  for (const std::string_view size : words) {
    axes.push_back(sizes.size());
    sizes.push_back(whole_number_of(size).value_or(0));
  }
  for (std::size_t axis = sizes.size(); axis-- > 0 && axes.size() > 2;)
    if (sizes[axis] == 1) axes.erase(axes.begin() + static_cast<std::ptrdiff_t>(axis));
  if (axes.size() != 2)
    refuse("it has " + counted(static_cast<std::int64_t>(axes.size()), "dimension") +
           ", where a map has two");
  return {axes[0], axes[1], {sizes[axes[0]], sizes[axes[1]]}};
}

// The components of a space direction; none of "none".
std::vector<double> components_of(std::string_view direction) {
  std::vector<double> out;
  while (!direction.empty() && direction != "none") {
    const std::size_t end = find_end(direction, ",", 0);
    const auto component = number_of(trimmed(direction.substr(0, end)));
    if (!component) refuse("its space directions have " + quoted(direction) + ", which is no number");
    out.push_back(*component);
    direction.remove_prefix(std::min(end + 1, direction.size()));
  }
  return out;
}

// They have the space's units.
double length_of(const std::vector<double>& direction, const Words& units) {
  double length = direction.empty() ? Map::unknown : 0;
  for (std::size_t i = 0; i < direction.size(); ++i) {
    if (word(units, i).empty()) return Map::unknown;
    length = std::hypot(length, direction[i] * metres_per(word(units, i), "map"));
  }
  return length;
}

// An axis that runs against its space's is turned around. One may be turned within the plane, where a map has axes of its
// own, but not mirrored.
void orient(Field& values, const Head& head, const Axes& axes) {
  const Words directions = words_of(field(head, "space directions"));
  const std::vector<double> x = components_of(word(directions, axes.x)),
                            y = components_of(word(directions, axes.y));
  const auto flat = [](const std::vector<double>& d) {
    return d.size() == 2 || (d.size() == 3 && d[2] == 0);
  };
  if (!flat(x) || !flat(y)) return;
  if (x[1] != 0 || y[0] != 0) {
    if (x[0] * y[1] < x[1] * y[0]) refuse("its space directions mirror it: write the map along x and y");
    return;
  }
  if (x[0] < 0) values = values.colwise().reverse().eval();
  if (y[1] < 0) values = values.rowwise().reverse().eval();
}

// In the axis's own unit.
double step_of(const Head& head, std::size_t axis, Index points) {
  const Words spacings = words_of(field(head, "spacings"));
  if (!spacings.empty()) return number_in(spacings, axis, "spacings");
  const Words from = words_of(field(head, "axis mins")), to = words_of(field(head, "axis maxs"));
  if (from.empty() || to.empty()) return Map::unknown;
  const Words centers = words_of(head.has("centers") ? head.text("centers") : head.text("centerings"));
  const Index steps = word(centers, axis) == "node" ? points - 1 : points;
  return (number_in(to, axis, "axis maxs") - number_in(from, axis, "axis mins")) / static_cast<double>(steps);
}

double spacing_of(const Head& head, std::size_t axis, Index points) {
  const Words directions = words_of(field(head, "space directions")), units = words_of(field(head, "units"));
  double out = Map::unknown;
  if (!directions.empty())
    out = length_of(components_of(word(directions, axis)), words_of(field(head, "space units")));
  else if (!word(units, axis).empty())
    out = step_of(head, axis, points) * metres_per(word(units, axis), "map");
  if (!std::isnan(out) && !(out > 0 && std::isfinite(out))) refuse("its spacing is not positive");
  return out;
}

NumberType type_of(const Head& head) {
  const std::string name = lower(head.text("type"));
  for (const Type& type : types)
    if (name.find('|') == name.npos && type.names.find("|" + name + "|") != type.names.npos) return type.type;
  refuse("its numbers are of type " + quoted(name) + ", which is not read");
}

std::endian endian_of(const Head& head, NumberType type) {
  const std::string name = lower(head.text("endian"));
  if (name == "big") return std::endian::big;
  if (name != "little" && size_of(type) > 1)
    refuse("its endian is " + quoted(name) + ", neither little nor big");
  return std::endian::little;
}

Field values_of(const Head& head, std::string_view bytes, Shape shape, std::size_t lines,
                const Reading& reading) {
  const std::string encoding = lower(head.text("encoding"));
  const NumberType type = type_of(head);
  if (encoding == "text" || encoding == "txt" || encoding == "ascii")
    return field_of_lines(bytes, shape, "map", lines + 1, reading);
  const Raster raster{type, endian_of(head, type), Order::yx};
  if (encoding == "raw") return field_from(bytes, shape, raster, "map", reading.memory);
  if (encoding != "gzip" && encoding != "gz")
    refuse("its encoding is " + quoted(encoding) + ", which is not read");
  check_shape(shape, most_inflated * bytes.size() / size_of(type), "map");
  reading.memory.require_map(shape, "map");
  const std::size_t size = static_cast<std::size_t>(shape.cells()) * size_of(type);
  return field_from(inflated(bytes, size, "map"), shape, raster, "map", reading.memory);
}

void check_attached(const Head& head) {
  if (!field(head, "data file").empty()) refuse("its data stand in another file, which is not read");
  for (const std::string_view skip : {"line skip", "byte skip"})
    if (const auto value = field(head, skip); !value.empty() && value != "0")
      refuse("it has a " + std::string(skip) + ", which is not read");
}

}  // namespace

bool recognises_nrrd(std::string_view bytes) {
  return bytes.size() > 8 && bytes.starts_with("NRRD000") && bytes[7] >= '1' && bytes[7] <= '5' &&
         (bytes[8] == '\n' || bytes[8] == '\r');
}

Map decode_nrrd(std::string_view bytes, const Reading& reading) {
  if (!recognises_nrrd(bytes)) refuse("it does not begin as NRRD0001 to NRRD0005");
  std::size_t lines = 0;
  const auto empty = [](std::string_view line) { return line.empty(); };
  const Head head(take_head(bytes, lines, empty, "an empty line"), ":");
  check_attached(head);
  const Axes axes = axes_of(head);
  const std::array spacing{spacing_of(head, axes.x, axes.shape.nx), spacing_of(head, axes.y, axes.shape.ny)};
  Map map{.values = values_of(head, bytes, axes.shape, lines, reading),
          .spacing = spacing,
          .title = std::string(head.text("content"))};
  orient(map.values, head, axes);
  if (const auto units = unquoted(field(head, "sample units")); !units.empty()) set_units(map, units);
  return map;
}

std::string encode_nrrd(const Map& map, Order) {
  const std::string spacings = shortest(map.spacing[0]) + " " + shortest(map.spacing[1]);
  const auto line = [](std::string_view name, std::string_view value) {
    return head_line(name, ": ", value);
  };
  std::string out = "NRRD0004\n" + line("type", "double") + line("dimension", "2");
  out += line("sizes", std::to_string(map.values.rows()) + " " + std::to_string(map.values.cols()));
  out += line("spacings", spacings) + line("units", "\"m\" \"m\"");
  if (!map.units.empty()) out += line("sample units", "\"" + map.units + "\"");
  if (!map.title.empty()) out += line("content", map.title);
  out += line("endian", "little") + line("encoding", "raw") + "\n";
  return out + bytes_of(map.values, {NumberType::float64, std::endian::little, Order::yx});
}

}  // namespace asperity
