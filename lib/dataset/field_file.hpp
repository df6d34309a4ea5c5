/// A dataset whose fields, on (x, y) or (y, x), stay in the file and are read by whole rows: for fields
/// larger than memory. Everything else, coordinates, tables and attributes, is read.
#pragma once

#include <string>
#include <string_view>

#include "dataset/dataset.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"

namespace asperity {

class FieldFile {
 public:
  /// A regular file; throws DataError as decode_netcdf does, and for a variable that field_of would refuse.
  FieldFile(const std::string& path, std::string_view variable, const MemoryBound& memory = {});

  /// In Asperity's order, without the values of fields.
  const Dataset& dataset() const { return dataset_; }
  const Grid& grid() const { return grid_; }
  /// `count` rows from `first` on in SI, missing points NaN. Throws DataError when one is infinite.
  Field rows(Index first, Index count) const { return part("x", first, count); }
  Field columns(Index first, Index count) const { return part("y", first, count); }

 private:
  Field part(std::string_view axis, Index first, Index count) const;

  NetcdfFile file_;
  Dataset dataset_;
  Grid grid_;
  std::string variable_;
};

}  // namespace asperity
