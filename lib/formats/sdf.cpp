#include "formats/sdf.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/error.hpp"
#include "dataset/rest.hpp"
#include "formats/format.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr NumberType types[] = {NumberType::uint8,   NumberType::uint16, NumberType::uint32,
                                NumberType::float32, NumberType::int8,   NumberType::int16,
                                NumberType::int32,   NumberType::float64};
constexpr std::size_t binary_head = 81;
constexpr Index most = 65535;
constexpr std::string_view maker = "Asperity", date = "010120000000";

// What both kinds of head say.
struct Described {
  Shape shape;
  double dx = 0, dy = 0, unit = 0;
  Index compression = 0, type = 0, check = 0;
};

bool recognises(std::string_view bytes, char kind) {
  const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(bytes[i])) != 0; };
  if (bytes.size() < 8 || bytes[0] != kind || bytes[4] != '-' || bytes[6] != '.') return false;
  const std::string_view name = bytes.substr(1, 3);
  return (name == "ISO" || name == "BCR") && digit(5) && digit(7);
}

void check(const Described& d) {
  const auto refuse = [](const std::string& what) { throw DataError("map", what); };
  if (d.compression != 0) refuse("its numbers are compressed, which is not read");
  if (d.check != 0)
    refuse("it has checksums of CheckType " + std::to_string(d.check) + ", which are not read");
  if (d.type < 0 || d.type > 7) refuse("its DataType " + std::to_string(d.type) + " is none of 0 to 7");
  if (!(d.dx > 0 && std::isfinite(d.dx))) refuse("its Xscale is not positive");
  if (d.shape.ny > 1 && !(d.dy > 0 && std::isfinite(d.dy))) refuse("its Yscale is not positive");
  if (!(d.unit > 0 && std::isfinite(d.unit))) refuse("its Zscale is not positive");
}

Map heights_of(Field values, const Described& d) {
  Map map{.values = std::move(values), .spacing = {d.dx, d.shape.ny > 1 ? d.dy : Map::unknown}, .units = "m"};
  if (d.unit != 1) map.values *= d.unit;
  return map;
}

// The maker's text may follow the numbers, and no second map.
void check_trailer(std::string_view rest) {
  bool another = !is_text(rest);
  for (std::string_view lines = rest; !lines.empty() && !another;) {
    std::string_view line = trimmed(take_line(lines));
    line.remove_prefix(std::min(line.find_first_not_of('*'), line.size()));
    another = recognises(line, 'a') || recognises(line, 'b');
  }
  if (another) refuse_rest(rest, "map");
}

Map decode_text(std::string_view bytes, const Reading& reading) {
  std::size_t lines = 0;
  const auto star = [](std::string_view line) { return line.starts_with('*'); };
  const Head head(take_head(bytes, lines, star, "a line that begins with *"), "=");
  const Described d{{head.count("NumPoints"), head.count("NumProfiles")},
                    head.number("Xscale"),
                    head.number("Yscale"),
                    head.number("Zscale"),
                    head.count("Compression"),
                    head.count("DataType"),
                    head.count("CheckType")};
  check(d);
  const std::size_t end = std::min(bytes.find('*'), bytes.size());
  Field values = field_of_lines(bytes.substr(0, end), d.shape, "map", lines + 1, reading);
  check_trailer(bytes.substr(std::min(end + 1, bytes.size())));
  return heights_of(std::move(values), d);
}

// Takes numbers off the bytes one after the other.
template <class T>
T take(std::string_view& bytes) {
  const T out = number_from<T>(bytes.data(), std::endian::little);
  bytes.remove_prefix(sizeof(T));
  return out;
}

template <class Count>
Described take_binary_head(std::string_view& bytes) {
  if (bytes.size() < binary_head + 2 * (sizeof(Count) - 2)) throw DataError("map", "its head is cut short");
  bytes.remove_prefix(8 + 10 + 12 + 12);
  Described d;
  d.shape.nx = take<Count>(bytes);
  d.shape.ny = take<Count>(bytes);
  d.dx = take<double>(bytes);
  d.dy = take<double>(bytes);
  d.unit = take<double>(bytes);
  take<double>(bytes);  // Zresolution
  d.compression = take<std::uint8_t>(bytes);
  d.type = take<std::uint8_t>(bytes);
  d.check = take<std::uint8_t>(bytes);
  check(d);
  return d;
}

