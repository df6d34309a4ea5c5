/// A dataset with its fields, on (x, y) or (y, x), left in the file and read by whole rows: for fields larger
/// than memory. Coordinates, tables and attributes are read at once.
#pragma once

#include <string>
#include <string_view>

#include "dataset/dataset.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"

namespace asperity {

class FieldFile {
 public:
  /// Opens a regular file. Throws DataError like decode_netcdf, and for a variable that field_of would
  /// refuse.
  FieldFile(const std::string& path, std::string_view variable, const MemoryBound& memory = {});

  /// In Asperity's order, without the values of fields.
  const Dataset& dataset() const { return dataset_; }
  const Grid& grid() const { return grid_; }
  /// `count` rows from `first` in SI, NaN for missing points. Throws DataError when a value is infinite.
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
