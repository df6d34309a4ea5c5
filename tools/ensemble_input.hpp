/// The surfaces of an ensemble: files named on the command line or matched by a pattern there, or named on standard
/// input one a line, or a single dataset on standard input. They are read one after the other.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/tool.hpp"

namespace asperity::cli {

struct EnsembleInput {
  std::vector<std::string> files;

  void declare(Tool& tool);

  using Visit = std::function<void(const Dataset&, const std::string&)>;
  using VisitPath = std::function<bool(const std::string&)>;

  /// visit(dataset, name) for one dataset after the other; but for files that `taken`, asked with their path, has
  /// dealt with itself.
  void for_each(
      const Tool& tool, const Visit& visit,
      const VisitPath& taken = [](const std::string&) { return false; }) const;
};

}  // namespace asperity::cli
