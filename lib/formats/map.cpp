#include "formats/map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "formats/refuse.hpp"
#include "formats/text_numbers.hpp"

namespace asperity {
namespace {

constexpr std::size_t longest_unit = 64;  // in bytes; what is longer is none

// With a spacing between these bounds, the coordinates and areas of any number of points are representable.
Grid grid_of(const Map& map) {
  constexpr double least = 1e-100, greatest = 1e100;
  for (const double spacing : map.spacing) {
    if (std::isnan(spacing))
      throw DataError("x", "the file does not give the size of the map: give its `size`");
    if (!(spacing >= least && spacing <= greatest))
      throw DataError("x", fmt::format("spacing {} m is outside {} m to {} m", spacing, least, greatest));
  }
  return {shape_of(map.values), map.spacing[0], map.spacing[1], map.periodic};
}

// The range omits missing points.
void set_with_missing(Dataset& dataset, std::string_view name, const Field& values, Meaning meaning) {
  set_field(dataset, name, values.isNaN().select(default_fill, values), meaning);
  Attributes& attributes = dataset.find(name)->attributes;
  attributes.set("_FillValue", default_fill);
  const double low = values.minCoeff<Eigen::PropagateNumbers>(),
               high = values.maxCoeff<Eigen::PropagateNumbers>();
  attributes.set_values("actual_range", std::vector<double>{low, high});
  std::vector<std::int8_t> missing(static_cast<std::size_t>(values.size()));
  std::transform(values.data(), values.data() + values.size(), missing.begin(),
                 [](double z) { return std::isnan(z); });
  set_flags(dataset, "mask", missing, "where there is no height", "measured missing");
}

}  // namespace

double metres_per(std::string_view unit) {
  const std::string name = one_line(unit, longest_unit);
  try {
    const double factor = unit.size() <= longest_unit ? unit_factor(name, "m") : 0;
    if (factor > 0 && std::isfinite(factor)) return factor;
  } catch (const std::invalid_argument& error) {
    refuse("{}", error.what());
  }
  refuse("'{}' is not a unit of length", name);
}

bool is_length(std::string_view unit) try {
  if (unit.empty() || unit.front() == '-' || unit.front() == '(') return false;
  metres_per(unit);
  return true;
} catch (const DataError&) {
  return false;
}

bool same_length(const std::string& a, const std::string& b) {
  return a == b || (is_length(a) && is_length(b) && metres_per(a) == metres_per(b));
}

bool is_unit(std::string_view unit) try {
  return !unit.empty() && is_alpha(unit.front()) && unit_factor(std::string(unit), std::string(unit)) > 0;
} catch (const std::invalid_argument&) {
  return false;
}

void set_units(Map& map, std::string_view unit) {
  map.units = map.file_units = one_line(unit, longest_unit);
  double factor = 1;
  try {
    factor = metres_per(unit);
  } catch (const DataError&) {
    return;
  }
  map.units = "m";
  if (factor != 1) map.values *= factor;
  require_finite(map);
}

void leave_out_infinite(Map& map) {
  const Index count = map.values.isInf().count();
  if (count == 0) return;
  map.values = map.values.isInf().select(Map::unknown, map.values);
  if (!map.understood.empty()) map.understood += "; ";
  map.understood += counted(count, "infinite value") + " read as missing";
}

void require_finite(const Map& map) {
  if (map.values.isInf().any()) refuse("a value is infinite in metres");
}

void require_heights(const Map& map) {
  if (!map.units.empty() && map.units != "m") return;
  const double most = map.values.abs().maxCoeff<Eigen::PropagateNumbers>();
  if (!(most >= no_height) || std::isinf(most)) return;
  const std::string& unit = map.file_units;
  refuse(
      "{}{} is too much for a height: if it marks missing points, write nan, or give the mark of a text "
      "(`missing`)",
      shortest(unit.empty() ? most : most / metres_per(unit)), unit.empty() ? "" : " " + one_line(unit, 24));
}

void check_size(const Map& map, const std::string& format) {
  for (const double spacing : map.spacing)
    if (!(spacing > 0 && std::isfinite(spacing)))
      refuse("the map has no size, which {} needs: give its `size`", format);
}

void check_heights(const Map& map, const std::string& format) {
  check_size(map, format);
  if (!map.units.empty() && map.units != "m")
    refuse("{} holds only lengths, not values in '{}': choose another format", format,
           one_line(map.units, 24));
}

std::vector<std::string> notes_of(const Map& map) {
  std::vector<std::string> out;
  if (!map.history.empty())
    out.push_back("read through another program: " + map.history.substr(map.history.find(": ") + 2));
  if (!map.understood.empty()) out.push_back(map.understood);
  return out;
}

Dataset dataset_of(const Map& map) {
  Dataset out;
  set_grid(out, grid_of(map));
  const bool heights = map.units.empty() || map.units == "m";
  const std::string name = heights ? "heights" : "values", units = heights ? "m" : map.units,
                    words = map.title.empty() ? name : one_line(map.title);
  if (!map.history.empty()) out.attributes.set("history", map.history);
  const bool finite =
      (0.0 * map.values).sum() == 0;  // a product is NaN where the value is none: one fast pass
  if (!finite && map.values.isInf().any()) throw DataError(name, "a value is infinite");
  require_heights(map);
  if (map.values.isNaN().all()) throw DataError(name, "all points are missing");
  if (!finite)
    set_with_missing(out, name, map.values, {units, words});
  else
    set_field(out, name, map.values, {units, words});
  out.notes = notes_of(map);
  if (map.units.empty()) {
    const std::string assumed = "no unit given: metres assumed";
    if (out.notes.empty())
      out.notes = {assumed};
    else
      out.notes.back() += ", " + assumed;
  }
  return out;
}

Map map_of(const Dataset& dataset, std::string_view variable) {
  const Grid grid = asperity::grid_of(dataset);
  const Variable& field = dataset.at(variable);
  return {.values = field_of(dataset, variable, Missing::not_a_number),
          .spacing = {grid.dx, grid.dy},
          .units = unit_of(field).empty() ? "" : si_unit_of(field),
          .file_units = unit_of(field),
          .title = field.attributes.text("long_name"),
          .periodic = grid.periodic};
}

}  // namespace asperity
