/// What the statistics tools read: a field without its form, and the correlation that its errors rest on.
///
/// A generated surface carries the autocorrelation that it was drawn with (acf_achieved, else acf_target),
/// which is better known than any estimate; it holds for the heights only. Everything else is estimated from
/// the field.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "cli/tool.hpp"
#include "dataset/layout.hpp"
#include "grid/error.hpp"
#include "stats/acf.hpp"
#include "stats/effective_size.hpp"
#include "stats/form.hpp"
#include "stats/moments.hpp"

namespace asperity::cli {

struct MeasuredOptions {
  std::string variable = "heights", form = "mean", correlation = "auto";

  void declare(Tool& tool) {
    tool.text("--variable", variable, "NAME", "The field on (x, y) that is measured", "Field");
    tool.choice("--form", form, {"mean", "plane"}, "Reference from which heights are measured", "Field");
    tool.choice(
        "--correlation", correlation, {"auto", "drawn", "estimate"},
        "What standard errors rest on: the correlation that the heights were drawn with, where the dataset "
        "carries it, or the estimate",
        "Field");
  }
};

struct Measured {
  Grid grid;
  Field heights;                        ///< above the reference
  double level = 0;                     ///< the mean that was subtracted
  std::string units = "1";              ///< SI
  std::optional<LagField> target = {};  ///< the correlation asked for, normalised
  std::optional<LagField> drawn = {};   ///< the one that errors rest on, normalised; none: estimate it

  /// As `units` to a power, in UDUNITS' notation: "m2", "Pa-1", and "1" for pure numbers.
  std::string units_to(int power) const { return units == "1" ? units : units + std::to_string(power); }
};

/// A correlation of the dataset, if its lags have the spacing of the grid.
inline std::optional<LagField> carried_correlation(const Dataset& data, const std::string& name,
                                                   const Grid& grid) {
  if (!data.has(name)) return std::nullopt;
  auto fits = [&](std::string_view lag, double spacing) {
    const Variable* axis = data.find(lag);
    if (axis == nullptr || axis->attributes.text("units") != "m") return true;
    const std::vector<double> lags = numbers(axis->values);
    return lags.size() < 2 || std::abs(lags[1] - lags[0] - spacing) <= 1e-6 * spacing;
  };
  if (!fits("p", grid.dx) || !fits("q", grid.dy)) return std::nullopt;
  return LagField(table_of(data, name)).normalised();
}

inline Measured measure(const Dataset& data, const MeasuredOptions& options) {
  Measured out{.grid = grid_of(data), .heights = field_of(data, options.variable)};
  const std::string units = data.at(options.variable).attributes.text("units");
  const bool heights = options.variable == "heights";
  out.units = heights ? "m" : units.empty() ? "1" : units;
  out.level = mean(out.heights);
  out.heights = without_form(out.heights, options.form == "plane" ? Form::plane : Form::mean);
  if (!(out.heights.abs().maxCoeff() > 0)) throw DataError(options.variable, "every value is the same");
  if (heights) out.target = carried_correlation(data, "acf_target", out.grid);
  if (heights && options.correlation != "estimate") {
    out.drawn = carried_correlation(data, "acf_achieved", out.grid);
    if (!out.drawn) out.drawn = out.target;
  }
  if (options.correlation == "drawn" && !out.drawn)
    throw DataError(options.variable,
                    "the dataset does not carry the correlation it was drawn with (acf_target)");
  return out;
}

inline EffectiveSize effective_size(const Measured& measured, int threads) {
  if (measured.drawn) return EffectiveSize(*measured.drawn, measured.grid);
  const AcfParameters half{.max_lag = default_max_lag(measured.grid), .threads = threads};
  return EffectiveSize::of_estimate(estimate_autocorrelation(measured.heights, measured.grid, half),
                                    measured.grid);
}

}  // namespace asperity::cli
