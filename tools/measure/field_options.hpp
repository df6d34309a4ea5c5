/// The field that a tool measures, and what its errors rest on, as the command line asks for it.
///
/// A generated surface carries the autocorrelation that its heights were drawn with (acf_achieved, else
/// acf_target), better known than any estimate; everything else is estimated. Missing points are left out.
#pragma once

#include <optional>
#include <string>

#include "stats/measure/parameter.hpp"
#include "stats/measure/surface.hpp"
#include "tools/cli/tool.hpp"

namespace asperity::cli {

struct FieldOptions {
  std::string variable = "heights", level = "mean", correlation = "auto";
  double short_cutoff = Preparation::none, long_cutoff = Preparation::none;  ///< λs, λc [m]

  void declare(Tool& tool);
  /// Without --correlation, for a tool whose errors rest on none.
  void declare_field(Tool& tool);

  /// Throws UsageError("remove-form", …) unless it is a word or a number.
  Preparation preparation() const;
  /// All but the heights of a surface.
  Surface without_heights(const Dataset& data) const;
  /// Throws UsageError for cut-offs that separate nothing; warns of sides that are shorter than one.
  Surface read(const Tool& tool, const Dataset& data) const;
};

/// A correlation of the dataset, if its lags have the spacing of the grid.
std::optional<LagField> carried_correlation(const Dataset& data, const std::string& name, const Grid& grid);

/// A unit to a power, in UDUNITS' notation: "m2", "Pa-1", and "1" for pure numbers.
std::string unit_to(const std::string& unit, int power);

/// Whether a dataset goes out, and not the `tables` that stand for it as JSON and on a terminal. Throws
/// UsageError for JSON of the dataset.
bool writes_dataset(Tool& tool, bool prints, bool dataset, const std::string& tables);

/// Of fields of which errors are rough or cannot be told.
void warn_of_few(const Tool& tool, const EffectiveSampleSize& size);
/// Warns of a length below a sample, or beyond half the field; whether it is neither.
bool warn_of_length(const Tool& tool, const std::string& name, double length, const Grid& grid);
/// Of spatial parameters: of what the lags do not reach, and of such lengths.
void warn_of_decays(const Tool& tool, const Parameters& spatial, double level, const Grid& grid);

}  // namespace asperity::cli
