/// The surfaces of an ensemble, read one after the other: files named on the command line or matched by a
/// pattern there, or named on standard input one a line, or a single dataset on standard input.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct EnsembleInput {
  std::vector<std::string> files;

  void declare(Tool& tool);

  using Visit = std::function<void(const Dataset&, const std::string&)>;
  using VisitPath = std::function<bool(const std::string&)>;

  /// visit(dataset, name) of each but the files that `taken`, asked with their path, has dealt with itself.
  void for_each(
      const Tool& tool, const Visit& visit,
      const VisitPath& taken = [](const std::string&) { return false; }) const;
};

/// Whether a mean over the surfaces means anything. Slopes, curvatures, peaks and correlation lengths follow
/// the spacing, so that surfaces of different ones are refused; of different sizes each is an estimate of the
/// same, but their errors, and all that grows with the size, differ, which is said once, or refused where
/// they must be alike.
class EnsembleGrid {
 public:
  enum class Sizes { any, alike };
  explicit EnsembleGrid(Sizes sizes = Sizes::any) : sizes_(sizes) {}
  /// Of the next surface; throws DataError(file, …) with both grids where it does not belong to the first.
  void add(const Tool& tool, const Grid& grid, const std::string& file);

 private:
  Sizes sizes_;
  std::optional<Grid> first_;
  std::string file_;
  bool warned_ = false;
};

}  // namespace asperity::cli
