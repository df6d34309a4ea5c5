/// What the statistics tools read: a field without its form, filtered, and the correlation that its errors rest on.
///
/// A generated surface carries the autocorrelation that it was drawn with (acf_achieved, else acf_target),
/// which is better known than any estimate; it holds for the heights only. Everything else is estimated from
/// the field. Missing points (dataset/layout.hpp) are left out of everything.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "acf/table.hpp"
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/variable_units.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/gaussian_filter.hpp"
#include "stats/height/moments.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "tools/cli/table.hpp"
#include "tools/cli/tool.hpp"
#include "tools/surface/marginal_dataset.hpp"

namespace asperity::cli {

struct MeasuredOptions {
  static constexpr double absent = std::numeric_limits<double>::quiet_NaN();
  std::string variable = "heights", level = "mean", correlation = "auto";
  double short_cutoff = absent, long_cutoff = absent;  ///< λs, λc [m]

  void declare(Tool& tool) {
    declare_field(tool);
    tool.choice(
        "--correlation", correlation, {"auto", "drawn", "estimate"},
        "What standard errors rest on: the correlation that the heights were drawn with, where the dataset "
        "carries it, or the estimate",
        "Field");
  }
  /// Without --correlation, for a tool whose errors rest on none.
  void declare_field(Tool& tool) {
    tool.text("--variable", variable, "NAME",
              "The field on (x, y) that is measured, its missing points (mask, _FillValue, NaN) left out",
              "Field");
    tool.text(
        "--level", level, "FORM",
        "Reference from which heights are measured: mean, plane, or the degree of a polynomial, 0 to 20",
        "Field");
    tool.quantity(
        "--lambda-s", short_cutoff, "m",
        "Cut-off of the S-filter, a Gaussian (ISO 16610-61) that removes shorter waves; below --lambda-c",
        "Field");
    tool.quantity("--lambda-c", long_cutoff, "m",
                  "Cut-off of the L-filter, which removes longer waves; no longer than the field", "Field");
  }
};

struct Measured {
  Grid grid;
  Field heights;                        ///< above the reference; missing ones NaN
  double level = 0;                     ///< the mean that was subtracted
  std::string units = "1";              ///< SI
  std::optional<LagField> target = {};  ///< the correlation asked for, normalised
  std::optional<LagField> drawn = {};   ///< the one that errors rest on, normalised; none: estimate it
  std::optional<Translation> distribution =
      {};  ///< that the heights were drawn with, where it is not Gaussian

