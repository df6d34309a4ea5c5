/// The parameters that asperity-stats prints, in groups; only the groups requested are computed.
#pragma once

#include <string>
#include <vector>

#include "stats/measure.hpp"
#include "tools/measure/field_options.hpp"

namespace asperity::cli {

/// --pruning, of features.
void pruning_option(Tool& tool, std::string& pruning, const std::string& group);
/// Throws ParameterError("pruning", …).
Pruning parse_pruning(const std::string& text);

struct StatsOptions {
  FieldOptions field = {};
  std::vector<std::string> groups{"height"};
  std::string quantiles = {}, direction = {}, pruning = "5%", material_heights = {}, noise = {};
  MeasureOptions measured = {};  ///< those that need no further parsing
  std::string errors = "theory";
  bool compare = false;      ///< the first surface with the others
  std::string profile = {};  ///< x or y: profile parameters instead of areal ones

  void declare(Tool& tool);
  /// Throws UsageError for unknown or repeated words, and for an option whose group is not requested.
  MeasureOptions checked(const Tool& tool) const;
  /// Those of --material-height, of a field in this unit; throws ParameterError("material-height", …).
  std::vector<MaterialHeight> heights_in(const std::string& unit) const;

 private:
  std::set<Group> asked_groups() const;
  void check_belonging(const Tool& tool, const std::set<Group>& asked) const;
};

}  // namespace asperity::cli
