#include "dataset/layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/words.hpp"
#include "dataset/conventions.hpp"
#include "dataset/units.hpp"
#include "dataset/unread.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;

using List = Eigen::Map<const Eigen::ArrayXd>;

// 0 · values sums to 0 unless a value is not finite; this check is cheaper than the range.
void refuse_results(const std::string& name, const List& values, Missing missing) {
  if ((0.0 * values).sum() == 0 || (missing != Missing::refused && !values.isInf().any())) return;
  throw DataError(name, fmt::format("a result is {}: the parameters exceed double precision",
                                    values.isInf().any() ? "infinite" : "not a number"));
}

void set_actual_range(Variable& variable, const List& values) {
  if (values.size() == 0 || values.isNaN().all()) return;
  const double low = values.minCoeff<Eigen::PropagateNumbers>(),
               high = values.maxCoeff<Eigen::PropagateNumbers>();
  variable.attributes.set_values("actual_range", std::vector<double>{low + 0.0, high + 0.0});  // no -0
}

Variable make(std::string_view name, Names dimensions, std::vector<double> values, Meaning meaning,
              Missing missing = Missing::refused) {
  Variable out{std::string(name), std::move(dimensions), {}, {}};
  out.attributes.set("long_name", meaning.long_name);
  out.attributes.set("units", meaning.units);
  const List list(values.data(), static_cast<Index>(values.size()));
  refuse_results(out.name, list, missing);
  set_actual_range(out, list);
  out.values = std::move(values);
  return out;
}

Variable coordinate(std::string_view name, std::vector<double> values, std::string_view unit,
                    std::string_view words) {
  return make(name, {std::string(name)}, std::move(values), {unit, words});
}

// Whether two coordinates have the same points, to six digits.
bool same_points(const Variable& one, const Variable& other) try {
  const double factor = unit_factor(unit_of(one), unit_of(other));
  const std::vector<double> a = numbers(one.values), b = numbers(other.values);
  const double farthest = b.empty() ? 0 : std::max(std::abs(b.front()), std::abs(b.back()));
  return std::ranges::equal(a, b,
                            [&](double x, double y) { return std::abs(x * factor - y) <= 1e-6 * farthest; });
} catch (const std::invalid_argument&) {
  return false;
}

// Replaces a former coordinate; if its points differ, removes the variables on it.
void put_coordinate(Dataset& dataset, Variable axis) {
  const std::string name = axis.name;
  dataset.set_dimension(name, static_cast<Index>(count(axis.values)));
  if (const Variable* former = dataset.find(name); former && !same_points(*former, axis))
    std::erase_if(dataset.variables, [&](const Variable& v) {
      return std::ranges::find(v.dimensions, name) != v.dimensions.end();
    });
  dataset.put(std::move(axis));
}

std::vector<double> flat(const Field& f) {
  auto out = large_list<double>(size(f.size()));
  std::ranges::copy_n(f.data(), f.size(), out.begin());
  return out;
}

// A variable on two dimensions as a field, NaN for its mark.
Field matrix(const Dataset& dataset, const Variable& variable, double factor) {
  if (std::holds_alternative<std::string>(variable.values))
    throw DataError(variable.name, "contains text instead of numbers");
  const Index rows = dataset.length(variable.dimensions[0]), columns = dataset.length(variable.dimensions[1]);
  if (count(variable) != static_cast<std::size_t>(rows * columns))
    throw std::logic_error(variable.name + " has another number of values than places");
  Field out = large_field({rows, columns});
  const double mark = mark_of(variable);
  double* to = out.data();
  in_pieces(variable, [&](const Values& piece) {
    std::visit(
        [&](const auto& values) {
          for (const auto value : values) {
            const auto number = static_cast<double>(value);
            *to++ = number == mark ? std::numeric_limits<double>::quiet_NaN() : number * factor;
          }
        },
        piece);
  });
  return out;
}

// `values`: the rows from `first` on.
void refuse_not_finite(const std::string& name, const Field& values, Index first, Missing missing) {
  if ((0.0 * values).sum() == 0) return;  // all are finite
  auto refused = [&](double value) {
    return missing == Missing::refused ? !std::isfinite(value) : std::isinf(value);
  };
  const double* const end = values.data() + values.size();
  const double* const at = std::find_if(values.data(), end, refused);
  if (at == end) return;
  const Index place = at - values.data(), i = first + place / values.cols(), j = place % values.cols();
  throw DataError(name, fmt::format("the value at point ({}, {}) is {}", i, j,
                                    std::isnan(*at) ? "not a number" : "infinite"));
}

