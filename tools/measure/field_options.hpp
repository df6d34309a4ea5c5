/// The options of the field to measure, and the correlation that its standard errors rest on.
///
/// A generated surface carries the autocorrelation that its heights were drawn with (acf_achieved, else
/// acf_target), which is better known than any estimate. For other fields it is estimated. Missing points are
/// left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stats/measure.hpp"
#include "stats/measure/parameter.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct FieldOptions {
  std::string variable = "heights", correlation = "auto";
  Preparation asked = {};

  void declare(Tool& tool);
  /// Without --correlation, for a tool whose errors do not need one.
  void declare_field(Tool& tool);
  /// The field and its preparation alone.
  void declare_preparation(Tool& tool, const std::string& group);

  /// Throws UsageError for cut-offs that no wave of the field passes; warns where a side is shorter than one.
  /// And for a field whose measurement may take more than --memory.
  Surface read(const Tool& tool, const Dataset& data) const;
  /// All but the heights of a surface.
  Surface without_heights(const Dataset& data) const;
  /// The same; of a FlatSurface it warns and returns it, unless it is a single point.
  Surface read_flat(const Tool& tool, const Dataset& data) const;
};

/// --result of a tool that writes a dataset or prints one of some tables. What it prints does not depend on
/// where standard output goes.
struct ResultOption {
  std::vector<std::string> tables;  ///< the words besides "dataset"
  std::string result = "dataset";

  void declare(Tool& tool, const std::string& text);
  bool dataset() const { return result == "dataset"; }
  /// Before the work: throws UsageError where the result cannot go to the output, on a terminal or as JSON.
  void check(Tool& tool) const;
};

/// --direction, "30deg".
void direction_option(Tool& tool, std::string& direction, const std::string& group);

/// A correlation of the dataset, if its lags have the spacing of the grid.
std::optional<LagField> carried_correlation(const Dataset& data, const std::string& name, const Grid& grid);

/// A unit to a power, in UDUNITS' notation: "m2", "Pa-1", and "1" for pure numbers.
std::string unit_to(const std::string& unit, int power);

/// Of a density over one wave number or two: "m3" or "m4" for heights, "Pa2 m" or "Pa2 m2" for a pressure.
std::string density_units(const std::string& unit, int lengths);

/// Warns where there are too few independent points for errors, or for precise ones.
void warn_of_few(const Tool& tool, const EffectiveSampleSize& size);
/// Warns of a length below a sample or beyond half the field; true if it is neither.
bool warn_of_length(const Tool& tool, const std::string& name, double length, const Grid& grid);
/// Warns where the ACF does not fall to the level, and of a Sal that warn_of_length would report.
void warn_of_decays(const Tool& tool, const Parameters& spatial, double level, const Grid& grid);

}  // namespace asperity::cli
