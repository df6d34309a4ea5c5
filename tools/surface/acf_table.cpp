#include "tools/surface/acf_table.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "acf/table.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/netcdf.hpp"
#include "dataset/units.hpp"
#include "formats/text_table.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/cli/stream.hpp"
#include "tools/surface/kernel_options.hpp"
#include "tools/surface/spectrum_table.hpp"

namespace asperity::cli {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw DataError("acf", message); }

bool counts_samples(const std::string& unit) { return unit.empty() || unit == "1" || unit == "px"; }

double metres(const std::string& unit) try {
  return unit_factor(unit, "m");
} catch (const std::invalid_argument& e) {
  refuse(e.what());
}

// The rms height of a table in `unit`, none where that is no square of a length.
double rms_of(double variance, const std::string& unit) try {
  return counts_samples(unit) ? NAN : std::sqrt(variance * unit_factor(unit, "m2"));
} catch (const std::invalid_argument&) {
  return NAN;
}

// ---- datasets ----

std::optional<std::vector<double>> lags_in_metres(const Variable& axis) try {
  return lags_of(axis);
} catch (const DataError& e) {
  refuse("its lags " + axis.name + ": " + e.what());
}

// The step of a coordinate whose point number `origin` is 0: in metres, or none where it counts samples or
// has one point only.
std::optional<double> step_of(const Dataset& data, const std::string& name, Index origin) {
  const Variable* axis = data.find(name);
  if (axis == nullptr) return std::nullopt;
  const std::optional<std::vector<double>> in_metres = lags_in_metres(*axis);
  const std::vector<double> lags = in_metres ? *in_metres : numbers(axis->values);
  const auto n = static_cast<Index>(lags.size());
  const double step = n > 1 ? (lags.back() - lags.front()) / static_cast<double>(n - 1) : 1;
  for (Index i = 0; i < n; ++i)
    if (!(step > 0 && std::abs(lags[static_cast<std::size_t>(i)] - static_cast<double>(i - origin) * step) <=
                          1e-3 * step))
      refuse("the lags " + name + " are not evenly spaced " + (origin > 0 ? "around 0" : "from 0"));
  if (n < 2 || !in_metres) return std::nullopt;
  return step;
}

// From the lags or from the grid, which must agree; a profile takes the step that is known for both.
Spacing spacing_of_lags(const Dataset& data, std::optional<double> dx, std::optional<double> dy) {
  if (data.has("x") && data.has("y")) {
    const Grid grid = grid_of(data);
    for (const auto& [lag, spacing] : {std::pair(dx, grid.dx), std::pair(dy, grid.dy)})
      if (lag && std::abs(*lag / spacing - 1) > 1e-6)
        refuse("its lags have a step of " + format_quantity(*lag, "m") + ", the grid one of " +
               format_quantity(spacing, "m"));
    return std::array{grid.dx, grid.dy};
  }
  if (!dx && !dy) return std::nullopt;
  return std::array{dx.value_or(dy.value_or(1)), dy.value_or(dx.value_or(1))};
}

bool has_all_lags(const Field& half_plane, Shape period) {
  return half_plane.rows() == period.nx / 2 + 1 && half_plane.cols() == period.ny / 2 * 2 + 1;
}

// The period of the surface that the table was measured on, or is the target of, where it has all lags of
// that.
std::optional<Shape> period_of(const Dataset& data, const std::string& name, const Field& half_plane) {
  std::optional<Shape> period = kernel_corner(data) ? std::nullopt : kernel_period(data);
  if (name == "acf") {
    if (!data.has("x") || !data.has("y")) return std::nullopt;
    const Grid grid = grid_of(data);
    if (!grid.periodic.both()) return std::nullopt;
    period = grid.shape;
  }
  return period && has_all_lags(half_plane, *period) ? period : std::nullopt;
}

// ---- text ----

// Of the last comment that names them.
std::vector<HeadedColumn> columns_in(std::string_view bytes) {
  std::vector<HeadedColumn> out;
  while (!bytes.empty()) {
    const std::string_view line = bytes.substr(0, bytes.find('\n'));
    bytes.remove_prefix(std::min(line.size() + 1, bytes.size()));
    if (!line.starts_with('#')) continue;
    const auto columns = columns_of(line.substr(1));
    if (place(columns, "acf") && (place(columns, "lag_x") || place(columns, "lag_y"))) out = columns;
  }
  return out;
}

// Values at lags, a line each.
void take_columns(AcfTable& out, const std::vector<HeadedColumn>& columns, const Field& rows) {
  const auto x = place(columns, "lag_x"), y = place(columns, "lag_y"), r = place(columns, "acf");
  if (!x || !y) refuse(x ? "its header names no column lag_y" : "its header names no column lag_x");
  const std::string &unit_x = columns[*x].unit, &unit_y = columns[*y].unit;
  if (counts_samples(unit_x) != counts_samples(unit_y))
    refuse("one lag has a unit of length, the other none");
  std::vector<LagValue> values;
  for (Index i = 0; i < rows.rows(); ++i) {
    auto in = [&](std::size_t column) { return rows(i, static_cast<Index>(column)); };
    values.push_back({in(*x), in(*y), in(*r)});
  }
  LagTable lags = table_of_lags(values);
  out.half_plane = std::move(lags.half_plane);
  target_of_table(out.half_plane);
  auto step = [](double value, const std::string& unit) -> std::optional<double> {
    if (std::isnan(value) || counts_samples(unit)) return std::nullopt;
    return value * metres(unit);
  };
  out.spacing = spacing_of_lags({}, step(lags.step_x, unit_x), step(lags.step_y, unit_y));
  out.rms = rms_of(out.half_plane(0, out.half_plane.cols() / 2), columns[*r].unit);
}