std::ptrdiff_t count_if(const Variable& variable, const std::function<bool(double)>& wanted) {
  std::ptrdiff_t out = 0;
  in_pieces(variable, [&](const Values& piece) { out += std::ranges::count_if(numbers(piece), wanted); });
  return out;
}

// Marks have become NaN. What a strip lacks is counted in the whole, and only then.
void refuse_missing(const Dataset& strip, const Dataset& whole, const Variable& all, const Field& values) {
  const auto refuse = [&](std::ptrdiff_t number, std::string_view how) {
    if (number > 0)
      throw DataError(all.name, fmt::format("{} {}: fill or crop the map (`fill`, `crop`)",
                                            counted(number, "point"), how));
  };
  const auto masked = [](double v) { return v != 0; };
  if (const Variable* mask = strip.find("mask"); mask != nullptr && count_if(*mask, masked) > 0)
    refuse(count_if(whole.at("mask"), masked), "masked as missing");
  if (!values.hasNaN()) return;
  const bool filled = all.attributes.find("_FillValue"), named = all.attributes.find("missing_value");
  const double mark = mark_of(all);
  refuse(count_if(all, [&](double v) { return v == mark; }), filled  ? "missing (_FillValue)"
                                                             : named ? "missing (missing_value)"
                                                                     : "missing (never written)");
}

// Sets masked points to NaN.
void leave_out_masked(const Dataset& dataset, const Variable& variable, Field& values) {
  const Variable* mask = dataset.find("mask");
  if (!mask) return;
  if (mask->dimensions != variable.dimensions) throw DataError("mask", "is not a field on (x, y)");
  values = (matrix(dataset, *mask, 1.0) != 0).select(std::numeric_limits<double>::quiet_NaN(), values);
}

// A field from a strip of a dataset, its rows from `first` on. Errors tell of the whole.
Field rows_from(const Dataset& strip, const Dataset& whole, Index first, std::string_view name,
                std::string_view unit, Missing missing) {
  const Variable& all = whole.at(name);
  const double factor = factor_to(unit, all);
  if (all.dimensions != Names{"x", "y"}) throw DataError(all.name, "is not a field on (x, y)");
  Field out = matrix(strip, strip.at(name), factor);
  missing == Missing::refused ? refuse_missing(strip, whole, all, out) : leave_out_masked(strip, all, out);
  refuse_not_finite(all.name, out, first, missing);
  return out;
}

}  // namespace

void set_grid(Dataset& dataset, const Grid& grid) {
  auto set_axis = [&](std::string_view name, Index n, double spacing, bool repeats, auto position) {
    std::vector<double> points;
    for (Index i = 0; i < n; ++i) points.push_back(position(i));
    Variable axis =
        coordinate(name, std::move(points), "m", std::string("position along ") + std::string(name));
    axis.attributes.set("unit", "m");
    axis.attributes.set("length", spacing * static_cast<double>(n));
    axis.attributes.set("periodic", repeats ? 1 : 0);
    axis.attributes.set("axis", name == "x" ? "X" : "Y");
    put_coordinate(dataset, std::move(axis));
  };
  set_axis("x", grid.shape.nx, grid.dx, grid.periodic.x, [&](Index i) { return grid.x(i); });
  set_axis("y", grid.shape.ny, grid.dy, grid.periodic.y, [&](Index j) { return grid.y(j); });
}

Field field_of(const Dataset& dataset, std::string_view name, Missing missing) {
  return field_of(dataset, name, si_unit_of(dataset.at(name)), missing);
}

Field field_of(const Dataset& dataset, std::string_view name, std::string_view unit, Missing missing) {
  return rows_from(dataset, dataset, 0, name, unit, missing);
}

Field field_of(const Dataset& dataset, std::string_view name, std::string_view unit, Extent rows,
               Missing missing) {
  if (rows == Extent{0, dataset.length("x")}) return field_of(dataset, name, unit, missing);
  const auto ny = dataset.length("y");
  auto on_cells = [](const Variable& v) { return v.dimensions == Names{"x", "y"}; };
  Dataset strip;
  strip.dimensions = {{"x", rows.count}, {"y", ny}};
  for (const std::string& part : {std::string(name), std::string("mask")})
    if (const Variable* all = dataset.find(part); all != nullptr && on_cells(*all))
      strip.variables.push_back({part, all->dimensions,
                                 values_of(*all, size(rows.first * ny), size(rows.count * ny)),
                                 all->attributes});
  return rows_from(strip, dataset, rows.first, name, unit, missing);
}

