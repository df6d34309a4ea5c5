/// The pictures of a report: those that the dataset has something for, drawn as asperity-plot draws them.
#pragma once

#include <string>

#include "tools/plot/request.hpp"

namespace asperity::report {

/// HTML with the pictures of one dataset in it, fields as PNG, curves as SVG, and why others are not drawn. `variable` is what
/// takes the place of heights.
std::string pictures(const plot::Cases& dataset, const std::string& variable);

}  // namespace asperity::report
