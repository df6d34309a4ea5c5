/// SUR and PRO, the surfaces and profiles of Digital Surf's programs.
///
/// A head of 512 bytes, a comment and a private zone as long as the head says, and the numbers: signed, of 16
/// or 32 bits, line by line from the smallest y. All numbers are least significant byte first. Of the head:
///
///       0  DIGITAL SURF, or DSCOMPRESSED: the numbers are deflated
///      12  byte order, 0; others are refused
///      14  number of objects, and at 80 of channels of each; further objects have a head of their own
///      18  type: 1 a profile, 2 a surface, 5, 8, 11, 13, 16 several surfaces, 10 an image
///      20  name, 30 characters: the title
///      86  1 if points are missing; 94 numbers per point, 0 or 1; 98 bits per number, 16 or 32
///     100  least and greatest number, Zmin and Zmax; 108 points per line, x; 112 lines, y
///     120  spacing in x, in y, and the height of one step, floats; 180 their units
///     260  unit of the axis of heights; 334 sizes of the comment and of the private zone
///     474  height of zero, a float
/// A height is a number times the step, plus the height of zero: a profile and the surface that it was cut
/// from then agree (row 29 of a surface of 128, to the rounding of the floats), without it they do not. With
/// missing points, Zmin - 2 was not measured, Zmin - 1 and Zmax + 1 are beyond the range of the instrument:
/// what is outside Zmin to Zmax is missing. A height of zero with two units of height is ambiguous and
/// refused. A profile has the same spacing in y. Deflated numbers are a count of pieces, two sizes of each,
/// inflated and deflated, and the pieces, as zlib has them. Several objects are channels, chosen as
/// chosen_channel() in formats/format.hpp says. The comment, positions, times, and the record of what was
/// inverted and levelled are ignored. Other types are refused.
///
/// Files are written uncompressed, with 32 bits, lengths in mm, heights in µm. A height is the nearest of
/// 2^31 steps from the least to the greatest, and a spacing a float with a relative error of 6e-8.
///
/// Gwyddion 2.62 reads no deflated files, takes missing points for heights, and turns heights that the record
/// says were inverted.
///
/// Digital Surf, MountainsMap reference guide, surface file format; the height of zero as in Gwyddion and
/// surfalize, RosettaSciIO reads another.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/gzip.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace sur {
namespace {

constexpr std::string_view plain = "DIGITAL SURF", deflated = "DSCOMPRESSED";
constexpr std::size_t head_size = 512, name_size = 30, unit_size = 16;
constexpr std::endian order = std::endian::little;

enum Place : std::size_t {
  byte_order = 12,
  objects = 14,
  version = 16,
  object_type = 18,
  object_name = 20,
  channels_of_each = 80,
  special = 86,
  absolute = 88,
  numbers_per_point = 94,
  bits = 98,
  least = 100,
  greatest = 104,
  points_per_line = 108,
  lines = 112,
  points = 116,
  steps = 120,
  axis_names = 132,
  step_units = 180,
  axis_units = 228,
  unit_ratios = 276,
  comment_size = 334,
  private_size = 336,
  zero_height = 474
};

// ---- reading ----

struct Object {
  std::string_view head, numbers = {};
  bool is_deflated = false;

