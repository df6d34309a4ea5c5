#include "tools/measure/height_tables.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "stats/height/kernel_density.hpp"
#include "stats/height/material_ratio.hpp"
#include "stats/measure/quantile_estimates.hpp"
#include "tools/measure/field_options.hpp"

namespace asperity::cli {
namespace {

// NaN where errors cannot be given.
double known(const Sample& of, double error) { return of.size().gives_errors() ? error : NAN; }
double misfit(const Sample& of, double deviation, double error) {
  const double scale = known(of, error);
  return scale > 0 || std::isnan(scale) ? deviation / scale : deviation;
}

std::vector<Column> with_error(Column value, const std::string& error = "standard_error") {
  const std::string unit = value.unit;
  return {std::move(value),
          {error, unit, Holds::unknown},
          {"low_95", unit, Holds::open},
          {"high_95", unit, Holds::open}};
}

Table table_of(std::initializer_list<std::vector<Column>> columns) {
  Table out{{}, {}};
  for (const std::vector<Column>& some : columns)
    out.columns.insert(out.columns.end(), some.begin(), some.end());
  return out;
}

// A value, its error, and its interval.
void append(std::vector<Cell>& row, const Sample& of, double value, double error, const Interval& ends) {
  row.insert(row.end(), {value, known(of, error), known(of, ends.low), known(of, ends.high)});
}

void append(std::vector<Cell>& row, const Sample& of, const Estimate& e) {
  const bool has_error = std::isfinite(e.standard_error);
  const Interval about = Interval::about(e.value, half_width_95 * e.standard_error);
  append(row, of, e.value, e.standard_error, has_error ? e.interval.value_or(about) : Interval());
}

// More than 0 where a cell is in contact; nothing where the dataset has neither.
std::optional<Field> contact_of(const Dataset& data) {
  for (const char* name : {"contact", "pressure"})
    if (data.has(name)) return field_of(data, name, Missing::not_a_number);
  return std::nullopt;
}

const char* verb(double count) { return count == 1 ? "is" : "are"; }

}  // namespace

Table histogram_of(const Sample& of, int bins, std::optional<HeightRange> range) {
  const Surface& surface = of.surface();
  const std::string density = unit_to(surface.units, -1);
  Table out = table_of({{{"height", surface.units}},
                        with_error({"count", "1"}),
                        {{"gaussian", "1"},
                         {"misfit", "1", Holds::unknown},
                         {"density", density},
                         {"density_error", density, Holds::unknown},
                         {"gaussian_density", density}}});
  std::vector<Bin> all = histogram(surface.heights, bins, range);
  compare_with_gaussian(all, of.moments(), of.size());
  set_errors(all, surface.heights, of.grid(), of.extent(), of.moments().sq);
  const double n = of.size().points();
  for (const Bin& bin : all) {
    const double per_height = 1 / (n * bin.width()), error = known(of, n * bin.share.error);
    const Interval& ends = bin.share.interval;
    out.rows.push_back({bin.centre()});
    append(out.rows.back(), of, bin.count, error, Interval::of(bin.count, n * ends.low, n * ends.high));
    out.rows.back().insert(out.rows.back().end(),
                           {bin.expected, misfit(of, bin.count - bin.expected, bin.misfit_error),
                            bin.count * per_height, error * per_height, bin.expected * per_height});
  }
  return out;
}

Table density_of(const Sample& of, double bandwidth, int rows, std::optional<HeightRange> range) {
  const Surface& surface = of.surface();
  const std::string density = unit_to(surface.units, -1);
  Table out = table_of({{{"height", surface.units}},
                        with_error({"density", density}),
                        {{"gaussian_density", density}, {"misfit", "1", Holds::unknown}}});
  std::vector<DensityPoint> curve = kernel_density(surface.heights, bandwidth, rows, range);
  compare_with_gaussian(curve, of.moments(), of.size(), bandwidth);
  set_errors(curve, surface.heights, of.grid(), of.extent(), bandwidth, of.moments().sq);
  for (const DensityPoint& p : curve) {
    out.rows.push_back({p.height});
    append(out.rows.back(), of, p.density, p.frequency.error, p.frequency.interval);
    out.rows.back().insert(out.rows.back().end(),
                           {p.gaussian, misfit(of, p.density - p.gaussian, p.misfit_error)});
  }
  return out;
}

Table quantiles_of(const Sample& of, int rows) {
  const std::string& unit = of.surface().units;
  Table out = table_of({{{"share", "1"}, {"normal_quantile", "1"}},
                        with_error({"height", unit}),
                        {{"gaussian_height", unit}, {"misfit", "1", Holds::unknown}}});
  const std::vector<QuantilePoint> points = quantile_plot(of.material_ratio(), of.moments(), of.size(), rows);
  std::vector<double> shares, heights;
  for (const QuantilePoint& p : points) shares.push_back(p.share), heights.push_back(p.height);
  const std::vector<Estimate> estimates = quantile_estimates(of, shares, heights);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const QuantilePoint& p = points[i];
    out.rows.push_back({p.share, p.normal});
    append(out.rows.back(), of, estimates[i]);
    out.rows.back().insert(out.rows.back().end(),
                           {p.gaussian, misfit(of, p.height - p.gaussian, p.misfit_error)});
  }
  return out;
}

