/// Options for converting a map: how to read a text, its size and its unit.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "formats/map.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

class MapOptions {
 public:
  void declare(Tool& tool);
  /// How to read a text. Throws UsageError when an option for texts is given for another format.
  Reading reading(std::string_view bytes, std::string_view format) const;
  /// With what a variable on two dimensions lacks and the options give: a unit, and of its axes the names x
  /// and y in this order, coordinates, and their units; applied() then gives them their size.
  Dataset completed(Dataset dataset, const std::string& variable, Order order) const;
  /// Whether any option changes the map.
  bool changes() const;
  /// With the unit and the size.
  Map applied(Map map) const;

 private:
  static constexpr double absent = std::numeric_limits<double>::quiet_NaN();

  bool gives_size() const { return !std::isnan(size_[0]); }

  std::array<double, 2> size_{absent, absent};
  std::string unit_, separator_ = "auto", decimal_ = "auto", columns_;
  std::vector<std::string> missing_;
};

}  // namespace asperity::cli
