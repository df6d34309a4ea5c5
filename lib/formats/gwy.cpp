/// GWY, Gwyddion's native format.
///
///     GWYP                       then an object, a GwyContainer, of components
///     /0/data                    GwyDataField, the map of channel 0; other channels have other numbers
///     /0/data/title              its name
///     /0/mask                    GwyDataField of the same points; a value above 0 marks a missing point
/// A GwyDataField has
///     xres, yres                 points along a line, x; lines, y
///     xreal, yreal               size of the area of all pixels, default 1
///     si_unit_xy, si_unit_z      GwySIUnit with a unitstr: of the size, a length; of the values. Unknown if
///                                missing or empty
///     data                       doubles, line by line from the top of the image, the smallest y here
/// Channels are chosen as chosen_channel() in formats/format.hpp says. Their positions (xoff, yoff), and
/// whatever else a file holds (graphs, spectra, volumes, points, selections, the log), are ignored. NaN is a
/// missing point too.
///
/// Files are written with one channel, visible, in doubles: exact. Gwyddion knows no missing values. Their
/// points are in the mask, and have the mean of the others. The middle of the map is at 0, as in a dataset. A
/// file has at most 4 GiB, an object's size being of 32 bits.
///
/// An object is its class's name, NUL, the size of its body in four bytes, and the body: components, each a
/// name, NUL, a letter for its type, and a value:
///
///     b, c         a truth value, a character: one byte; C: several characters
///     i, q, d      a whole number of 32 or 64 bits, a double; I, Q, D: several
///     s, S         a string that ends with NUL; several
///     o, O         an object; several
///
/// Several values follow their number, in four bytes. All numbers are least significant byte first. Nothing
/// is copied: a component is a view of the file, and the objects in it are views of their bodies.
///
/// Gwyddion user guide, Gwyddion native data file format,
/// http://gwyddion.net/documentation/user-guide-en/gwyfile-format.html
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"

namespace asperity {
namespace {

constexpr std::string_view gwy_magic = "GWYP", old_magic = "GWYO", field_class = "GwyDataField";
constexpr std::size_t most_channels = 4096;

// ---- serialised objects ----

struct GwyComponent {
  std::string_view name = {};
  char type = 0;
  std::string_view kind = {};   //< an object's class
  std::string_view value = {};  //< bytes of the number or numbers; a string without its NUL; an object's body
};

// The components of an object, one after the other.
class GwyComponents {
 public:
  explicit GwyComponents(std::string_view body) : rest_(body) {}
  // Nothing at the end. Throws DataError("map", …) where the body is cut short or of an unknown type.
  std::optional<GwyComponent> next();

