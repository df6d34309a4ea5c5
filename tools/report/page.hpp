/// The page of a dataset: everything in one file, nothing fetched, no script.
#pragma once

#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "tools/cli/tool.hpp"
#include "tools/plot/figure.hpp"

namespace asperity::report {

/// A group of parameters of the surface, or why it has none.
struct Group {
  std::string title;
  Parameters rows;
  std::string omitted;
};

struct Content {
  const plot::Cases& dataset;  ///< one
  std::string title, variable;
  std::string reference;      ///< of heights, in words
  std::vector<Group> groups;  ///< none: the dataset has no such field
  std::string untold;         ///< why no error of theirs is told; "" where they are
};

std::string page(const Content& content);

}  // namespace asperity::report
