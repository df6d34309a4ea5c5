/// The rms height of a surface: prescribed, or such that its neighbouring heights have an rms slope.
///
/// The slope is that of asperity-stats, Sdq (stats/hybrid/slopes.hpp, (1)), or √m2 of a profile: of the
/// differences of neighbouring heights on this grid. In the ensemble its square is
///     E[Sdq²] = 2 (R(0,0) - R(1,0))/Δx² + 2 (R(0,0) - R(0,1))/Δy²,                                      (1)
/// R being acf_achieved, that of the heights, exactly; zero beyond a single lag. An axis of one point has no
/// slope. R of a model without a slope, such as the exponential, makes it one of the grid.
///
/// Accuracy  round-off: ε over 1 - R(1)/R(0).
#pragma once

#include <cmath>
#include <string>

#include "tools/cli/tool.hpp"
#include "tools/surface/kernel_dataset.hpp"

namespace asperity::cli {

struct HeightOptions {
  double rms = NAN;    ///< [m]
  double slope = NAN;  ///< in place of it

  void declare(Tool& tool, const std::string& rq, const std::string& group);
  /// Throws UsageError where both are given, ParameterError for a slope out of bounds.
  void check(const Tool& tool) const;
  bool has_slope() const { return !std::isnan(slope); }
  /// Scales to the slope, if it is given, for surfaces of this shape, 0x0 where none is known. Says the
  /// height and leaves the slope on record. Throws UsageError without a spacing, ParameterError where heights
  /// have no slope.
  void apply(const Tool& tool, KernelTables& tables, Shape surface, Attributes& attributes) const;
};

}  // namespace asperity::cli