  template <class T>
  T number(Place place, std::size_t index = 0) const {
    return number_from<T>(head.data() + place + index * sizeof(T), order);
  }
  std::string_view text(Place place, std::size_t size, std::size_t index = 0) const {
    const std::string_view all = head.substr(place + index * size, size);
    return trimmed(all.substr(0, all.find('\0')));
  }
  std::size_t bytes_per_number() const { return number<std::int16_t>(bits) == 16 ? 2 : 4; }
  Shape shape() const { return {number<std::int32_t>(points_per_line), number<std::int32_t>(lines)}; }
};

bool is_sur(std::string_view bytes) { return bytes.starts_with(plain) || bytes.starts_with(deflated); }

void check_object(const Object& o) {
  if (const int code = o.number<std::int16_t>(byte_order); code != 0)
    refuse("byte order {} is not supported, only 0", code);
  constexpr int types[] = {1, 2, 5, 8, 10, 11, 13, 16};
  if (const int type = o.number<std::int16_t>(object_type); std::ranges::find(types, type) == std::end(types))
    refuse("object type {} is not supported, only profiles (1) and surfaces (2, 5, 8, 10, 11, 13, 16)", type);
  if (const auto count = o.number<std::uint32_t>(numbers_per_point); count > 1)
    refuse("the object has {} numbers per point, only one is supported", count);
  if (const int size = o.number<std::int16_t>(bits); size != 16 && size != 32)
    refuse("numbers of {} bits are not supported, only 16 and 32", size);
}

std::string_view take_part(std::string_view& bytes, std::size_t size) {
  if (size > bytes.size()) refuse("the file is cut short: it needs {} bytes more", size - bytes.size());
  const std::string_view out = bytes.substr(0, size);
  bytes.remove_prefix(size);
  return out;
}

// Of the pieces, with their sizes.
std::size_t size_of_pieces(std::string_view bytes) {
  const std::size_t all = bytes.size();
  const auto count = number_from<std::uint32_t>(take_part(bytes, 4).data(), order);
  std::string_view sizes = take_part(bytes, std::size_t{8} * count);
  for (; !sizes.empty(); sizes.remove_prefix(8))
    take_part(bytes, number_from<std::uint32_t>(sizes.data() + 4, order));
  return all - bytes.size();
}

Object take_object(std::string_view& bytes) {
  if (bytes.size() < head_size) refuse_cut_header();
  Object out{.head = bytes.substr(0, head_size), .is_deflated = bytes.starts_with(deflated)};
  check_object(out);
  bytes.remove_prefix(head_size);
  take_part(bytes,
            std::size_t{out.number<std::uint16_t>(comment_size)} + out.number<std::uint16_t>(private_size));
  check_shape(out.shape(), (out.is_deflated ? most_inflated : 1) * bytes.size() / out.bytes_per_number());
  const auto cells = static_cast<std::size_t>(out.shape().cells());
  out.numbers = take_part(bytes, out.is_deflated ? size_of_pieces(bytes) : cells * out.bytes_per_number());
  return out;
}

std::vector<Object> objects_in(std::string_view bytes) {
  std::vector<Object> out{take_object(bytes)};
  const auto several = [&](Place place) {
    return std::max<std::size_t>(out[0].number<std::uint16_t>(place), 1);
  };
  const std::size_t most = several(objects) * several(channels_of_each);
  while (out.size() < most && is_sur(bytes)) out.push_back(take_object(bytes));
  refuse_rest(bytes, "map");
  return out;
}

std::string joined_pieces(std::string_view pieces, std::size_t size) {
  const auto count = number_from<std::uint32_t>(take_part(pieces, 4).data(), order);
  std::string_view sizes = take_part(pieces, std::size_t{8} * count);
  std::string out;
  for (; !sizes.empty(); sizes.remove_prefix(8)) {
    const auto whole = number_from<std::uint32_t>(sizes.data(), order),
               stored = number_from<std::uint32_t>(sizes.data() + 4, order);
    if (whole > size - out.size()) refuse("the file holds more numbers than its header gives");
    out += inflated(take_part(pieces, stored), whole, Wrapper::zlib);
  }
  return out;
}

Field numbers_of(const Object& o, const MemoryBound& memory) {
  const Raster raster{.type = o.bytes_per_number() == 2 ? NumberType::int16 : NumberType::int32};
  memory.require_map(o.shape(), "map");
  if (!o.is_deflated) return field_from(o.numbers, o.shape(), raster, memory);
  const std::size_t size = static_cast<std::size_t>(o.shape().cells()) * o.bytes_per_number();
  return field_from(joined_pieces(o.numbers, size), o.shape(), raster, memory);
}

double positive_step(const Object& o, std::size_t axis) {
  const double step = o.number<float>(steps, axis);
  if (!(step > 0 && std::isfinite(step)))
    refuse("the {} {} in the header is not positive", axis < 2 ? "spacing" : "step of heights", step);
  return step;
}

double object_spacing(const Object& o, std::size_t axis) {
  const std::string_view unit = o.text(step_units, unit_size, axis);
  return unit.empty() ? Map::unknown : positive_step(o, axis) * metres_per(unit);
}

double height_of_zero(const Object& o) {
  const double height = o.number<float>(zero_height);
  const std::string_view unit = o.text(step_units, unit_size, 2), other = o.text(axis_units, unit_size, 2);
  if (!std::isfinite(height)) refuse("the height of zero, {}, in the header is not finite", height);
  if (height != 0 && !other.empty() && unit != other)
    refuse("the header has a height of zero and two units of height, {} and {}", quoted(unit), quoted(other));
  return height;
}

Map map_of_object(const Object& o, const MemoryBound& memory) {
  Map map{.values = numbers_of(o, memory),
          .spacing = {object_spacing(o, 0), o.shape().ny > 1 ? object_spacing(o, 1) : object_spacing(o, 0)},
          .title = std::string(o.text(object_name, name_size))};
  if (o.number<std::int16_t>(special) != 0) {
    const auto low = o.number<std::int32_t>(least), high = o.number<std::int32_t>(greatest);
    map.values = (map.values < low || map.values > high).select(Map::unknown, map.values);
  }
  map.values = map.values * positive_step(o, 2) + height_of_zero(o);
  if (const std::string_view unit = o.text(step_units, unit_size, 2); !unit.empty()) set_units(map, unit);
  return map;
}

Map decode_sur(std::string_view bytes, const Reading& reading) {
  if (!is_sur(bytes)) refuse("the file is not one of Digital Surf's");
  const std::vector<Object> all = objects_in(bytes);
  std::vector<Channel> channels;
  for (const Object& o : all)
    channels.push_back({static_cast<Index>(channels.size()), one_line(o.text(object_name, name_size)),
                        o.text(step_units, unit_size, 2)});
  return map_of_object(all[chosen_channel(channels, reading.channel)], reading.memory);
}

// ---- writing ----

// Whole numbers of a step that is a float, from a height of zero that is one.
struct Steps {
  Field numbers;
  float step = 1, zero = 0;
};

float single(double value, bool positive) {
  using Limits = std::numeric_limits<float>;
  if (!(std::abs(value) <= Limits::max()) || (positive && value < Limits::min()))
    refuse("{} does not fit into the single precision of SUR", shortest(value));
  return static_cast<float>(value);
}

Steps sur_steps(const Field& values) {
  const double half = std::ldexp(1.0, 30);
  if (values.isNaN().all()) return {Field::Zero(values.rows(), values.cols())};
  const double low = values.minCoeff<Eigen::PropagateNumbers>(),
               high = values.maxCoeff<Eigen::PropagateNumbers>();
  Steps out;
  out.zero = single(low + (high - low) / 2, false);
  const double reach = std::max(high - out.zero, out.zero - low);
  constexpr float least_step = std::numeric_limits<float>::min(), largest = std::numeric_limits<float>::max();
  if (reach > 0) out.step = std::max(std::nextafter(single(reach / half, false), largest), least_step);
  const double zero = out.zero;  // of what is missing, too: within the range
  out.numbers = ((values.isNaN().select(zero, values) - zero) / out.step).round();
  return out;
}

template <class T>
void put(std::string& head, Place place, T number, std::size_t index = 0) {
  std::ranges::copy(bytes_of(number, order),
                    head.begin() + static_cast<std::ptrdiff_t>(place + index * sizeof number));
}

void put_text(std::string& head, Place place, std::string_view text, std::size_t size,
              std::size_t index = 0) {
  text = text.substr(0, size);
  head.replace(place + index * size, text.size(), text);
}

// As many whole characters as there is place for.
std::string shortened(std::string text, std::size_t size) {
  if (text.size() > size) text.resize(size);
  while (!is_utf8(text)) text.pop_back();
  return text;
}

std::string sur_head(const Map& map) {
  std::string out(head_size, '\0');
  const Shape shape = shape_of(map.values);
  put_text(out, Place{0}, plain, plain.size());
  put(out, objects, std::int16_t{1});
  put(out, version, std::int16_t{1});
  put(out, object_type, static_cast<std::int16_t>(shape.ny > 1 ? 2 : 1));
  put_text(out, object_name, std::string(name_size, ' '), name_size);
  put_text(out, object_name, shortened(one_line(map.title), name_size), name_size);
  put(out, absolute, std::int16_t{1});
  put(out, bits, std::int16_t{32});
  put(out, points_per_line, static_cast<std::int32_t>(shape.nx));
  put(out, lines, static_cast<std::int32_t>(shape.ny));
  put(out, points, static_cast<std::int32_t>(shape.cells()));
  const std::string height = map.units.empty() || map.units == "m" ? "\xb5m" : map.units;
  const std::string names[] = {"X", "Y", "Z"}, units[] = {"mm", "mm", height};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put_text(out, axis_names, names[axis], unit_size, axis);
    put_text(out, step_units, units[axis], unit_size, axis);
    put_text(out, axis_units, units[axis], unit_size, axis);
    put(out, unit_ratios, 1.f, axis);
    if (axis < 2) put(out, steps, single(1e3 * map.spacing[axis], true), axis);
  }
  return out;
}

