/// What is told of a map and done to it on its way from one format to another: how its text is to be
/// understood, its size and unit; cut, thinned, filled.
#pragma once

#include <array>
#include <limits>
#include <string>

#include "formats/map.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

class MapOptions {
 public:
  void declare(Tool& tool);
  /// What the options tell of a text; throws UsageError for other bytes, or a format that tells by itself.
  Reading reading(std::string_view bytes, std::string_view format) const;
  /// Whether anything is asked for.
  bool changes() const;
  /// In this order: unit and size, --crop, --decimate, --fill.
  Map applied(Map map) const;

 private:
  static constexpr double absent = std::numeric_limits<double>::quiet_NaN();

  std::array<double, 2> size_{absent, absent};
  std::string unit_, crop_, fill_ = "none", separator_ = "auto", decimal_ = "auto", points_;
  bool heights_ = false;
  Shape decimate_{1, 1};
};

}  // namespace asperity::cli
