/// The pictures of a report: those that the dataset has something for, drawn as asperity-plot draws them.
#pragma once

#include <string>
#include <vector>

#include "tools/plot/request.hpp"

namespace asperity::report {

struct Picture {
  std::string title, type, bytes;  ///< type: "image/png" or "image/svg+xml"
  std::string omitted;             ///< in place of the bytes: why there are none
};

/// Of one dataset; `variable` is what takes the place of heights. Fields are PNG, curves SVG.
std::vector<Picture> pictures_of(const plot::Cases& dataset, const std::string& variable);

}  // namespace asperity::report