// Olympus has the numbers 5 and 1 between the head and the rest.
void skip_olympus(std::string_view& bytes, const Described& d, NumberType type) {
  constexpr std::string_view between("\5\0\0\0\1\0\0\0", 8);
  check_shape(d.shape, bytes.size() / size_of(type), "map");
  const std::size_t expected = static_cast<std::size_t>(d.shape.cells()) * size_of(type);
  if (bytes.size() == expected + 8 && bytes.starts_with(between)) bytes.remove_prefix(8);
}

// The numbers that stand for none.
struct Missing {
  double least = Map::unknown, greatest = Map::unknown;
};

Missing missing_of(NumberType type, bool bcr) {
  return with_type(type, [bcr]<class T>(T) {
    using Limits = std::numeric_limits<T>;
    const Missing both{static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max())};
    if (std::is_unsigned_v<T>) return Missing{.greatest = both.greatest};
    return std::is_floating_point_v<T> || bcr ? both : Missing{.least = both.least};
  });
}

Map decode_binary(std::string_view bytes, const Reading& reading) {
  const std::string_view version = bytes.substr(1, 7);
  const Described d =
      version == "ISO-2.0" ? take_binary_head<std::uint32_t>(bytes) : take_binary_head<std::uint16_t>(bytes);
  const NumberType type = types[d.type];
  skip_olympus(bytes, d, type);
  const std::size_t numbers = static_cast<std::size_t>(d.shape.cells()) * size_of(type);
  check_trailer(bytes.substr(numbers));
  Field values = field_from(bytes.substr(0, numbers), d.shape, {type, std::endian::little, Order::yx}, "map",
                            reading.memory);
  const Missing missing = missing_of(type, version.starts_with("BCR"));
  values = (values == missing.least || values == missing.greatest).select(Map::unknown, values);
  return heights_of(std::move(values), d);
}

// The numbers of points and what the file can say of them.
void check_holds(const Map& map) {
  check_heights(map, "SDF");
  if (std::max(map.values.rows(), map.values.cols()) > most)
    throw DataError("map", "SDF holds 65535 points along each side, and this map has more");
}

template <class T>
void append(std::string& bytes, T number) {
  const auto raw = bytes_of(number, std::endian::little);
  bytes.append(raw.data(), raw.size());
}

}  // namespace

bool recognises_sdf(std::string_view bytes) { return recognises(bytes, 'b'); }
bool recognises_sdf_text(std::string_view bytes) { return recognises(bytes, 'a'); }

Map decode_sdf(std::string_view bytes, const Reading& reading) {
  if (recognises_sdf(bytes)) return decode_binary(bytes, reading);
  if (recognises_sdf_text(bytes)) return decode_text(bytes, reading);
  throw DataError("map", "it does not begin as an SDF of ISO 25178-71 or BCR");
}

std::string encode_sdf(const Map& map, Order) {
  check_holds(map);
  std::string out = "bISO-1.0" + std::string(maker) + "  " + std::string(date) + std::string(date);
  append(out, static_cast<std::uint16_t>(map.values.rows()));
  append(out, static_cast<std::uint16_t>(map.values.cols()));
  for (const double number : {map.spacing[0], map.spacing[1], 1.0, -1.0}) append(out, number);
  out += std::string("\0\7\0", 3);
  return out + bytes_of(map.values, {NumberType::float64, std::endian::little, Order::yx});
}

std::string encode_sdf_text(const Map& map, Order) {
  check_holds(map);
  const auto entry = [](std::string_view key, auto value) { return head_line(key, " = ", value); };
  std::string out =
      "aISO-1.0\n" + entry("ManufacID", maker) + entry("CreateDate", date) + entry("ModDate", date);
  out += entry("NumPoints", std::to_string(map.values.rows())) +
         entry("NumProfiles", std::to_string(map.values.cols()));
  out += entry("Xscale", map.spacing[0]) + entry("Yscale", map.spacing[1]) + entry("Zscale", 1.0) +
         entry("Zresolution", -1.0);
  out += "Compression = 0\nDataType = 7\nCheckType = 0\n*\n";
  return out + text_of(map.values.transpose(), ' ', "BAD") + "*\n*\n";
}

}  // namespace asperity
