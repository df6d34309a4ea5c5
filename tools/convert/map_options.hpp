/// Options for converting a map: how to read a text, its size and its unit.
#pragma once

#include <array>
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
  /// Whether any option changes the map.
  bool changes() const;
  /// With the unit and the size.
  Map applied(Map map) const;

 private:
  static constexpr double absent = std::numeric_limits<double>::quiet_NaN();

  std::array<double, 2> size_{absent, absent};
  std::string unit_, separator_ = "auto", decimal_ = "auto", columns_;
  std::vector<std::string> missing_;
};

}  // namespace asperity::cli
