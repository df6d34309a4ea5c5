/// ESRI ASCII grid, as written by GDAL and geographic programs.
///
///     ncols 5                    points along a line, x
///     nrows 3                    lines, y; the first line is the north, the largest y
///     xllcorner 0                position of the grid (or xllcenter): ignored
///     yllcorner 0
///     cellsize 1e-06             spacing; or dx and dy if the two differ, as in GDAL
///     NODATA_value -9999         a missing point; may be nan; -9999 unless given
/// and nrows·ncols numbers with any line breaks. Keys in any case and order. The file has no units: lengths
/// are metres, and so are heights unless the user gives another unit.
///
/// A value is missing when it equals NODATA to single precision, which many programs use, or to five digits
/// if it is too large for a height: some print -3.40282e+38 there, and all digits below. Files are written
/// with NODATA -9999, or with a lower power of ten if heights come near it.
///
/// GDAL, AAIGrid driver, https://gdal.org/drivers/raster/aaigrid.html
#include <cctype>
#include <cmath>

#include "formats/format.hpp"
#include "formats/head.hpp"
#include "formats/refuse.hpp"
#include "formats/text_head.hpp"
#include "formats/text_numbers.hpp"
#include "formats/text_table.hpp"

namespace asperity {
namespace {

constexpr std::string_view key_ends = " \t";
constexpr double usual_nodata = -9999;

bool begins_with_letter(std::string_view line) {
  return !line.empty() && std::isalpha(static_cast<unsigned char>(line.front())) != 0 &&
         !number_of(line.substr(0, line.find_first_of(key_ends)));
}

// Removes the header from the bytes.
Head take_grid_head(std::string_view& bytes) {
  const std::string_view all = bytes;
  for (std::string_view next = bytes; begins_with_letter(trimmed(take_line(next)));) bytes = next;
  return {all.substr(0, all.size() - bytes.size()), key_ends};
}

std::array<double, 2> cell_sizes(const Head& head) {
  const bool apart = head.has("dx") || head.has("dy"), cell = !apart || head.has("cellsize");
  const double side = cell ? head.positive("cellsize") : 0;
  const std::array out{apart ? head.positive("dx") : side, apart ? head.positive("dy") : side};
  if (cell && (out[0] != side || out[1] != side))
    refuse("cellsize and dx, dy in the header differ: remove one");
  return out;
}

void remove_missing(Field& values, const Head& head) {
  if (lower(head.text("NODATA_value")) == "nan") return;
  const double nodata = head.has("NODATA_value") ? head.number("NODATA_value") : usual_nodata;
  const double rounding = std::abs(nodata) * (std::abs(nodata) < no_height ? 0x1p-23 : 1e-5);
  values = ((values - nodata).abs() <= rounding).select(Map::unknown, values);
}

double nodata_of(const Field& values) {
  const double low = values.minCoeff<Eigen::PropagateNumbers>();
  if (!(low < -5000)) return usual_nodata;
  const double out = -std::pow(10.0, std::ceil(std::log10(-low)) + 1);
  if (!std::isfinite(out)) refuse("the heights are so low that no number below them can mark missing points");
  return out;
}

bool is_esri(std::string_view bytes) {
  bytes = bytes.substr(0, 4096);
  const Head head = take_grid_head(bytes);
  return head.has("ncols") && head.has("nrows");
}

Map decode_esri(std::string_view bytes, const Reading& reading) {
  const std::string_view all = bytes;
  const Head head = take_grid_head(bytes);
  const Shape shape{head.count("ncols"), head.count("nrows")};
  Map map{.values = field_of_lines(bytes, shape, head.lines() + 1, reading), .spacing = cell_sizes(head)};
  map.values = map.values.rowwise().reverse().eval();
  remove_missing(map.values, head);
  const std::string unit =
      unit_of_values(numbered_lines(all.substr(0, all.size() - bytes.size())), "", reading);
  if (!unit.empty()) set_units(map, unit);
  return map;
}

std::string encode_esri(const Map& map, Order) {
  check_heights(map, "an ESRI grid");
  const auto [dx, dy] = map.spacing;
  const double nodata = nodata_of(map.values);
  const std::string cell = dx == dy ? fmt::format("cellsize {}", shortest(dx))
                                    : fmt::format("dx {}\ndy {}", shortest(dx), shortest(dy));
  const Field filled = map.values.isNaN().select(nodata, map.values);
  return fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner 0\n{}\nNODATA_value {}\n", map.values.rows(),
                     map.values.cols(), cell, shortest(nodata)) +
         text_of(filled.transpose().colwise().reverse(), ' ');
}

}  // namespace

const Format format::esri{"esri", "asc", "ESRI ASCII grid", is_esri, decode_esri, encode_esri};

}  // namespace asperity