std::string encode_sur(const Map& map, Order) {
  check_size(map, "SUR");
  if (map.units.size() >= unit_size)
    refuse("SUR holds units of 15 characters, not '{}'", one_line(map.units, 24));
  if (map.values.size() > std::numeric_limits<std::int32_t>::max())
    refuse("SUR holds at most 2^31 - 1 points, the map has {} x {}", map.values.rows(), map.values.cols());
  const bool lengths = map.units.empty() || map.units == "m";
  Steps steps_in = sur_steps(lengths ? Field(1e6 * map.values) : map.values);
  std::string out = sur_head(map);
  const double low = steps_in.numbers.minCoeff(), high = steps_in.numbers.maxCoeff();
  put(out, least, static_cast<std::int32_t>(low));
  put(out, greatest, static_cast<std::int32_t>(high));
  put(out, steps, steps_in.step, 2);
  put(out, zero_height, steps_in.zero);
  if (map.values.hasNaN()) {
    put(out, special, std::int16_t{1});
    steps_in.numbers = map.values.isNaN().select(low - 2, steps_in.numbers);
  }
  return out + bytes_of(steps_in.numbers, {.type = NumberType::int32});
}

}  // namespace
}  // namespace sur

const Format format::sur{
    "sur",          "sur pro", "SUR and PRO, Digital Surf", sur::is_sur, sur::decode_sur, sur::encode_sur,
    Numbers::steps, true};

}  // namespace asperity
