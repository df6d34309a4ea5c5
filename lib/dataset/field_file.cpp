#include "dataset/field_file.hpp"

#include <algorithm>
#include <utility>

#include "dataset/axis_order.hpp"
#include "grid/error.hpp"

namespace asperity {
namespace {

using Names = std::vector<std::string>;

}  // namespace

FieldFile::FieldFile(const std::string& path, std::string_view variable, const MemoryBound& memory)
    : file_(path, {"x", "y"}, memory), grid_(grid_of(file_.dataset())), variable_(variable) {
  const Names& dimensions = dataset().at(variable_).dimensions;
  if (dimensions != Names{"x", "y"} && dimensions != Names{"y", "x"})
    throw DataError(variable_, "it does not lie on (x, y)");
}

Field FieldFile::rows(Index first, Index count) const { return part(Axis::x, first, count); }

Field FieldFile::columns(Index first, Index count) const { return part(Axis::y, first, count); }

// The rows, or columns, are a dataset of their own, read as any other.
Field FieldFile::part(Axis along, Index first, Index count) const {
  const std::string axis = along == Axis::x ? "x" : "y";
  Dataset strip;
  strip.dimensions = dataset().dimensions;
  std::ranges::find(strip.dimensions, axis, &Dimension::name)->length = count;
  for (const std::string& name : {variable_, std::string("mask")})
    if (const Variable* present = dataset().find(name)) {
      Variable part = *present;
      part.values = part.dimensions.front() == axis ? file_.rows(name, first, count)
                                                    : file_.columns(name, first, count);
      strip.variables.push_back(std::move(part));
    }
  return field_of(in_own_order(std::move(strip)), variable_, Missing::not_a_number);
}

}  // namespace asperity
