/// The page of a dataset: one self-contained file, complete without its script, which lets the reader point
/// at fields and curves (page.js, field.js, page.css).
#pragma once

#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "tools/cli/tool.hpp"
#include "tools/plot/figure.hpp"
#include "tools/report/flow.hpp"
#include "tools/report/grid_errors.hpp"

namespace asperity::report {

/// A group of surface parameters, or why it is omitted.
struct Group {
  std::string title;
  Parameters rows;
  std::string omitted;
};

struct Content {
  const plot::Cases& dataset;   ///< one
  const plot::Cases& measured;  ///< the same with the field as it was measured, form removed and filtered
  std::string title, variable;
  std::string reference;                   ///< of heights, in words
  std::vector<Group> groups;               ///< none: the dataset has no such field
  const std::vector<std::string>& warned;  ///< of the measurements
  NoGridErrors no_grid_errors = {};
  std::vector<std::string> fields = {};  ///< that the live field shows, `variable` first
  Flow flow = {};
};

std::string page(const Content& content);

}  // namespace asperity::report
