#include "tools/convert/map_options.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/axis_order.hpp"
#include "dataset/units.hpp"
#include "formats/format.hpp"

namespace asperity::cli {
namespace {

using Words = std::vector<std::string>;

// In the order of Separator and of DecimalMark.
const Words separators{"auto", "blank", "tab", "comma", "semicolon"}, decimals{"auto", "point", "comma"};

template <class Enum>
Enum chosen(const Words& words, const std::string& word) {
  return static_cast<Enum>(std::ranges::find(words, word) - words.begin());
}

bool is_bare(const Words& dimensions) {
  return dimensions[0] != dimensions[1] &&
         std::ranges::none_of(dimensions, [](const std::string& d) { return d == "x" || d == "y"; });
}

// A matrix of another program has dimensions of any names, which its other variables share.
Dataset with_axes(Dataset dataset, const Words& dimensions, Order order) {
  const Words axes = order == Order::xy ? Words{"x", "y"} : Words{"y", "x"};
  const auto rename = [&](std::string& name) {
    const auto at = std::ranges::find(dimensions, name);
    if (at != dimensions.end()) name = axes[static_cast<std::size_t>(at - dimensions.begin())];
  };
  for (Dimension& d : dataset.dimensions) rename(d.name);
  for (Variable& v : dataset.variables) std::ranges::for_each(v.dimensions, rename);
  return to_native_axes(std::move(dataset));
}

Variable sample_numbers(const char* axis, Index points) {
  std::vector<double> numbers(static_cast<std::size_t>(points));
  std::iota(numbers.begin(), numbers.end(), 0.0);
  return {axis, {axis}, std::move(numbers), {}};
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
  tool.text("--unit", unit_, "UNIT",
            "Unit of the values, if the file gives none, or an unclear one: um, V, '2.5e-9 m'. Default: m",
            "Input");
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
  out.size_told = gives_size();
  return out;
}

Dataset MapOptions::completed(Dataset dataset, const std::string& variable, Order order) const {
  Variable* const field = dataset.find(variable);
  if (field == nullptr || field->dimensions.size() != 2) return dataset;
  if (!unit_.empty() && unit_of(*field).empty()) field->attributes.set("units", unit_);
  if (!gives_size()) return dataset;
  if (const Words own = field->dimensions; is_bare(own)) dataset = with_axes(std::move(dataset), own, order);
  for (const char* name : {"x", "y"}) {
    const Index points = dataset.length(name);
    if (points > 0 && !dataset.has(name)) dataset.put(sample_numbers(name, points));
    Variable* const axis = dataset.find(name);
    if (axis != nullptr && unit_of(*axis).empty()) axis->attributes.set("units", "m");
    if (axis != nullptr && points == 1 && !axis->attributes.find("length")) axis->attributes.set("length", 1);
  }
  return dataset;
}

bool MapOptions::changes() const { return gives_size() || !unit_.empty(); }

Map MapOptions::applied(Map map) const {
  if (!unit_.empty() && map.file_units != unit_) {
    if (!map.units.empty())
      throw UsageError("unit", "the file gives its own unit, " +
                                   one_line(map.file_units.empty() ? map.units : map.file_units, 24) +
                                   ": omit it");
    set_units(map, unit_);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!gives_size()) continue;
    if (!(size_[axis] > 0 && std::isfinite(size_[axis])))
      throw UsageError("size", format_quantity(size_[axis], "m") + " is not a positive length");
    map.spacing[axis] = size_[axis] / static_cast<double>(axis == 0 ? map.values.rows() : map.values.cols());
  }
  require_heights(map);
  return map;
}

}  // namespace asperity::cli
