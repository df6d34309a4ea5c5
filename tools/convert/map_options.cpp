#include "tools/convert/map_options.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/words.hpp"
#include "formats/fill.hpp"
#include "formats/format.hpp"
#include "transform/refinement.hpp"

namespace asperity::cli {
namespace {

// "A:B" of n points; either end may be omitted.
auto range_of(const std::string& word, Index n) {
  const auto index = [](std::string_view end, Index otherwise) {
    return end.empty() ? otherwise : to_number<Index>(end).value_or(-1);
  };
  const std::size_t colon = word.find(':');
  const Index a = index(word.substr(0, colon), 0),
              b = colon == word.npos ? -1 : index(word.substr(colon + 1), n);
  if (!(a >= 0 && a < b && b <= n))
    throw UsageError("crop", "'" + word + "' is not a range A:B with 0 <= A < B <= " + std::to_string(n));
  return Eigen::seqN(a, b - a);
}

// Keeps the spacing.
Map cropped(Map map, const std::string& crop) {
  const std::vector<std::string> words = split(crop, ',');
  if (words.size() != 2) throw UsageError("crop", "'" + crop + "' is not of the form A:B,C:D");
  const auto x = range_of(words[0], map.values.rows()), y = range_of(words[1], map.values.cols());
  map.periodic = {};  // a part of a period is not periodic, as decoding has it too
  map.values = map.values(x, y).eval();
  return map;
}

// The points 0, step, 2 step, …; the spacing grows by the same factor. A period needs whole steps.
Map decimated(Map map, Shape step) {
  if (map.values.rows() % step.nx != 0 || map.values.cols() % step.ny != 0) map.periodic = {};
  const Index nx = (map.values.rows() + step.nx - 1) / step.nx,
              ny = (map.values.cols() + step.ny - 1) / step.ny;
  map.values = map.values(Eigen::seqN(0, nx, step.nx), Eigen::seqN(0, ny, step.ny)).eval();
  map.spacing[0] *= static_cast<double>(step.nx);
  map.spacing[1] *= static_cast<double>(step.ny);
  return map;
}

// "4" or "4x2"; nothing is 1x1.
Shape factors_of(const std::string& word) {
  if (word.empty()) return {1, 1};
  return parse_counts("refine", word.find('x') == word.npos ? word + "x" + word : word, {1, 1024});
}

// Through the same points, by the map's own waves.
Map refined(const Tool& tool, Map map, const std::string& word) {
  const Shape factor = factors_of(word);
  if (map.values.hasNaN())
    throw UsageError("refine", "the map has missing points: fill them first (--fill laplace)");
  const double dx = std::isnan(map.spacing[0]) ? 1 : map.spacing[0],
               dy = std::isnan(map.spacing[1]) ? 1 : map.spacing[1];
  const Grid grid{shape_of(map.values), dx, dy, map.periodic};
  const Shape fine = refined_grid(grid, factor).shape;
  constexpr double written = 16;  // bytes a point, in a dataset and as it is encoded
  tool.require_memory(
      refinement_memory(grid, factor) + written * static_cast<double>(fine.nx) * static_cast<double>(fine.ny),
      "refine", word + ": a map of " + text(fine) + " points");
  map.values = asperity::refined(map.values, grid, factor);
  map.spacing[0] /= static_cast<double>(factor.nx);
  map.spacing[1] /= static_cast<double>(factor.ny);
  return map;
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
      "Separator of the numbers in a text; auto: the one that gives every line the same number of values; "
      "an ambiguous text is refused",
      "Input");
  tool.choice("--decimal", decimal_, decimals,
              "Decimal mark in a text; auto: a point, or a comma if it cannot be a separator", "Input");
  tool.text("--xyz", columns_, "X,Y,Z",
            "Columns of a text that are x, y and z; or x and z; by number or name, with units if the text "
            "gives none: 1/um,2/um,4/nm; none: all hold heights. Points come in any order, on a grid",
            "Input");
  tool.texts(
      "--missing", missing_, "WORD",
      "Word for a missing point in a text; or a number: -9999; nan and the like need not be given. May "
      "be repeated",
      "Input");
  tool.quantities("--size", size_, "m",
                  "Side lengths Lx,Ly; needed if the file does not give them, and replaces wrong ones",
                  "Input");
  tool.text("--unit", unit_, "UNIT", "Unit of the values, if the file gives none: um, nm, V. Default: m",
            "Input");
  tool.text(
      "--crop", crop_, "A:B,C:D",
      "Keep points A to B-1 in x and C to D-1 in y; the first point is 0, an omitted end is the map's edge",
      "Map");
  tool.counts("--decimate", decimate_, 1, "Keep every A-th point in x and every B-th in y", "Map");
  tool.choice("--fill", fill_, {"none", "laplace", "mean", "least"},
              "Fill missing points; laplace: with a membrane over each hole (Laplace's equation), mean: with "
              "the mean height, least: with the smallest height",
              "Map");
  tool.text(
      "--refine", refine_, "AxB",
      "Put A times as many points in x and B times in y, or A for both, between those of the map, by its own "
      "waves: trigonometric interpolation of a periodic map, mirrored cosines above a form of degree 2 of "
      "any other. The domain stays; of an odd A every A-th point is one of the map's",
      "Map");
}

Reading MapOptions::reading(std::string_view bytes, std::string_view format) const {
  if (decimal_ == "comma" && separator_ == "comma")
    throw UsageError("decimal", "'comma' cannot be combined with --separator comma");
  const auto refuse = [&](const char* option) {
    throw UsageError(option, "applies to text only, and the input is " + std::string(format) + ": omit it");
  };
  if (separator_ != "auto" && !is_text(bytes)) refuse("separator");
  if (decimal_ != "auto" && !is_text(bytes)) refuse("decimal");
  if (!missing_.empty() && !is_text(bytes)) refuse("missing");
  if (!columns_.empty() && format != "text") refuse("xyz");
  Reading out;
  out.separator = chosen<Separator>(separators, separator_);
  out.decimal = chosen<DecimalMark>(decimals, decimal_);
  out.columns = columns_;
  out.missing = missing_;
  out.unit_told = !unit_.empty();
  return out;
}

bool MapOptions::changes() const {
  return !std::isnan(size_[0]) || !unit_.empty() || !crop_.empty() || !(decimate_ == Shape{1, 1}) ||
         fill_ != "none" || !(factors_of(refine_) == Shape{1, 1});
}

Map MapOptions::applied(const Tool& tool, Map map) const {
  if (!unit_.empty()) {
    if (!map.units.empty())
      throw UsageError("unit", "the file gives its own unit, " + one_line(map.units, 24) + ": omit it");
    set_units(map, unit_);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (std::isnan(size_[axis])) continue;
    if (!(size_[axis] > 0 && std::isfinite(size_[axis])))
      throw UsageError("size", format_quantity(size_[axis], "m") + " is not a positive length");
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
  if (!(factors_of(refine_) == Shape{1, 1})) map = refined(tool, std::move(map), refine_);
  return map;
}

}  // namespace asperity::cli
