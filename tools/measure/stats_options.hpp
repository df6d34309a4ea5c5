/// Which parameters asperity-stats prints: groups, each computed only when asked for.
#pragma once

#include <string>

#include "stats/measure.hpp"
#include "tools/measure/field_options.hpp"

namespace asperity::cli {

struct StatsOptions {
  FieldOptions field = {};
  std::string groups = "height", quantiles = {}, direction = {};
  MeasureOptions measured = {};  ///< as far as the command line gives it without further words
  std::string profile = {};      ///< x or y: profile parameters in place of the areal ones

  void declare(Tool& tool);
  /// Throws UsageError for unknown or repeated words, and for an option of a group that is not asked for.
  MeasureOptions checked(const Tool& tool) const;

 private:
  std::set<Group> asked_groups() const;
  void check_belonging(const Tool& tool, const std::set<Group>& asked) const;
};

}  // namespace asperity::cli
