/// A dataset from a file of any known format: NetCDF, a map of another program (formats/format.hpp), or what
/// Gwyddion knows (cli/gwyddion.hpp).
///
/// The first bytes decide, then the extension. Any other text is read as text and never given to Gwyddion
/// unasked; any other bytes are.
#pragma once

#include <string>
#include <string_view>

#include "dataset/dataset.hpp"
#include "formats/map.hpp"

namespace asperity::cli {

struct InputFormat {
  std::string format = "auto";  ///< by the first bytes, then the name; or "netcdf", or that of a map
  std::string order = "xy";     ///< of a bare matrix
  std::string channel = "";     ///< of a file of several maps
  Reading reading = {};         ///< further options of the reader; `order` and `channel` are those above

  Order order_of_matrix() const { return order == "yx" ? Order::yx : Order::xy; }
  /// "auto", "netcdf" and the names of all formats of maps.
  static std::vector<std::string> names();

  /// Whether bytes are taken for NetCDF.
  bool netcdf(std::string_view bytes) const;
  /// The name of the format that bytes are read in. Throws ParameterError where that has no channels, and one
  /// is given.
  std::string_view found(std::string_view bytes, const std::string& name) const;
  /// The same with the reason, in words.
  std::string reason(std::string_view bytes, const std::string& name) const;
  /// The map in bytes that are not NetCDF; the bytes count towards the memory bound.
  Map map(std::string_view bytes, const std::string& name, const MemoryBound& memory) const;
  Dataset dataset(std::string_view bytes, const std::string& name, const MemoryBound& memory) const;
};

}  // namespace asperity::cli
