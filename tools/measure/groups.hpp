/// What asperity-stats can print: groups of parameters, each computed only when asked for.
#pragma once

#include <string>
#include <vector>

#include "tools/cli/table.hpp"
#include "tools/measure/sample.hpp"

namespace asperity::cli {

struct StatsOptions {
  std::string groups = "height", quantiles, direction;
  std::array<double, 2> material_ratios{0.1, 0.8};
  double acf_level = 0.2;
  std::string profile;  ///< x or y: profile parameters in place of the areal ones

  void declare(Tool& tool);
  /// Throws ParameterError for an option of a group that is not asked for.
  void check(const Tool& tool) const;
  /// What needs the whole field in memory, as it stands on the command line; "" when nothing does.
  std::string needs_whole_field(const Tool& tool) const;
  /// Whether --parameters names the group, or all; throws ParameterError("parameters", …) for words that are
  /// unknown or repeated.
  bool asks_for(const std::string& group) const;
  /// Whether --parameters names this group alone, and no --quantiles stand beside.
  bool asks_for_nothing_else(const std::string& group) const;
};

using Rows = std::vector<Quantities::Row>;

Rows height_rows(Sample& sample);
Rows quantile_rows(Sample& sample, const StatsOptions& options);
/// Each test's statistic and p-value, with and without the correlation of the heights.
Rows gaussianity_rows(Sample& sample);
Rows material_rows(Sample& sample, const StatsOptions& options);
Rows spatial_rows(const Tool& tool, WholeSample& sample, const StatsOptions& options);
/// Named P…, or R… where long waves were filtered out by a cut-off, `section`; NaN: none was.
Rows profile_rows(Sample& sample, const StatsOptions& options, double section);
/// Without values, and the reason in their place, where the field is no length or too small.
Rows hybrid_rows(Sample& sample, const StatsOptions& options);

/// Why none of the rows has a value; "" when one has.
std::string missing(const Rows& rows);

}  // namespace asperity::cli