AcfTable from_text(std::string_view bytes, const MemoryBound& memory) {
  Reading reading;
  reading.memory = memory;
  const std::vector<HeadedColumn> columns = columns_in(bytes);
  const Field rows = matrix_of(bytes, "acf", 1, reading);
  const auto named = static_cast<Index>(columns.size());
  if (named > 0 && rows.cols() != named)
    refuse("its lines have " + counted(rows.cols(), "number") + ", its header " + counted(named, "name"));
  if (rows.isNaN().any()) refuse("a number is missing in it");
  AcfTable out;
  out.any_period = true;
  if (named > 0) {
    take_columns(out, columns, rows);
    return out;
  }
  out.half_plane = half_plane_of_quadrant(rows);
  target_of_table(out.half_plane);
  return out;
}

}  // namespace

std::optional<Shape> AcfTable::period_on(Shape periodic) const {
  return any_period && periodic != Shape{} && has_all_lags(half_plane, periodic) ? periodic : period;
}

AcfTable acf_table_of(Dataset data) {
  const std::string name = data.has("acf") ? "acf" : "acf_target";
  if (!data.has(name)) refuse("the dataset has none; asperity-acf adds it");
  AcfTable out;
  Field table = table_of(data, name, "", Missing::not_a_number);
  const Index lag_zero = table.cols() / 2;
  const bool whole = !table.isNaN().any();
  out.half_plane = whole ? std::move(table) : known_lags(table);
  out.left_out = name == "acf" && !whole && out.half_plane.size() < table.size();
  target_of_table(out.half_plane);
  const Variable& variable = data.at(name);
  const Index middle = out.half_plane.cols() / 2;
  const std::string &rows = variable.dimensions[0], &columns = variable.dimensions[1];
  if (data.has(rows) != data.has(columns) && std::min(data.length(rows), data.length(columns)) > 1)
    refuse("its lags " + (data.has(rows) ? columns : rows) +
           " have no coordinate, but those of the other axis do");
  out.spacing = spacing_of_lags(data, step_of(data, variable.dimensions[0], 0),
                                step_of(data, variable.dimensions[1], lag_zero));
  out.rms = rms_of(out.half_plane(0, middle), unit_of(variable));
  if (name == "acf") {
    if (std::isnan(out.rms)) out.rms = std::sqrt(data.attributes.number("acf_variance", NAN));
    out.heights = measured_with_acf(data);
  }
  out.period = period_of(data, name, out.half_plane);
  out.positive_definite = name == "acf" && !out.period && data.attributes.find("acf_taper") != nullptr;
  out.dataset = std::move(data);
  return out;
}

AcfTable read_acf_table(const std::string& name, const MemoryBound& memory) {
  const Bytes bytes = read_all(name, memory);
  const MemoryBound left = memory.beside(bytes.size());
  return looks_like_netcdf(bytes) ? acf_table_of(decode_netcdf(bytes, left)) : from_text(bytes, left);
}

void refuse_model(const Tool& tool, const char* table) {
  std::vector<const char*> of_model{"model", "length", "length-level", "angle", "rolloff", "cutoff"};
  for (const ShapeParameter& parameter : shape_parameters) of_model.push_back(parameter.name);
  for (const char* option : of_model)
    if (tool.given(std::string("--") + option))
      throw UsageError(option, std::string("cannot be combined with --") + table +
                                   ", which gives the whole autocorrelation");
}

void refuse_solver(const Tool& tool, const KernelOptions& o, const std::string& limit) {
  for (const char* option : {"lags", "formulation"})
    if (tool.given(std::string("--") + option))
      throw UsageError(option, "cannot be combined with --" + limit + ", which leaves no equations to solve");
  if (tool.given("--method") && !o.filters())
    throw UsageError(
        "method", o.method + ": cannot be combined with --" + limit + ", which leaves no equations to solve");
}

std::optional<AcfTable> wanted_table(const Tool& tool, const KernelOptions& o, const Spacing& spacing,
                                     Shape surface, bool periodic) {
  if (tool.given("--psd")) {
    refuse_model(tool, "psd");
    refuse_solver(tool, o, "psd");
    if (tool.given("--acf"))
      throw UsageError("acf", "cannot be combined with --psd, which gives the whole autocorrelation");
    return acf_of_spectrum(tool, o.psd, spacing, surface, periodic);
  }
  if (!tool.given("--acf")) return std::nullopt;
  refuse_model(tool, "acf");
  AcfTable out = read_acf_table(o.acf, tool.memory_bound());
  tool.reads(o.acf, !out.dataset.variables.empty());
  return out;
}

}  // namespace asperity::cli