  /// As `units` to a power, in UDUNITS' notation: "m2", "Pa-1", and "1" for pure numbers.
  std::string units_to(int power) const { return units == "1" ? units : units + std::to_string(power); }
};

/// A correlation of the dataset, if its lags have the spacing of the grid.
inline std::optional<LagField> carried_correlation(const Dataset& data, const std::string& name,
                                                   const Grid& grid) {
  if (!data.has(name)) return std::nullopt;
  auto fits = [&](std::string_view lag, double spacing) {
    const Variable* axis = data.find(lag);
    const auto lags = axis ? lags_of(*axis) : std::nullopt;
    return !lags || lags->size() < 2 || std::abs((*lags)[1] - (*lags)[0] - spacing) <= 1e-6 * spacing;
  };
  if (!fits("p", grid.dx) || !fits("q", grid.dy)) return std::nullopt;
  return LagField(known_lags(table_of(data, name, Missing::not_a_number))).normalised();
}

inline int form_degree(const std::string& level) {
  if (level == "mean" || level == "plane") return level == "plane";
  int degree = -1;
  const auto [end, error] = std::from_chars(level.data(), level.data() + level.size(), degree);
  if (error != std::errc() || end != level.data() + level.size())
    throw UsageError("level", "'" + level + "' is neither mean nor plane nor a degree");
  return degree;
}

/// λs < λc, and both within the longer side of the field, beyond which a filter separates nothing.
inline void check_cutoffs(const MeasuredOptions& options, const Grid& grid) {
  auto metres = [](double length) { return format_quantity(length, "m"); };
  if (options.short_cutoff >= options.long_cutoff)
    throw UsageError("lambda-s", metres(options.short_cutoff) + " is not below --lambda-c, " +
                                     metres(options.long_cutoff) + ": no wave passes between them");
  const double side = std::max(grid.size_x(), grid.size_y());
  for (const auto& [option, cutoff] :
       {std::pair{"lambda-s", options.short_cutoff}, {"lambda-c", options.long_cutoff}})
    if (cutoff > side * (1 + 1e-12))
      throw UsageError(option, metres(cutoff) + " is longer than the field, " + metres(side) +
                                   ": it has no such waves to separate; leave the filter out");
}

/// A side of more than one point that is shorter than the cut-off.
inline void warn_of_short_sides(const Tool& tool, const MeasuredOptions& options, const Grid& grid) {
  const double cutoff = std::isnan(options.long_cutoff) ? options.short_cutoff : options.long_cutoff;
  auto warn = [&](const char* axis, double side, Index points) {
    if (points > 1 && cutoff > side * (1 + 1e-12))
      tool.warn("the cut-off, " + format_quantity(cutoff, "m") + ", is longer than the field in " + axis +
                ", " + format_quantity(side, "m") + ": in that direction no more than the mean is taken off");
  };
  warn("x", grid.size_x(), grid.shape.nx);
  warn("y", grid.size_y(), grid.shape.ny);
}

/// The S-filter, then the L-filter; the correlation that the heights were drawn with is not theirs any more.
inline void filter(Measured& measured, const MeasuredOptions& options, int threads) {
  check_cutoffs(options, measured.grid);
  auto mean_surface = [&](const char* option, double cutoff) {
    try {
      return gaussian_mean_surface(measured.heights, measured.grid, cutoff, threads);
    } catch (const ParameterError& error) {
      throw UsageError(option, error.what());
    }
  };
  if (!std::isnan(options.short_cutoff)) measured.heights = mean_surface("lambda-s", options.short_cutoff);
  if (!std::isnan(options.long_cutoff)) measured.heights -= mean_surface("lambda-c", options.long_cutoff);
}

/// All that does not ask for the heights themselves.
inline Measured without_heights(const Dataset& data, const MeasuredOptions& options) {
  Measured out{.grid = grid_of(data), .heights = {}};
  const bool heights = options.variable == "heights";
  out.units = si_unit_of(data.at(options.variable));
  if (heights) out.target = carried_correlation(data, "acf_target", out.grid);
  const bool as_drawn = std::isnan(options.short_cutoff) && std::isnan(options.long_cutoff);
  if (heights && as_drawn && options.correlation != "estimate") {
    out.drawn = carried_correlation(data, "acf_achieved", out.grid);
    if (!out.drawn) out.drawn = out.target;
    if (const auto marginal = marginal_of(data)) out.distribution = marginal->translation;
  }
  if (options.correlation == "drawn" && !out.drawn)
    throw DataError(options.variable,
                    as_drawn ? "the dataset does not carry the correlation it was drawn with (acf_target)"
                             : "filtered heights have another correlation than they were drawn with");
  return out;
}

/// Throws DataError for heights that are what rounding left of values of some size, and no roughness.
inline void refuse_round_off(double largest, double size, const MeasuredOptions& options) {
  constexpr double round_off = 32 * std::numeric_limits<double>::epsilon();
  if (!(largest > 0)) throw DataError(options.variable, "every value is the same");
  if (largest <= round_off * size)
    throw DataError(options.variable, "zero to round-off above its form (--level " + options.level +
                                          "): no more than " + shortest(largest) +
                                          " is left of values up to " + shortest(size));
}

inline Measured measure(const Tool& tool, const Dataset& data, const MeasuredOptions& options) {
  auto largest = [](const Field& z) { return z.abs().maxCoeff<Eigen::PropagateNumbers>(); };
  Measured out = without_heights(data, options);
  out.heights = field_of(data, options.variable, Missing::not_a_number);
  out.level = mean(out.heights);
  const double size = largest(out.heights);
  out.heights = without_form(out.heights, form_degree(options.level));
  filter(out, options, tool.thread_count());
  warn_of_short_sides(tool, options, out.grid);
  refuse_round_off(largest(out.heights), size, options);
  return out;
}

inline std::string rounded(double independent) { return shortest(std::round(10 * independent) / 10); }

/// Why no error is told of a field worth so few independent heights; "" where one can be.
inline std::string untold(const EffectiveSampleSize& size) {
  if (size.tells_errors()) return "";
  return "not told: N_eff = " + rounded(size.effective(2)) + " is below " + shortest(size.least_effective());
}

/// Of fields of which errors are rough or cannot be told.
inline void warn_of_few(const Tool& tool, const EffectiveSampleSize& size) {
  const double least = size.least_effective();
  if (size.effective(2) >= 2 * least) return;
  tool.warn("the surface is worth N_eff = " + rounded(size.effective(2)) +
            " independent points: standard errors and intervals " +
            (size.tells_errors() ? "are rough, and cannot be told below " : "cannot be told below ") +
            shortest(least) + "; measure a larger field, or filter waviness out (--lambda-c)");
}

/// Warns of a length below a sample, or beyond half the field; whether it is neither.
inline bool warn_of_length(const Tool& tool, const std::string& name, double length, const Grid& grid) {
  const double sample = std::min(grid.dx, grid.dy), half = std::max(grid.size_x(), grid.size_y()) / 2;
  const double place = std::pow(10, std::floor(std::log10(length)) - 3);
  const std::string found = name + " = " + format_quantity(std::round(length / place) * place, "m");
  if (length < sample)
    tool.warn(
        found + " is below a sample, " + format_quantity(sample, "m") +
        ": neighbours are hardly correlated, and the length is the interpolation's; sample more finely");
  if (length > half)
    tool.warn(found + " is beyond half the field, " + format_quantity(half, "m") +
              ": no correlation as long can be told from it; measure a larger field");
  return length >= sample && length <= half;
}

inline EffectiveSampleSize effective_size(const Measured& measured, int threads) {
  const Pairs pairs = Pairs::of(measured.heights, measured.grid, threads);
  if (measured.drawn) return EffectiveSampleSize(*measured.drawn, pairs);
  const AcfParameters half{.max_lag = default_max_lag(measured.grid), .threads = threads};
  return EffectiveSampleSize::of_estimate(estimate_autocorrelation(measured.heights, pairs, half), pairs);
}

}  // namespace asperity::cli