std::string CountedCells::words() const {
  return fmt::format("{} of the {} that {} {}; the other {:.3g} % of {:.0f} cells are {}, and not counted",
                     variable, asperity::counted(static_cast<std::int64_t>(counted), "cell"), verb(counted),
                     which, 100 * (1 - counted / cells), cells, without);
}

std::string CountedCells::words_for_all() const {
  return fmt::format("{} of all {:.0f} cells, of which {:.0f} {} {}: asperity-pdf counts these alone",
                     variable, cells, counted, verb(counted), which);
}

std::optional<CountedCells> counted_cells(const Dataset& data, const std::string& variable) {
  if (!data.has(variable) || (variable != "pressure" && variable != "gap")) return std::nullopt;
  const bool pressure = variable == "pressure";
  const std::optional<Field> contact = contact_of(data);
  if (!contact) return std::nullopt;
  CountedCells out{.variable = variable,
                   .units = si_unit_of(data.at(variable)),
                   .grid = grid_of(data),
                   .values = field_of(data, variable, Missing::not_a_number),
                   .which = pressure ? "in contact" : "open",
                   .without = pressure ? "open, without pressure" : "in contact, without a gap"};
  out.cells = static_cast<double>((!out.values.isNaN()).count());
  const Field& in_contact = pressure ? out.values : *contact;
  const Eigen::ArrayXX<bool> counts = pressure ? (in_contact > 0).eval() : (in_contact == 0).eval();
  out.values = counts.select(out.values, NAN).eval();
  out.counted = static_cast<double>((!out.values.isNaN()).count());
  if (out.counted == 0)
    throw DataError(variable, "no cell is " + std::string(pressure ? "in contact" : "open"));
  return out;
}

Table histogram_of(const Part& part, int bins, double largest) {
  const auto& [cells, of] = part;
  const std::string density = unit_to(cells.units, -1);
  Table out = table_of({{{cells.variable, cells.units}},
                        with_error({"count", "1"}),
                        {{"share", "1"}, {"density", density}, {"density_error", density, Holds::unknown}}});
  std::vector<Bin> all = histogram(cells.values, bins, HeightRange{0, largest});
  if (of) set_errors(all, cells.values, of->grid(), of->extent());
  const bool known_errors = of && of->size().gives_errors();
  const double n = cells.counted;
  for (const Bin& bin : all) {
    const double per = 1 / (n * bin.width()), error = known_errors ? n * bin.share.error : NAN;
    const Interval ends = known_errors ? bin.share.interval : Interval();
    out.rows.push_back({bin.centre(), bin.count, error, n * ends.low, n * ends.high, bin.count / cells.cells,
                        bin.count * per, error * per});
  }
  return out;
}

Table quantiles_of(const Part& part, int rows) {
  const auto& [cells, of] = part;
  Table out = table_of({{{"share", "1"}}, with_error({cells.variable, cells.units})});
  std::vector<double> shares;
  for (int k = 1; k <= rows; ++k) shares.push_back(static_cast<double>(k) / (rows + 1));
  if (!of) {
    const double value = height_range(cells.values).highest;
    for (const double share : shares) out.rows.push_back({share, value, NAN, NAN, NAN});
    return out;
  }
  const std::vector<Estimate> estimates =
      quantile_estimates(*of, shares, of->quantiles(shares), Origin::zero);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    out.rows.push_back({shares[k]});
    append(out.rows.back(), *of, estimates[k]);
  }
  return out;
}

}  // namespace asperity::cli
