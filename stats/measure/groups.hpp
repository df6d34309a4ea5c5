/// The groups of parameters. Each is a table of symbol, unit, meaning, and a function that returns the value
/// and its error, given what the group computes. `{}` stands for the name of a subject, where several share
/// rows.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"

namespace asperity {

inline constexpr std::string_view of_field = "";  ///< instead of a unit: the unit of the heights

template <class Of>
struct Definition {
  std::string_view symbol;
  std::string_view unit;
  std::string_view meaning;
  Estimate (*estimate)(const Of&);
};

/// A member of `Of`, without an error.
template <auto member, class Of>
Estimate value_of(const Of& of) {
  return {of.*member};
}

/// "Sa, Sq": the symbols of a table that ISO 25178-2 defines, which begin with S or V.
template <class Of, std::size_t N>
std::string symbols_of(const Definition<Of> (&table)[N]) {
  std::string out;
  for (const auto& row : table)
    if (row.symbol.starts_with('S') || row.symbol.starts_with('V'))
      out += (out.empty() ? "" : ", ") + std::string(row.symbol);
  return out;
}
std::string height_symbols();
std::string material_symbols();
std::string slope_symbols();
std::string feature_symbols();

/// Texts for {} in symbols and meanings, and reasons for a missing value and a missing error.
struct Words {
  std::string symbol = {}, meaning = {}, why = {}, why_no_error = {};
};

/// A table of parameters under construction; `units` are those of the field.
class ParameterList {
 public:
  explicit ParameterList(std::string units) : units_(std::move(units)) {}

  void add(std::string_view symbol, std::string_view unit, std::string_view meaning, const Estimate& estimate,
           const Words& words = {});
  template <class Of, std::size_t N>
  void add(const Definition<Of> (&table)[N], const Of& of, const Words& words = {}) {
    for (const auto& [symbol, unit, meaning, estimate] : table)
      add(symbol, unit, meaning, estimate(of), words);
  }
  /// All parameters; without errors if too few heights are independent.
  Parameters with_known_errors(const EffectiveSampleSize& size) &&;
  Parameters all() && { return std::move(parameters_); }

 private:
  std::string units_;
  Parameters parameters_;
};

/// Why a length, or a ratio of two, has no error.
inline constexpr const char* no_level =
    "no error: the true ACF, without the field's own mean subtracted, may not fall that far within the lags";
/// The ellipticity of the contour at a level and, unless it is a circle, its direction, by these names.
void add_ellipse(ParameterList& out, const LobeEstimates& lobe, const std::string& level_text,
                 const std::array<std::string, 2>& names, bool with_errors);

Parameters height_parameters(const Sample& sample, const MeasureOptions&);
Parameters quantiles(const Sample& sample, const MeasureOptions& options);
/// Each test's statistic and p-value, with and without the correlation of the heights.
Parameters gaussianity(const Sample& sample, const MeasureOptions&);
Parameters material_parameters(const Sample& sample, const MeasureOptions& options);
Parameters hybrid_parameters(const Sample& sample, const MeasureOptions& options);
/// Of a field of one row or column; `m0` as of others.
Parameters profile_derivatives(const Sample& sample, const Estimate& m0);
/// What steps of the heights are of a mean square slope or second derivative; "" below a hundredth.
std::string steps_in_slopes(double step, double share);
std::string steps_in_curvatures(double step, double share);
Parameters spatial_parameters(const Sample& sample, const MeasureOptions& options);
/// Throws DataError for a field without hills.
Parameters feature_parameters(const Sample& sample, const MeasureOptions& options);
/// Named P…, or R… after the L-filter.
Parameters profile_averages(const Sample& sample, const MeasureOptions& options);

}  // namespace asperity
