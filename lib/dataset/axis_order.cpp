#include "dataset/axis_order.hpp"

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>

#include <fmt/ranges.h>

#include "dataset/layout.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;

bool ends_with(const Names& dimensions, const char* slow, const char* fast) {
  const std::size_t rank = dimensions.size();
  return rank >= 2 && dimensions[rank - 2] == slow && dimensions[rank - 1] == fast;
}

template <class T>
void transpose(const T* from, T* to, Index rows, Index columns) {
  using Matrix = Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  constexpr Index block = 32;
  const Eigen::Map<const Matrix> in(from, rows, columns);
  Eigen::Map<Matrix> out(to, columns, rows);
  for (Index i = 0; i < rows; i += block)
    for (Index j = 0; j < columns; j += block) {
      const Index r = std::min(block, rows - i), c = std::min(block, columns - j);
      out.block(j, i, c, r) = in.block(i, j, r, c).transpose();
    }
}

// Matrix by matrix; a variable with its values still in the file has none.
void swap_last_two(const Dataset& dataset, Variable& variable) {
  auto& slow = variable.dimensions[variable.dimensions.size() - 2];
  auto& fast = variable.dimensions.back();
  std::swap(slow, fast);
  if (count(variable) == 0) return;  // its dimensions may be of any length
  const Index rows = dataset.length(fast), columns = dataset.length(slow), cells = rows * columns;
  load(variable);
  std::visit(
      [&](auto& values) {
        std::decay_t<decltype(values)> out(values.size(), {});
        for (Index at = 0; at + cells <= static_cast<Index>(values.size()) && cells > 0; at += cells)
          transpose(values.data() + at, out.data() + at, rows, columns);
        values = std::move(out);
      },
      variable.values);
}

// Returns whether anything was swapped.
bool swap_axes(Dataset& dataset, const char* slow, const char* fast) {
  bool any = false;
  for (Variable& variable : dataset.variables)
    if (ends_with(variable.dimensions, slow, fast)) {
      swap_last_two(dataset, variable);
      any = true;
    }
  return any;
}

// Reverses every variable on the dimension along it.
void reverse_along(Dataset& dataset, std::string_view dimension) {
  const Index points = dataset.length(dimension);
  for (Variable& variable : dataset.variables) {
    if (count(variable) == 0) continue;  // its dimensions may be of any length
    Index piece = 1;
    for (std::size_t d = variable.dimensions.size(); d-- > 0;
         piece *= dataset.length(variable.dimensions[d])) {
      if (variable.dimensions[d] != dimension) continue;
      load(variable);
      std::visit(
          [&](auto& values) {
            const Index slab = points * piece;
            for (auto at = values.begin(); slab > 0 && values.end() - at >= slab; at += slab)
              for (Index k = 0; k < points / 2; ++k)
                std::swap_ranges(at + k * piece, at + (k + 1) * piece, at + (points - 1 - k) * piece);
          },
          variable.values);
    }
  }
}

template <class T>
void negate(std::vector<T>& values) {
  for (T& value : values) value = T{0} - value;
}

void negate(Values& values) {
  if (auto* single = std::get_if<std::vector<float>>(&values)) return negate(*single);
  if (!std::holds_alternative<std::vector<double>>(values)) values = numbers(values);
  negate(std::get<std::vector<double>>(values));
}

bool descends(const Variable& axis) {
  const std::vector<double> values = numbers(axis.values);
  return values.size() > 1 && values.back() < values.front();
}

// Changes the positive direction of the coordinate z; depths and heights both ascend.
void turn(Dataset& dataset, std::string_view from, std::string_view to, std::string_view words) {
  Variable* z = dataset.find("z");
  if (!z || z->dimensions != Names{"z"} || z->attributes.text("positive") != from) return;
  negate(z->values);
  z->attributes.set("long_name", words);
  z->attributes.set("positive", to);
  if (const Values* range = z->attributes.find("actual_range")) {
    std::vector<double> turned = numbers(*range);
    std::ranges::reverse(turned);
    negate(turned);
    z->attributes.set_values("actual_range", turned);
  }
  if (descends(*z)) reverse_along(dataset, "z");
}

// A z without the attribute positive = "down" may be a height, and stays.
bool is_own_axis(const Variable& v) {
  constexpr std::string_view lateral[] = {
      "x", "y", "p", "q", "k", "l", "lag_x", "lag_y", "wave_number_x", "wave_number_y"};
  if (v.dimensions != Names{v.name} || std::holds_alternative<std::string>(v.values)) return false;
  return std::ranges::find(lateral, v.name) != std::end(lateral) ||
         (v.name == "z" && v.attributes.text("positive") == "down");
}

// Rows of images often descend; each value keeps its coordinate.
void let_ascend(Dataset& dataset) {
  Names turned;
  for (const Variable& v : dataset.variables) {
    if (!is_own_axis(v) || !descends(v)) continue;
    turned.push_back(v.name);
    reverse_along(dataset, v.name);
  }
  if (turned.empty()) return;
  dataset.notes.push_back(fmt::format("descending coordinate{} {} reversed, with all values on {}",
                                      turned.size() > 1 ? "s" : "", fmt::join(turned, ", "),
                                      turned.size() > 1 ? "them" : "it"));
  add_history(dataset, dataset.notes.back());
}

}  // namespace

Dataset to_native_axes(Dataset dataset) {
  if (swap_axes(dataset, "y", "x"))
    for (const auto& [name, axis] : {std::pair{"x", "X"}, {"y", "Y"}})
      if (Variable* coordinate = dataset.find(name)) coordinate->attributes.set("axis", axis);
  constexpr std::pair<const char*, const char*> tables[] = {
      {"l", "k"}, {"q", "p"}, {"lag_y", "lag_x"}, {"wave_number_y", "wave_number_x"}};
  for (const auto& [slow, fast] : tables) swap_axes(dataset, slow, fast);
  turn(dataset, "up", "down", "depth below the surface");
  let_ascend(dataset);
  return dataset;
}

Dataset to_viewer_axes(Dataset dataset) {
  if (swap_axes(dataset, "x", "y"))
    for (const char* name : {"x", "y"})
      if (Variable* coordinate = dataset.find(name)) coordinate->attributes.erase("axis");
  turn(dataset, "down", "up", "height above the surface");
  return dataset;
}

}  // namespace asperity