void set_field(Dataset& dataset, std::string_view name, const Field& values, Meaning meaning) {
  Variable variable = make(name, {"x", "y"}, flat(values), meaning);
  if (name == "heights") variable.attributes.set("unit", meaning.units);
  dataset.put(std::move(variable));
}

void defer_values(Dataset& dataset, std::string_view name, std::vector<std::string> dimensions, Range range,
                  Meaning meaning) {
  Variable variable = make(name, std::move(dimensions), {range.low, range.high}, meaning);
  variable.values = std::vector<double>();
  if (name == "heights") variable.attributes.set("unit", meaning.units);
  dataset.erase(name);
  dataset.put(std::move(variable));
}

void set_scalar(Dataset& dataset, std::string_view name, double value, Meaning meaning) {
  Variable variable = make(name, {}, {value}, meaning);
  variable.attributes.erase("actual_range");
  dataset.put(std::move(variable));
}

void set_flags(Dataset& dataset, std::string_view name, const std::vector<std::int8_t>& values,
               std::string_view long_name, std::string_view flag_meanings) {
  Variable variable{std::string(name), {"x", "y"}, values, {}};
  std::vector<std::int8_t> list(static_cast<std::size_t>(std::ranges::count(flag_meanings, ' ')) + 1);
  std::iota(list.begin(), list.end(), std::int8_t{0});
  const auto [low, high] = std::ranges::minmax_element(values);
  variable.attributes.set("long_name", long_name);
  variable.attributes.set("units", "1");
  variable.attributes.set_values("flag_values", std::move(list));
  variable.attributes.set("flag_meanings", flag_meanings);
  if (!values.empty()) variable.attributes.set_values("actual_range", std::vector<std::int8_t>{*low, *high});
  dataset.put(std::move(variable));
}

std::vector<double> depths_of(const Dataset& dataset) {
  const Variable& z = dataset.at("z");
  const double factor = factor_to("m", z);
  std::vector<double> depths = present_numbers(z);
  for (double& d : depths) {
    d *= factor;
    if (!(d >= 0))
      throw DataError(
          "z",
          fmt::format("depth {:f} m is above the surface: for heights set the attribute positive to up", d));
  }
  return depths;
}

void set_depths(Dataset& dataset, const std::vector<double>& depths) {
  Variable z = coordinate("z", depths, "m", "depth below the surface");
  z.attributes.set("unit", "m");
  z.attributes.set("axis", "Z");
  z.attributes.set("positive", "down");
  z.attributes.set("length", *std::ranges::max_element(depths));
  z.attributes.set("periodic", 0);
  put_coordinate(dataset, std::move(z));
}

void set_volume(Dataset& dataset, std::string_view name, std::vector<double> values, Meaning meaning) {
  dataset.put(make(name, {"z", "x", "y"}, std::move(values), meaning));
}

void set_axes(Dataset& dataset, Shape table, Axis row, Axis column) {
  auto set_axis = [&](const Axis& axis, Index n) {
    std::vector<double> points;
    for (Index i = 0; i < n; ++i) points.push_back(static_cast<double>(axis.first + i) * axis.step);
    put_coordinate(dataset, coordinate(axis.name, std::move(points), axis.unit, axis.meaning));
  };
  set_axis(row, table.nx);
  set_axis(column, table.ny);
}

void set_table(Dataset& dataset, std::string_view name, const Field& values, Axis row, Axis column,
               Meaning meaning, Missing missing) {
  set_axes(dataset, shape_of(values), row, column);
  dataset.put(make(name, {std::string(row.name), std::string(column.name)}, flat(values), meaning, missing));
}

Field table_of(const Dataset& dataset, std::string_view name, std::string_view unit, Missing missing) {
  const Variable& variable = dataset.at(name);
  const double factor = unit.empty() ? 1 : factor_to(unit, variable);
  if (variable.dimensions.size() != 2) throw DataError(variable.name, "does not have 2 dimensions");
  Field out = matrix(dataset, variable, factor);
  refuse_not_finite(variable.name, out, 0, missing);
  return out;
}

void add_history(Dataset& dataset, std::string_view line) {
  const std::string former = dataset.attributes.text("history");
  dataset.attributes.set("history", std::string(line) + (former.empty() ? "" : "\n") + former);
}

}  // namespace asperity
