#include "formats/esri.hpp"

#include <cctype>
#include <cmath>

#include "core/error.hpp"
#include "formats/head.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr std::string_view blanks = " \t";

bool begins_with_letter(std::string_view line) {
  return !line.empty() && std::isalpha(static_cast<unsigned char>(line.front())) != 0 &&
         !number_of(line.substr(0, line.find_first_of(blanks)));
}

struct Parts {
  Head head;
  std::string_view numbers;
  std::size_t lines;  // of the head
};

Parts parts_of(std::string_view bytes) {
  std::string_view rest = bytes;
  std::size_t lines = 0;
  for (std::string_view next = rest; begins_with_letter(trimmed(take_line(next))); rest = next) ++lines;
  return {{bytes.substr(0, bytes.size() - rest.size()), blanks}, rest, lines};
}

std::array<double, 2> spacing_of(const Head& head) {
  if (!head.has("dx") && !head.has("dy")) return {head.positive("cellsize"), head.positive("cellsize")};
  return {head.positive("dx"), head.positive("dy")};
}

// NODATA and numbers pass through single precision in many programs.
void remove_missing(Field& values, const Head& head) {
  if (lower(head.text("NODATA_value")) == "nan") return;
  const double nodata = head.number("NODATA_value");
  const double rounding = std::ldexp(std::abs(nodata), -23);
  values = ((values - nodata).abs() <= rounding).select(Map::unknown, values);
}

double nodata_of(const Field& values) {
  const double low = values.minCoeff<Eigen::PropagateNumbers>();
  if (!(low < -5000)) return -9999;
  const double out = -std::pow(10.0, std::ceil(std::log10(-low)) + 1);
  if (!std::isfinite(out)) throw DataError("map", "its heights leave no number for missing points");
  return out;
}

std::string head_of(const Map& map, double nodata) {
  const auto [dx, dy] = map.spacing;
  const auto entry = [](std::string_view key, auto value) { return head_line(key, " ", value); };
  std::string out = entry("ncols", std::to_string(map.values.rows())) +
                    entry("nrows", std::to_string(map.values.cols())) + entry("xllcorner", 0.0) +
                    entry("yllcorner", 0.0);
  out += dx == dy ? entry("cellsize", dx) : entry("dx", dx) + entry("dy", dy);
  return out + entry("NODATA_value", nodata);
}

}  // namespace

bool recognises_esri(std::string_view bytes) {
  const Head head = parts_of(bytes.substr(0, 4096)).head;
  return head.has("ncols") && head.has("nrows");
}

Map decode_esri(std::string_view bytes, const Reading& reading) {
  const auto [head, numbers, lines] = parts_of(bytes);
  const Shape shape{head.count("ncols"), head.count("nrows")};
  Map map{.values = field_of_lines(numbers, shape, "map", lines + 1, reading), .spacing = spacing_of(head)};
  map.values = map.values.rowwise().reverse().eval();
  if (head.has("NODATA_value")) remove_missing(map.values, head);
  return map;
}

std::string encode_esri(const Map& map, Order) {
  check_size(map, "an ESRI grid");
  const double nodata = nodata_of(map.values);
  const Field filled = map.values.isNaN().select(nodata, map.values);
  return head_of(map, nodata) + text_of(filled.transpose().colwise().reverse(), ' ');
}

}  // namespace asperity
