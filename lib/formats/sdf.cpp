/// SDF, the surface data file of ISO 25178-71, text and binary.
///
///     aISO-1.0                   a for text, b for binary; ISO-1.0, ISO-2.0, or BCR-1.0, the proposal
///     ManufacID = Asperity       10 characters in binary; CreateDate and ModDate 12 (ddmmyyyyhhmm)
///     NumPoints = 5              per line, x; two bytes in binary, four in ISO-2.0. NumProfiles: lines, y
///     Xscale = 1e-6              spacing [m]; a double in binary, as are Yscale, Zscale, Zresolution
///     Zscale = 1                 metres per unit of the numbers
///     Compression = 0            one byte in binary, as DataType and CheckType; other values are refused
///     DataType = 7               0 to 2 unsigned, 4 to 6 signed, of 8, 16, 32 bits, 3 floats, 7 doubles
///     CheckType = 0
///     *
/// and the numbers, line by line from the smallest y, up to another * or the end of the file. Text after it
/// is ignored, a second map is refused. In text the names may have any order. Binary files have no names; all
/// numbers are least significant byte first (the only order in the standard), and the data follow the 81 (85)
/// bytes of the header directly, or two fields of four bytes that Olympus inserts. With a single line, a
/// Yscale that is not positive leaves the spacing in y unknown.
///
/// A missing point is BAD in text. In binary it is NaN or the largest number of either sign for floating
/// types, the largest for unsigned types, and the smallest for signed ones; in BCR, the largest too.
///
/// Gwyddion cannot read missing points in text, neither the standard's BAD nor any other, and refuses such
/// `sdf-ascii`. In binary it masks them: use `sdf` for Gwyddion.
///
/// `sdf` is written with doubles and NaN for missing points, `sdf-ascii` with the shortest decimal fractions:
/// both are exact. Both hold only heights in metres, with at most 65535 points per side. The dates are
/// 1 January 2000, so that the same map gives the same bytes.
///
/// ISO 25178-71:2017; types and missing values of BCR as in Gwyddion 2.61 and sdfio.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <type_traits>

#include "dataset/bytes.hpp"
#include "formats/format.hpp"
#include "formats/head.hpp"
#include "formats/raster.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr NumberType sdf_types[] = {NumberType::uint8,   NumberType::uint16, NumberType::uint32,
                                    NumberType::float32, NumberType::int8,   NumberType::int16,
                                    NumberType::int32,   NumberType::float64};
constexpr std::size_t binary_head = 81;
constexpr Index most = 65535;
constexpr std::string_view maker = "Asperity", date = "010120000000";
constexpr std::string_view olympus("\5\0\0\0\1\0\0\0", 8);  // between the header and the numbers

// The content of both kinds of header.
struct SdfHead {
  Shape shape;
  double dx = 0, dy = 0, unit = 0;
  Index compression = 0, type = 0, check = 0;
};

bool is_sdf(std::string_view bytes, char kind) {
  const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(bytes[i])) != 0; };
  if (bytes.size() < 8 || bytes[0] != kind || bytes[4] != '-' || bytes[6] != '.') return false;
  const std::string_view name = bytes.substr(1, 3);
  return (name == "ISO" || name == "BCR") && digit(5) && digit(7);
}

void check_sdf_head(const SdfHead& d) {
  if (d.compression != 0) refuse("Compression {} is not supported, only 0", d.compression);
  if (d.check != 0) refuse("CheckType {} is not supported, only 0", d.check);
  if (d.type < 0 || d.type > 7) refuse("number type {} is not supported, only DataType 0 to 7", d.type);
  const auto positive = [](double scale) { return scale > 0 && std::isfinite(scale); };
  if (!positive(d.dx)) refuse("Xscale {} in the header is not positive", d.dx);
  if (d.shape.ny > 1 && !positive(d.dy)) refuse("Yscale {} in the header is not positive", d.dy);
  if (!positive(d.unit)) refuse("Zscale {} in the header is not positive", d.unit);
}

Map heights_of(Field values, const SdfHead& d) {
  const bool known = d.dy > 0 && std::isfinite(d.dy);  // of a single line it may not be
  Map map{.values = std::move(values), .spacing = {d.dx, known ? d.dy : Map::unknown}, .units = "m"};
  leave_out_infinite(map);
  if (d.unit != 1) map.values *= d.unit;
  require_finite(map);
  return map;
}

// Text of the manufacturer may follow the numbers, but not a second map.
void check_trailer(std::string_view rest) {
  bool another = !is_text(rest);
  for (std::string_view lines = rest; !lines.empty() && !another;) {
    std::string_view line = trimmed(take_line(lines));
    line.remove_prefix(std::min(line.find_first_not_of('*'), line.size()));
    another = is_sdf(line, 'a') || is_sdf(line, 'b');
  }
  if (another) refuse_rest(rest, "map");
}

Map decode_sdf_text(std::string_view bytes, const Reading& reading) {
  const auto star = [](std::string_view line) { return line.starts_with('*'); };
  const Head head(take_head(bytes, star), "=");
  const SdfHead d{{head.count("NumPoints"), head.count("NumProfiles")},
                  head.number("Xscale"),
                  head.number("Yscale"),
                  head.number("Zscale"),
                  head.count("Compression"),
                  head.count("DataType"),
                  head.count("CheckType")};
  check_sdf_head(d);
  const std::size_t end = std::min(bytes.find('*'), bytes.size());
  Field values = field_of_lines(bytes.substr(0, end), d.shape, head.lines() + 1, reading);
  check_trailer(bytes.substr(std::min(end + 1, bytes.size())));
  return heights_of(std::move(values), d);
}

