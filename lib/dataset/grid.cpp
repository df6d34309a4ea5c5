#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"

namespace asperity {
namespace {

struct AxisExtent {
  double spacing;
  bool periodic, cut;  ///< cut: its length belongs to more or fewer points
};

bool single_precision(const Values& values) { return std::holds_alternative<std::vector<float>>(values); }

// The length given by evenly spaced points, NaN for a single point.
double length_of_points(const std::vector<double>& points) {
  const auto n = static_cast<double>(points.size());
  return n > 1 ? std::abs(points.back() - points.front()) / (n - 1) * n : NAN;
}

// Whether a length agrees with the points, to the precision of their types and to six digits.
bool agrees(double length, const Variable& axis, const std::vector<double>& points) {
  const double of_points = length_of_points(points),
               farthest = std::max(std::abs(points.front()), std::abs(points.back())),
               digits = single_precision(axis.values) ? std::numeric_limits<float>::epsilon()
                                                      : std::numeric_limits<double>::epsilon();
  return std::isnan(of_points) ||
         std::abs(length - of_points) <= 1e-6 * std::abs(length) + 2 * digits * farthest;
}

// The more precise length if both agree; otherwise that of the points.
double settled_length(const Variable& axis, const std::vector<double>& points) {
  const Values* stated = axis.attributes.find("length");
  const double length = axis.attributes.number("length", NAN), of_points = length_of_points(points);
  if (!std::isfinite(length)) return of_points;
  if (!(length > 0)) throw DataError(axis.name, "attribute length " + shortest(length) + " is not positive");
  if (std::isnan(of_points)) return length;
  const bool coarser = single_precision(*stated) && !single_precision(axis.values);
  return coarser || !agrees(length, axis, points) ? of_points : length;
}

// For a single point the length is the size, unless actual_range shows that there were more points.
void refuse_part_of_axis(const Variable& axis, const std::vector<double>& points) {
  const Values* stated = axis.attributes.find("actual_range");
  if (points.size() != 1 || stated == nullptr || count(*stated) != 2) return;
  const std::vector<double> range = numbers(*stated);
  if (std::abs(range[1] - range[0]) <= 1e-6 * std::abs(axis.attributes.number("length", 0))) return;
  throw DataError(axis.name,
                  "only one point is left of those in actual_range, and length does not fit it: correct both "
                  "attributes, or crop the whole dataset");
}

// An axis must be evenly spaced, wherever its length comes from.
AxisExtent extent_of(const Variable& axis) {
  if (axis.dimensions != std::vector{axis.name})
    throw DataError(axis.name, "is no coordinate: it must be on the dimension " + axis.name + " alone");
  const auto n = static_cast<double>(count(axis.values));
  if (n < 1) throw DataError(axis.name, "the axis has no points");
  for (const char* name : {"length", "periodic"})
    if (!axis.attributes.text(name).empty())
      throw DataError(axis.name, std::string("attribute ") + name + " is text instead of a number");
  const double factor = factor_to("m", axis);
  const std::vector<double> values = present_numbers(axis);
  if (!std::ranges::all_of(values, [](double x) { return std::isfinite(x); }))
    throw DataError(axis.name, "a coordinate is missing or infinite");
  refuse_part_of_axis(axis, values);
  const double length = settled_length(axis, values);
  const double step = values.size() > 1 ? (values.back() - values.front()) / (n - 1) : length;
  if (!std::isfinite(step) || step == 0)
    throw DataError(axis.name, "the axis has no size: add the attribute length");
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(std::abs(values[i] - values[i - 1] - step) <= 1e-3 * std::abs(step)))
      throw DataError(axis.name, "coordinates are not evenly spaced");
  const bool cut = !agrees(axis.attributes.number("length", length), axis, values);
  return {length / n * factor, axis.attributes.number("periodic", 0) != 0, cut};
}

}  // namespace

Grid grid_of(const Dataset& dataset) {
  const AxisExtent x = extent_of(dataset.at("x")), y = extent_of(dataset.at("y"));
  const Periodic periodic{x.periodic && !x.cut, y.periodic && !y.cut};  // a part of a period is not periodic
  return {{dataset.length("x"), dataset.length("y")}, x.spacing, y.spacing, periodic};
}

std::vector<std::string> settle_lengths(Dataset& dataset) {
  std::vector<std::string> out;
  for (const char* name : {"x", "y"}) {
    Variable* axis = dataset.find(name);
    const double length = axis ? axis->attributes.number("length", NAN) : NAN;
    if (!std::isfinite(length) || !(length > 0)) continue;
    const std::vector<double> points = numbers(axis->values);
    const double settled = points.empty() ? 0 : settled_length(*axis, points);
    if (!(settled > 0) || agrees(length, *axis, points)) continue;
    out.push_back(std::string(name) + ": attribute length " + in_digits(length, 6) +
                  " replaced by that of its " + std::to_string(points.size()) + " points, " +
                  in_digits(settled, 6));
    axis->attributes.set("length", settled);
    if (axis->attributes.number("periodic", 0) == 0) continue;
    axis->attributes.set("periodic", 0);
    out.back() += "; a part of a period is not periodic";
  }
  return out;
}

}  // namespace asperity
