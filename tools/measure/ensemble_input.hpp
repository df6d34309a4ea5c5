/// The surfaces of an ensemble, read one by one: files or patterns on the command line, a list of files on
/// standard input, or a single dataset on standard input.
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

  /// Calls visit(dataset, name) for each surface, except files for which taken(path) returns true: it has
  /// read them itself.
  void for_each(
      const Tool& tool, const Visit& visit,
      const VisitPath& taken = [](const std::string&) { return false; }) const;
};

/// Checks that a mean over the surfaces is meaningful. Slopes, curvatures, peaks and correlation lengths
/// depend on the spacing: surfaces of different spacings are refused. Surfaces of different sizes estimate
/// the same quantities with different errors: one warning, or an error where sizes must be alike.
class EnsembleGrid {
 public:
  enum class Sizes { any, alike };
  explicit EnsembleGrid(Sizes sizes = Sizes::any) : sizes_(sizes) {}
  /// The grid of the next surface; throws DataError(file, …) with both grids if it does not fit the first.
  void add(const Tool& tool, const Grid& grid, const std::string& file);

 private:
  Sizes sizes_;
  std::optional<Grid> first_;
  std::string file_;
  bool warned_ = false;
};

}  // namespace asperity::cli
