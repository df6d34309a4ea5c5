/// What is done to a map on its way from one format to another: its size and unit told, cut, thinned, filled.
#pragma once

#include <array>
#include <limits>
#include <string>

#include "cli/tool.hpp"
#include "formats/map.hpp"

namespace asperity::cli {

class MapOptions {
 public:
  void declare(Tool& tool);
  /// Whether anything is asked for.
  bool changes() const;
  /// In this order: unit and size, --crop, --decimate, --fill.
  Map applied(Map map) const;

 private:
  static constexpr double absent = std::numeric_limits<double>::quiet_NaN();

  std::array<double, 2> size_{absent, absent};
  std::string unit_, crop_, fill_ = "none";
  Shape decimate_{1, 1};
};

}  // namespace asperity::cli