// Reads numbers from the bytes one after the other.
template <class T>
T take_number(std::string_view& bytes) {
  const T out = number_from<T>(bytes.data(), std::endian::little);
  bytes.remove_prefix(sizeof(T));
  return out;
}

template <class Count>
SdfHead take_binary_head(std::string_view& bytes) {
  if (bytes.size() < binary_head + 2 * (sizeof(Count) - 2)) refuse_cut_header();
  bytes.remove_prefix(8 + 10 + 12 + 12);
  SdfHead d;
  d.shape.nx = take_number<Count>(bytes);
  d.shape.ny = take_number<Count>(bytes);
  d.dx = take_number<double>(bytes);
  d.dy = take_number<double>(bytes);
  d.unit = take_number<double>(bytes);
  take_number<double>(bytes);  // Zresolution
  d.compression = take_number<std::uint8_t>(bytes);
  d.type = take_number<std::uint8_t>(bytes);
  d.check = take_number<std::uint8_t>(bytes);
  check_sdf_head(d);
  return d;
}

// The numbers that mark missing points; NaN fills in for a second mark.
std::array<double, 2> missing_of(NumberType type, bool bcr) {
  return with_type(type, [bcr]<class T>(T) -> std::array<double, 2> {
    const auto least = static_cast<double>(std::numeric_limits<T>::lowest()),
               greatest = static_cast<double>(std::numeric_limits<T>::max());
    if (std::is_unsigned_v<T>) return {Map::unknown, greatest};
    return {least, std::is_floating_point_v<T> || bcr ? greatest : Map::unknown};
  });
}

Map decode_sdf_binary(std::string_view bytes, const Reading& reading) {
  const std::string_view version = bytes.substr(1, 7);
  const SdfHead d =
      version == "ISO-2.0" ? take_binary_head<std::uint32_t>(bytes) : take_binary_head<std::uint16_t>(bytes);
  const NumberType type = sdf_types[d.type];
  check_shape(d.shape, bytes.size() / size_of(type));
  const std::size_t numbers = static_cast<std::size_t>(d.shape.cells()) * size_of(type);
  if (bytes.size() == numbers + olympus.size() && bytes.starts_with(olympus))
    bytes.remove_prefix(olympus.size());
  check_trailer(bytes.substr(numbers));
  Field values = field_from(bytes.substr(0, numbers), d.shape, {type}, reading.memory);
  const auto [least, greatest] = missing_of(type, version.starts_with("BCR"));
  values = (values == least || values == greatest).select(Map::unknown, values);
  return heights_of(std::move(values), d);
}

void check_sdf(const Map& map) {
  check_heights(map, "SDF");
  if (std::max(map.values.rows(), map.values.cols()) > most)
    refuse("SDF holds at most 65535 points per side, the map has {} x {}", map.values.rows(),
           map.values.cols());
}

bool is_sdf_binary(std::string_view bytes) { return is_sdf(bytes, 'b'); }
bool is_sdf_text(std::string_view bytes) { return is_sdf(bytes, 'a'); }

// Reads both kinds.
Map decode_sdf(std::string_view bytes, const Reading& reading) {
  if (is_sdf_binary(bytes)) return decode_sdf_binary(bytes, reading);
  if (is_sdf_text(bytes)) return decode_sdf_text(bytes, reading);
  refuse("the file is not SDF, ISO 25178-71 or BCR");
}

std::string encode_sdf_binary(const Map& map, Order) {
  check_sdf(map);
  std::string out = fmt::format("bISO-1.0{:10}{}{}", maker, date, date);
  append_bytes(out, static_cast<std::uint16_t>(map.values.rows()));
  append_bytes(out, static_cast<std::uint16_t>(map.values.cols()));
  for (const double number : {map.spacing[0], map.spacing[1], 1.0, -1.0}) append_bytes(out, number);
  out += std::string("\0\7\0", 3);
  return out + bytes_of(map.values);
}

std::string encode_sdf_text(const Map& map, Order) {
  check_sdf(map);
  const std::string head = fmt::format(
      "aISO-1.0\nManufacID = {0}\nCreateDate = {1}\nModDate = {1}\nNumPoints = {2}\nNumProfiles = {3}\n"
      "Xscale = {4}\nYscale = {5}\nZscale = 1\nZresolution = -1\nCompression = 0\nDataType = 7\n"
      "CheckType = 0\n*\n",
      maker, date, map.values.rows(), map.values.cols(), shortest(map.spacing[0]), shortest(map.spacing[1]));
  return head + text_of(map.values.transpose(), ' ', "BAD") + "*\n*\n";
}

}  // namespace

const Format format::sdf{"sdf",         "sdf",      "SDF, ISO 25178-71, doubles",
                         is_sdf_binary, decode_sdf, encode_sdf_binary};
const Format format::sdf_ascii{"sdf-ascii", "",         "SDF, ISO 25178-71, in text",
                               is_sdf_text, decode_sdf, encode_sdf_text};

}  // namespace asperity
