#include "dataset/field_file.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "dataset/axis_order.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;

}  // namespace

FieldFile::FieldFile(const std::string& path, std::string_view variable, const MemoryBound& memory)
    : file_(path, {"x", "y"}, memory),
      dataset_(to_native_axes(file_.dataset())),
      grid_(grid_of(dataset_)),
      variable_(variable) {
  if (dataset().at(variable_).dimensions != Names{"x", "y"})
    throw DataError(variable_, "it does not lie on (x, y)");
}

Field FieldFile::rows(Index first, Index count) const { return part(Axis::x, first, count); }

Field FieldFile::columns(Index first, Index count) const { return part(Axis::y, first, count); }

// The rows, or columns, are a dataset of their own with its coordinates, read as any other.
Field FieldFile::part(Axis along, Index first, Index count) const {
  const std::string axis = along == Axis::x ? "x" : "y";
  const Dataset& in_file = file_.dataset();
  const std::vector<double> points = numbers(in_file.at(axis).values);
  const bool descends = points.back() < points.front();
  if (descends) first = in_file.length(axis) - first - count;
  Dataset strip;
  strip.dimensions = in_file.dimensions;
  std::ranges::find(strip.dimensions, axis, &Dimension::name)->length = count;
  strip.variables = {in_file.at("x"), in_file.at("y")};
  strip.find(axis)->values = file_.rows(axis, first, count);
  for (const std::string& name : {variable_, std::string("mask")})
    if (const Variable* present = in_file.find(name)) {
      Variable part = *present;
      part.values = part.dimensions.front() == axis ? file_.rows(name, first, count)
                                                    : file_.columns(name, first, count);
      strip.variables.push_back(std::move(part));
    }
  return field_of(to_native_axes(std::move(strip)), variable_, Missing::not_a_number);
}

}  // namespace asperity
