#include "tools/measure/field_options.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "acf/table.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/output_name.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/measure/preparation_words.hpp"
#include "tools/surface/marginal.hpp"

namespace asperity::cli {
namespace {

// λs < λc, both within the longer side of the field, beyond which a filter separates nothing.
void check_cutoffs(const Tool& tool, const Preparation& asked, const Grid& grid) {
  if (asked.shorter.wavelength >= asked.longer.wavelength)
    throw UsageError("lambda-s", metres(asked.shorter.wavelength) + " is not below --lambda-c, " +
                                     metres(asked.longer.wavelength) + ": no wave passes both filters");
  check_cutoff("lambda-s", asked.shorter, grid);
  check_cutoff("lambda-c", asked.longer, grid);
  warn_of_cutoff(tool, asked.longer.given() ? asked.longer : asked.shorter, grid);
}

// Of the field, its transform, and their like with missing points.
void check_memory(const Tool& tool, Shape shape) {
  constexpr double bytes_a_point = 40;
  tool.require_memory(bytes_a_point * static_cast<double>(shape.cells()), "memory",
                      "measuring " + text(shape) + " points",
                      ": allow more, or cut or thin the map first (asperity-filter --crop, --decimate)");
}

struct StatedRange {
  double low, high;
};

// By the attribute actual_range.
std::optional<StatedRange> stated_range(const Variable& variable) {
  const Values* stated = variable.attributes.find("actual_range");
  if (stated == nullptr || count(*stated) != 2) return std::nullopt;
  const std::vector<double> range = numbers(*stated);
  return StatedRange{range[0], range[1]};
}

// Of a part of a surface, actual_range is the whole's.
bool has_all_points(const Dataset& data, const char* axis) {
  const std::optional<StatedRange> range = stated_range(data.at(axis));
  const std::vector<double> points = numbers(data.at(axis).values);
  const auto [low, high] = std::ranges::minmax(points);
  return !range || std::abs(low - range->low) + std::abs(high - range->high) <= 1e-6 * (high - low);
}

// A program that changes values may keep their attributes: then they lie outside of actual_range, or those of
// a whole surface do not reach its ends. Packed values may miss them by a thousandth of it.
bool was_changed(const Dataset& data, const Surface& surface) {
  const std::optional<StatedRange> range = stated_range(data.at(surface.variable));
  if (!range) return false;
  const double factor = factor_to(surface.units, data.at(surface.variable));
  const double above = surface.heights.maxCoeff<Eigen::PropagateNumbers>() - factor * range->high,
               below = factor * range->low - surface.heights.minCoeff<Eigen::PropagateNumbers>(),
               least = 1e-3 * factor * (range->high - range->low);
  const bool whole = has_all_points(data, "x") && has_all_points(data, "y");
  return above > least || below > least || (whole && (above < -least || below < -least));
}

// Sq² of the surface is that of the map and what was taken.
void warn_of_alignment(const Tool& tool, double share) {
  tool.warn(
      "the scan lines were aligned, which took some " + in_digits(100 * share, 2) +
      " % of Sq of the surface itself: Sq is too small by some " +
      in_digits(100 * (1 - std::sqrt(1 - std::pow(share, 2))), 2) +
      " %, the ACF and the spectrum across the lines, Sal, Str and Std are those of the map without it, "
      "and errors do not allow for it");
}

}  // namespace

void FieldOptions::declare(Tool& tool) {
  declare_field(tool);
  tool.choice("--correlation", correlation, {"auto", "drawn", "estimate"},
              "Correlation that standard errors use. drawn: that of the kernel the heights were drawn with; "
              "estimate: estimated from the field; auto: drawn where the dataset has it, else estimate",
              "Field");
}

void FieldOptions::declare_field(Tool& tool) {
  declare_preparation(tool, "Field");
  tool.memory(
      "Memory limit for measuring, five times the field, and for reading, the bytes of an input plus three "
      "times its map");
}

void FieldOptions::declare_preparation(Tool& tool, const std::string& group) {
  tool.text("--variable", variable, "NAME",
            "Field on (x, y) to measure. Missing points (mask, _FillValue, NaN) are left out", group);
  tool.parsed("--remove-form", form_kind, "Form to subtract first: " + form_words, group, "mean",
              into(asked.form, parse_form));
  tool.parsed("--lambda-s", cutoff_kind,
              "Cut-off of the S-filter, which removes shorter waves; below --lambda-c. " + filter_words,
              group, "", into(asked.shorter, parse_cutoff));
  tool.parsed("--lambda-c", cutoff_kind,
              "Cut-off of the L-filter, which removes longer waves; at most the longer side of the field. "
              "FILTER as of --lambda-s",
              group, "", into(asked.longer, parse_cutoff));
}

Surface FieldOptions::without_heights(const Dataset& data) const {
  Surface out{.grid = grid_of(data),
              .degree = removed_degree(data, variable),
              .filled = filled_share(data, variable),
              .aligned = aligned_share(data, variable),
              .variable = variable,
              .units = si_unit_of(data.at(variable))};
  const bool as_drawn = !asked.filters();
  if (variable == "heights" && as_drawn && correlation != "estimate") {
    out.correlation = carried_correlation(data, "acf_achieved", out.grid);
    if (!out.correlation) out.correlation = carried_correlation(data, "acf_target", out.grid);
    if (const auto marginal = marginal_of(data)) out.distribution = marginal->translation;
  }
  if (correlation == "drawn" && !out.correlation)
    throw DataError(variable,
                    as_drawn ? "the dataset lacks the correlation they were drawn with (acf_target); use "
                               "--correlation estimate"
                             : "a filter changes the correlation they were drawn with; use --correlation "
                               "estimate");
  return out;
}

Surface FieldOptions::read(const Tool& tool, const Dataset& data) const {
  Surface surface = without_heights(data);
  check_memory(tool, surface.grid.shape);
  surface.heights = field_of(data, variable, surface.units, Missing::not_a_number);
  if (surface.correlation && correlation == "auto" && was_changed(data, surface)) {
    tool.warn(variable +
              ": the values are not those of actual_range: they were changed, or it is another "
              "surface's; errors rest on an estimate of their correlation (--correlation drawn: on "
              "acf_target all the same)");
    surface.correlation.reset();
    surface.distribution.reset();
  }
  if (asked.form.kind != Form::Kind::polynomial) check_lengths(surface, "the radius of a form");
  check_cutoffs(tool, asked, surface.grid);
  surface = prepared(std::move(surface), asked, tool.thread_count());
  for (const std::string& doubt : surface.doubts) tool.warn(doubt);
  warn_of_heights(tool, Proportions(surface.heights, surface.grid), surface.units, "--remove-form plane");
  if (surface.filled > 0)
    tool.warn(in_digits(100 * surface.filled, 2) +
              " % of the points were filled; errors take them for measured, and are too small");
  if (surface.aligned > 0) warn_of_alignment(tool, surface.aligned);
  return surface;
}

Surface FieldOptions::read_flat(const Tool& tool, const Dataset& data) const try {
  return read(tool, data);
} catch (const FlatSurface& flat) {
  if ((!flat.surface->heights.isNaN()).count() < 2) throw;
  tool.warn(flat.name + ": " + flat.what() + ": what grows with the heights is 0, the rest has no value");
  return *flat.surface;
}

void direction_option(Tool& tool, std::string& direction, const std::string& group) {
  tool.text("--direction", direction, "ANGLE", "A further direction to measure, from +x towards +y: 30deg",
            group);
}

std::optional<LagField> carried_correlation(const Dataset& data, const std::string& name, const Grid& grid) {
  if (!data.has(name)) return std::nullopt;
  auto fits = [&](std::string_view lag, double spacing) {
    const Variable* axis = data.find(lag);
    const auto lags = axis ? lags_of(*axis) : std::nullopt;
    return !lags || lags->size() < 2 || std::abs((*lags)[1] - (*lags)[0] - spacing) <= 1e-6 * spacing;
  };
  if (!fits("p", grid.dx) || !fits("q", grid.dy)) return std::nullopt;
  return LagField(known_lags(table_of(data, name, "", Missing::not_a_number))).normalised();
}

std::string unit_to(const std::string& unit, int power) {
  return unit == "1" ? unit : unit + std::to_string(power);
}

std::string density_units(const std::string& unit, int lengths) {
  if (unit == "m") return unit_to(unit, 2 + lengths);
  const std::string length = lengths == 1 ? "m" : "m" + std::to_string(lengths);
  return unit == "1" ? length : unit_to(unit, 2) + " " + length;
}

void ResultOption::declare(Tool& tool, const std::string& text) {
  std::vector<std::string> words{result};
  words.insert(words.end(), tables.begin(), tables.end());
  tool.choice("--result", result, words, text, "Result");
}

void ResultOption::check(Tool& tool) const {
  tool.writes_dataset(dataset());
  if (!dataset()) return check_table_name(tool.output_name(), tool.json());
  std::string table;
  for (const std::string& word : tables) table += (table.empty() ? "--result " : " or --result ") + word;
  if (tool.json()) throw UsageError("json", "needs " + table + ": a dataset is NetCDF");
  if (!names_dataset(extension_of(tool.output_name())))
    refuse(
        "output", tool.output_name(),
        "names another format, but a dataset is NetCDF: end the name in .nc, or print a table with " + table);
  refuse_terminal(tool.output_name(), "a dataset", ", or print a table with " + table);
}

void warn_of_few(const Tool& tool, const EffectiveSampleSize& size) {
  const double least = size.least_effective();
  if (!size.form_leaves_enough() && size.effective(2) >= least)
    return tool.warn("standard errors and intervals cannot be given: " + too_few(size) +
                     "; remove a form of lower degree");
  if (size.effective(2) >= 2 * least) return;
  tool.warn("the surface is worth N_eff = " + rounded(size.effective(2)) +
            " independent points: standard errors and intervals " +
            (size.gives_errors() ? "are rough, and cannot be given below " : "cannot be given below ") +
            shortest(least) + "; measure a larger field, or filter out waviness (--lambda-c)");
}

bool warn_of_length(const Tool& tool, const std::string& name, double length, const Grid& grid) {
  const double sample = std::min(grid.dx, grid.dy), half = std::max(grid.size_x(), grid.size_y()) / 2;
  const double place = std::pow(10, std::floor(std::log10(length)) - 3);
  const std::string found = name + " = " + metres(std::round(length / place) * place);
  if (length < sample)
    tool.warn(found + " is below a sample, " + metres(sample) +
              ": neighbours are hardly correlated, and the length depends on the interpolation; sample more "
              "finely");
  if (length > half)
    tool.warn(found + " is beyond half the field, " + metres(half) +
              ", too long to be measured on it; measure a larger field");
  return length >= sample && length <= half;
}

void warn_of_decays(const Tool& tool, const Parameters& spatial, double level, const Grid& grid) {
  auto found = [&](const char* name) { return std::ranges::find(spatial, name, &Parameter::name); };
  if (found("slowest_decay") == spatial.end())
    tool.warn("in some direction the ACF does not fall to " + shortest(level) +
              " within half the field: Str has no value");
  if (const auto sal = found("Sal"); sal != spatial.end()) warn_of_length(tool, "Sal", sal->value, grid);
}

}  // namespace asperity::cli
