#include "dataset/field_file.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "dataset/axis_order.hpp"

namespace asperity {

FieldFile::FieldFile(const std::string& path, std::string_view variable, const MemoryBound& memory)
    : file_(path, memory),
      dataset_(to_native_axes(file_.dataset())),
      grid_(grid_of(dataset_)),
      variable_(variable) {
  if (dataset().at(variable_).dimensions != std::vector<std::string>{"x", "y"})
    throw DataError(variable_, "is not a field on (x, y)");
}

// A dataset of the part with its coordinates, read like any other.
Field FieldFile::part(std::string_view axis, Index first, Index count) const {
  const Dataset& in_file = file_.dataset();
  const std::vector<double> points = numbers(in_file.at(axis).values);
  const bool descends = points.back() < points.front();
  if (descends) first = in_file.length(axis) - first - count;
  Dataset strip;
  strip.dimensions = in_file.dimensions;
  std::ranges::find(strip.dimensions, axis, &Dimension::name)->length = count;
  strip.variables = {in_file.at("x"), in_file.at("y")};
  strip.find(axis)->values = file_.part(axis, axis, first, count);
  for (const std::string& name : {variable_, std::string("mask")})
    if (const Variable* present = in_file.find(name)) {
      strip.variables.push_back(*present);
      strip.variables.back().values = file_.part(name, axis, first, count);
    }
  return field_of(to_native_axes(std::move(strip)), variable_, Missing::not_a_number);
}

}  // namespace asperity
