#include "tools/convert/map_options.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/units.hpp"
#include "formats/fill.hpp"
#include "formats/format.hpp"

namespace asperity::cli {
namespace {

// "A:B" of n points, either end may be left out.
auto range_of(const std::string& word, Index n) {
  const auto index = [](std::string_view end, Index otherwise) {
    return end.empty() ? otherwise : to_number<Index>(end).value_or(-1);
  };
  const std::size_t colon = word.find(':');
  const Index a = index(word.substr(0, colon), 0),
              b = colon == word.npos ? -1 : index(word.substr(colon + 1), n);
  if (!(a >= 0 && a < b && b <= n))
    throw UsageError("crop", "'" + word + "' is no range A:B with 0 <= A < B <= " + std::to_string(n));
  return Eigen::seqN(a, b - a);
}

// The size of what is left stays that of its points.
Map cropped(Map map, const std::string& crop) {
  const std::vector<std::string> words = split(crop, ',');
  if (words.size() != 2) throw UsageError("crop", "'" + crop + "' is not of the form A:B,C:D");
  const auto x = range_of(words[0], map.values.rows()), y = range_of(words[1], map.values.cols());
  map.values = map.values(x, y).eval();
  return map;
}

// The points 0, step, 2 step, …, of a spacing so many times as large.
Map decimated(Map map, Shape step) {
  const Index nx = (map.values.rows() + step.nx - 1) / step.nx,
              ny = (map.values.cols() + step.ny - 1) / step.ny;
  map.values = map.values(Eigen::seqN(0, nx, step.nx), Eigen::seqN(0, ny, step.ny)).eval();
  map.spacing[0] *= static_cast<double>(step.nx);
  map.spacing[1] *= static_cast<double>(step.ny);
  return map;
}

// A unit of length, in metres.
double coordinate_of(const std::string& unit) {
  double metres = 0;
  try {
    metres = unit_factor(unit, "m");
  } catch (const std::invalid_argument& error) {
    throw UsageError("xyz", error.what());
  }
  if (!(metres > 0)) throw UsageError("xyz", "'" + unit + "' is no length");
  return metres;
}

using Words = std::vector<std::string>;

// In the order of Separator, of DecimalMark and of Filling.
const Words separators{"auto", "blank", "tab", "comma", "semicolon"}, decimals{"auto", "point", "comma"},
    fillings{"laplace", "mean", "least"};

template <class Enum>
Enum chosen(const Words& words, const std::string& word) {
  return static_cast<Enum>(std::ranges::find(words, word) - words.begin());
}

}  // namespace

void MapOptions::declare(Tool& tool) {
  tool.choice(
      "--separator", separator_, separators,
      "What stands between the numbers of a text; auto: what lets every line hold as many, refused where "
      "that is not one thing",
      "Input");
  tool.choice("--decimal", decimal_, decimals,
              "What marks the decimals of a text; auto: a point, or a comma that cannot be anything else",
              "Input");
  tool.text(
      "--xyz", points_, "UNIT",
      "The lines of a text are points of a grid in any order, x z or x y z, with x and y in this unit: um",
      "Input");
  tool.flag("--heights", heights_,
            "Every column of a text holds heights, though the first of them look like coordinates", "Input");
  tool.quantities("--size", size_, "m",
                  "Lx,Ly, the sides of the map, where the file does not say or says it wrongly", "Input");
  tool.text("--unit", unit_, "UNIT",
            "Unit of the values, where the file does not say: um, nm, V (default: m)", "Input");
  tool.text(
      "--crop", crop_, "A:B,C:D",
      "Keep the points A to B-1 in x and C to D-1 in y, counted from 0; an end that is left out is the map's",
      "Map");
  tool.counts("--decimate", decimate_, 1, "Keep every A-th point in x and every B-th in y", "Map");
  tool.choice("--fill", fill_, {"none", "laplace", "mean", "least"},
              "Give missing points values: a membrane over each hole (Laplace's equation), the mean or the "
              "least height",
              "Map");
}

Reading MapOptions::reading(std::string_view bytes, std::string_view format) const {
  if (!points_.empty() && heights_) throw UsageError("xyz", "it cannot be given with --heights");
  if (decimal_ == "comma" && separator_ == "comma")
    throw UsageError("decimal", "a comma cannot separate numbers and mark their decimals at once");
  const auto refuse = [&](const char* option) {
    throw UsageError(option, "the input is " + std::string(format) + ", which tells by itself");
  };
  if (separator_ != "auto" && !is_text(bytes)) refuse("separator");
  if (decimal_ != "auto" && !is_text(bytes)) refuse("decimal");
  if (!points_.empty() && format != "text") refuse("xyz");
  if (heights_ && format != "text") refuse("heights");
  Reading out;
  out.separator = chosen<Separator>(separators, separator_);
  out.decimal = chosen<DecimalMark>(decimals, decimal_);
  out.heights = heights_;
  if (!points_.empty()) out.coordinate = coordinate_of(points_);
  return out;
}

bool MapOptions::changes() const {
  return !std::isnan(size_[0]) || !unit_.empty() || !crop_.empty() || !(decimate_ == Shape{1, 1}) ||
         fill_ != "none";
}

Map MapOptions::applied(Map map) const {
  if (!unit_.empty()) {
    if (!map.units.empty()) throw UsageError("unit", "the file says that its values are in " + map.units);
    set_units(map, unit_);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (std::isnan(size_[axis])) continue;
    if (!(size_[axis] > 0 && std::isfinite(size_[axis]))) throw UsageError("size", "it is not positive");
    map.spacing[axis] = size_[axis] / static_cast<double>(axis == 0 ? map.values.rows() : map.values.cols());
  }
  if (!crop_.empty()) map = cropped(std::move(map), crop_);
  if (!(decimate_ == Shape{1, 1})) map = decimated(std::move(map), decimate_);
  if (fill_ != "none") {
    const double dx = std::isnan(map.spacing[0]) ? 1 : map.spacing[0],
                 dy = std::isnan(map.spacing[1]) ? 1 : map.spacing[1];
    map.values = filled(std::move(map.values), {shape_of(map.values), dx, dy, false},
                        chosen<Filling>(fillings, fill_));
  }
  return map;
}

}  // namespace asperity::cli