 private:
  std::string_view rest_;
};

// An object at the beginning of the bytes, removed from them: its class and its body.
GwyComponent take_gwy_object(std::string_view& bytes);

std::string_view take_bytes(std::string_view& bytes, std::size_t size) {
  if (size > bytes.size())
    refuse("the file is cut short: a component needs {} bytes more", size - bytes.size());
  const std::string_view out = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return out;
}

std::size_t take_count(std::string_view& bytes) {
  return number_from<std::uint32_t>(take_bytes(bytes, 4).data(), std::endian::little);
}

std::string_view take_string(std::string_view& bytes) {
  const std::size_t end = bytes.find('\0');
  if (end == bytes.npos) refuse("the file is cut short: a name has no end");
  const std::string_view out = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  return out;
}

// The size of a number of this type, 0 if it is none.
std::size_t size_of_number(char type) {
  switch (type) {
    case 'b':
    case 'c':
      return 1;
    case 'i':
      return 4;
    case 'q':
    case 'd':
      return 8;
    default:
      return 0;
  }
}

// Strings or objects; each takes a byte at least, so that a false number of them ends with the bytes.
std::string_view take_several(std::string_view& bytes, char type) {
  const std::string_view all = bytes;
  const std::size_t count = take_count(bytes);
  for (std::size_t i = 0; i < count; ++i)
    type == 'S' ? static_cast<void>(take_string(bytes)) : static_cast<void>(take_gwy_object(bytes));
  return all.substr(0, all.size() - bytes.size());
}

GwyComponent take_gwy_object(std::string_view& bytes) {
  GwyComponent out{.type = 'o'};
  out.kind = take_string(bytes);
  out.value = take_bytes(bytes, take_count(bytes));
  return out;
}

std::optional<GwyComponent> GwyComponents::next() {
  if (rest_.empty()) return std::nullopt;
  GwyComponent out;
  out.name = take_string(rest_);
  out.type = take_bytes(rest_, 1).front();
  if (const std::size_t size = size_of_number(out.type)) {
    out.value = take_bytes(rest_, size);
  } else if (const std::size_t each = size_of_number(static_cast<char>(out.type + ('a' - 'A')))) {
    out.value = take_bytes(rest_, each * take_count(rest_));
  } else if (out.type == 's') {
    out.value = take_string(rest_);
  } else if (out.type == 'o') {
    const GwyComponent object = take_gwy_object(rest_);
    out.kind = object.kind;
    out.value = object.value;
  } else if (out.type == 'S' || out.type == 'O') {
    out.value = take_several(rest_, out.type);
  } else {
    refuse("component {} has an unknown type, {}", quoted(out.name), quoted({&out.type, 1}));
  }
  return out;
}

// ---- reading ----

struct GwyField {
  Shape shape{0, 0};
  std::array<double, 2> size{1, 1};
  std::string_view unit_xy = {}, unit = {}, data = {};
};

template <class T>
T gwy_number(const GwyComponent& c) {
  return number_from<T>(c.value.data(), std::endian::little);
}

std::string_view unit_in(std::string_view body) {
  GwyComponents parts(body);
  while (const auto c = parts.next())
    if (c->name == "unitstr" && c->type == 's') return c->value;
  return {};
}

GwyField field_in(std::string_view body) {
  GwyField out;
  GwyComponents parts(body);
  while (const auto c = parts.next()) {
    if (c->name == "xres" && c->type == 'i') out.shape.nx = gwy_number<std::int32_t>(*c);
    if (c->name == "yres" && c->type == 'i') out.shape.ny = gwy_number<std::int32_t>(*c);
    if (c->name == "xreal" && c->type == 'd') out.size[0] = gwy_number<double>(*c);
    if (c->name == "yreal" && c->type == 'd') out.size[1] = gwy_number<double>(*c);
    if (c->name == "si_unit_xy" && c->type == 'o') out.unit_xy = unit_in(c->value);
    if (c->name == "si_unit_z" && c->type == 'o') out.unit = unit_in(c->value);
    if (c->name == "data" && c->type == 'D') out.data = c->value;
  }
  return out;
}

struct Parts {
  std::string_view data, mask, title;
};

// Channels by their numbers.
std::map<Index, Parts> channels_in(std::string_view body) {
  std::map<Index, Parts> out;
  GwyComponents components(body);
  while (const auto c = components.next()) {
    const std::size_t end = c->name.find('/', 1);
    if (!c->name.starts_with('/') || end == c->name.npos) continue;
    const auto number = to_number<Index>(c->name.substr(1, end - 1));
    const std::string_view part = c->name.substr(end + 1);
    const bool field = c->type == 'o' && c->kind == field_class;
    if (!number || *number < 0) continue;
    if (part == "data" && field) out[*number].data = c->value;
    if (part == "mask" && field) out[*number].mask = c->value;
    if (part == "data/title" && c->type == 's') out[*number].title = c->value;
    if (out.size() > most_channels) refuse("the file has more than {} channels", most_channels);
  }
  std::erase_if(out, [](const auto& entry) { return entry.second.data.empty(); });
  return out;
}

double gwy_spacing(double size, Index points, std::string_view unit, std::string_view name) {
  if (unit.empty()) return Map::unknown;
  if (!(size > 0 && std::isfinite(size))) refuse("{} {} of the channel is not positive", name, size);
  return size * metres_per(unit) / static_cast<double>(points);
}

void leave_out_masked(Field& values, const GwyField& mask) {
  if (!(mask.shape == shape_of(values)))
    refuse("the mask has {} x {} points, the map {} x {}", mask.shape.nx, mask.shape.ny, values.rows(),
           values.cols());
  const auto cells = static_cast<std::size_t>(values.size());
  if (mask.data.size() != cells * sizeof(double)) refuse("the mask has not as many points as its size says");
  for (std::size_t place = 0; place < cells; ++place)
    if (number_from<double>(mask.data.data() + place * sizeof(double), std::endian::little) > 0)
      values(static_cast<Index>(place) % values.rows(), static_cast<Index>(place) / values.rows()) =
          Map::unknown;
}

Map map_of_parts(const Parts& parts, const MemoryBound& memory) {
  const GwyField field = field_in(parts.data);
  Map map{.values = field_from(field.data, field.shape, {}, memory), .title = std::string(parts.title)};
  if (!parts.mask.empty()) leave_out_masked(map.values, field_in(parts.mask));
  leave_out_infinite(map);
  map.spacing = {gwy_spacing(field.size[0], field.shape.nx, field.unit_xy, "xreal"),
                 gwy_spacing(field.size[1], field.shape.ny, field.unit_xy, "yreal")};
  if (!field.unit.empty()) set_units(map, field.unit);
  return map;
}

bool is_gwy(std::string_view bytes) { return bytes.starts_with(gwy_magic) || bytes.starts_with(old_magic); }

Map decode_gwy(std::string_view bytes, const Reading& reading) {
  if (!is_gwy(bytes)) refuse("the file is not a Gwyddion file");
  if (bytes.starts_with(old_magic)) refuse("the file is of Gwyddion 1, only those of Gwyddion 2 are read");
  bytes.remove_prefix(gwy_magic.size());
  const GwyComponent container = take_gwy_object(bytes);
  if (container.kind != "GwyContainer")
    refuse("the file holds {}, only a GwyContainer is read", quoted(container.kind));
  refuse_rest(bytes, "map");
  const auto parts = channels_in(container.value);
  std::vector<Channel> channels;
  for (const auto& [number, p] : parts)
    channels.push_back({number, one_line(p.title), field_in(p.data).unit});
  const std::size_t chosen = chosen_channel(channels, reading.channel);
  return map_of_parts(parts.at(channels[chosen].number), reading.memory);
}

// ---- writing ----

void append_name(std::string& out, std::string_view name) {
  out.append(name);
  out += '\0';
}

// The value follows.
void begin_component(std::string& out, std::string_view name, char type) {
  append_name(out, name);
  out += type;
}

template <class T>
void append_component(std::string& out, std::string_view name, char type, T number) {
  begin_component(out, name, type);
  append_bytes(out, number);
}

// An object with what `body` appends.
template <class Body>
void append_object(std::string& out, std::string_view kind, Body body) {
  append_name(out, kind);
  const std::size_t place = out.size();
  append_bytes(out, std::uint32_t{0});
  body();
  const auto size = bytes_of(static_cast<std::uint32_t>(out.size() - place - 4), std::endian::little);
  std::ranges::copy(size, out.begin() + static_cast<std::ptrdiff_t>(place));
}

void append_unit(std::string& out, std::string_view name, std::string_view unit) {
  begin_component(out, name, 'o');
  append_object(out, "GwySIUnit", [&] {
    begin_component(out, "unitstr", 's');
    append_name(out, unit);
  });
}

// A map without a size is as large as its points are many, in no unit.
void append_field(std::string& out, std::string_view name, const Field& values, const Map& map,
                  std::string_view unit) {
  const bool sized = std::isfinite(map.spacing[0]) && std::isfinite(map.spacing[1]);
  const std::pair<std::string, Index> axes[] = {{"x", values.rows()}, {"y", values.cols()}};
  begin_component(out, name, 'o');
  append_object(out, field_class, [&] {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& [axis, points] = axes[i];
      const double size = (sized ? map.spacing[i] : 1) * static_cast<double>(points);
      append_component(out, axis + "res", 'i', static_cast<std::int32_t>(points));
      append_component(out, axis + "real", 'd', size);
      append_component(out, axis + "off", 'd', -size / 2);
    }
    append_unit(out, "si_unit_xy", sized ? "m" : "");
    append_unit(out, "si_unit_z", unit);
    append_component(out, "data", 'D', static_cast<std::uint32_t>(values.size()));
    out += bytes_of(values);
  });
}

void check_gwy(const Map& map) {
  constexpr double most = std::numeric_limits<std::uint32_t>::max() - 4096.0;  // for what is no number
  const double fields = map.values.hasNaN() ? 2 : 1, points = static_cast<double>(map.values.size());
  const double longest = 16 * static_cast<double>(longest_line);  // the title
  if (fields * points * sizeof(double) + longest > most)
    refuse("GWY holds at most 4 GiB, the map of {} x {} points needs more", map.values.rows(),
           map.values.cols());
}

std::string encode_gwy(const Map& map, Order) {
  check_gwy(map);
  const auto missing = map.values.isNaN();
  const double present = static_cast<double>((!missing).count());
  const double mean = present > 0 ? missing.select(0.0, map.values).sum() / present : 0;
  std::string out(gwy_magic);
  append_object(out, "GwyContainer", [&] {
    append_field(out, "/0/data", missing.select(mean, map.values), map, one_line(map.units));
    if (!map.title.empty()) begin_component(out, "/0/data/title", 's'), append_name(out, one_line(map.title));
    append_component(out, "/0/data/visible", 'b', std::uint8_t{1});
    if (missing.any()) append_field(out, "/0/mask", missing.cast<double>(), map, "");
  });
  return out;
}

}  // namespace

const Format format::gwy{"gwy",      "gwy",      "Gwyddion's native format", is_gwy,
                         decode_gwy, encode_gwy, Numbers::doubles,           true};

}  // namespace asperity
