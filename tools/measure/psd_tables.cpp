#include "tools/measure/psd_tables.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "stats/measure/scales.hpp"
#include "tools/cli/surface_words.hpp"

namespace asperity::cli {
namespace {

using Reach = CommonWaveNumbers::Reach;

Reach reach_along(Axis1D axis, const Grid& grid, const Grid& finest) {
  return axis == Axis1D::x ? Reach::of(2 * std::numbers::pi / grid.size_x(), grid.dx, finest.dx)
                           : Reach::of(2 * std::numbers::pi / grid.size_y(), grid.dy, finest.dy);
}
Reach reach_of_rings(const Grid& grid, const Grid& finest) {
  return Reach::of(2 * std::numbers::pi / std::min(grid.size_x(), grid.size_y()), std::max(grid.dx, grid.dy),
                   std::max(finest.dx, finest.dy));
}

// Columns of the errors of a density.
std::vector<Column> of_errors(const std::string& unit) {
  return {{"psd", unit},
          {"standard_error", unit, Holds::unknown},
          {"low_95", unit, Holds::unknown},
          {"high_95", unit, Holds::unknown},
          {"no_error", ""}};
}

std::string word(NoError why) { return why == NoError::none ? "-" : reason(why); }

// Waves and scales below `least` are not the surface's.
std::vector<Cell> cells(SpectrumPoint point, double least) {
  if (point.wave_number * least > 2 * std::numbers::pi)
    point.no_error = NoError::tip, point.standard_error = NAN;
  const Interval ends = point.interval();
  return {point.density, point.standard_error, ends.low, ends.high, word(point.no_error)};
}

// Without the columns that unequal grids have not in common.
Table common_table(std::vector<Column> keys, const std::string& unit) {
  Table out{std::move(keys), {}};
  out.columns.push_back({"psd", unit});
  out.columns.push_back({"standard_error", unit, Holds::unknown});
  return out;
}

std::vector<SpectrumPoint> rings_of(const Sample& sample, const DataWindows& windows) {
  std::vector<SpectrumPoint> out = radial_spectrum(sample, windows);
  if (out.empty())
    throw DataError("heights",
                    "no ring of wave numbers fits a field of " + described(sample.grid()) +
                        ": its shorter side is below twice the larger spacing; use --result profiles or "
                        "--result dataset");
  return out;
}

// Of a derivative of order d.
std::string unit_of_derivative(const std::string& unit, int order) {
  if (unit == "m") return order == 0 ? "m" : order == 1 ? "1" : "m-1";
  const std::string per = order == 0 ? "" : "m-" + std::to_string(order);
  return unit == "1" && order > 0 ? per : unit + (order > 0 ? " " : "") + per;
}

}  // namespace

std::optional<CommonSpectra> common_spectra(const std::vector<Grid>& grids,
                                            const std::vector<double>& areas) {
  if (std::ranges::all_of(grids, [&](const Grid& one) { return same_grid(grids[0], one); })) return {};
  Grid finest = grids[0];
  for (const Grid& grid : grids)
    finest.dx = std::min(finest.dx, grid.dx), finest.dy = std::min(finest.dy, grid.dy);
  std::vector<Reach> rings, x, y;
  for (const Grid& grid : grids) {
    rings.push_back(reach_of_rings(grid, finest));
    x.push_back(reach_along(Axis1D::x, grid, finest)), y.push_back(reach_along(Axis1D::y, grid, finest));
  }
  return CommonSpectra{CommonWaveNumbers(rings), CommonWaveNumbers(x), CommonWaveNumbers(y), areas, finest};
}

Table radial_psd(const Sample& sample, const DataWindows& windows, double least) {
  const Surface& surface = sample.surface();
  Table out{{{"wave_number", per_length}}, {}};
  std::ranges::copy(of_errors(density_units(surface.units, 2)), std::back_inserter(out.columns));
  out.columns.push_back({"count", "1"});
  for (const SpectrumPoint& ring : rings_of(sample, windows)) {
    std::vector<Cell>& row = out.rows.emplace_back();
    row.emplace_back(ring.wave_number);
    std::ranges::copy(cells(ring, least), std::back_inserter(row));
    row.emplace_back(ring.count);
  }
  return out;
}

Table profile_psds(const Sample& sample, const DataWindows& windows, double least) {
  Table out{{{"direction", ""}, {"wave_number", per_length}}, {}};
  std::ranges::copy(of_errors(density_units(sample.surface().units, 1)), std::back_inserter(out.columns));
  auto add = [&](const char* direction, Axis1D axis, DataWindow window) {
    for (const SpectrumPoint& point : profile_spectrum(sample, axis, window)) {
      std::vector<Cell>& row = out.rows.emplace_back();
      row.emplace_back(direction), row.emplace_back(point.wave_number);
      std::ranges::copy(cells(point, least), std::back_inserter(row));
    }
  };
  add("x", Axis1D::x, windows.x);
  add("y", Axis1D::y, windows.y);
  return out;
}

Table common_radial(const Sample& sample, const DataWindows& windows, const CommonSpectra& common) {
  Table out = common_table({{"wave_number", per_length}}, density_units(sample.surface().units, 2));
  const Reach reach = reach_of_rings(sample.grid(), common.finest);
  for (const SpectrumPoint& p : common.radial.means(rings_of(sample, windows), reach))
    out.rows.push_back({p.wave_number, p.density, p.standard_error});
  return out;
}

Table common_profiles(const Sample& sample, const DataWindows& windows, const CommonSpectra& common) {
  Table out = common_table({{"direction", ""}, {"wave_number", per_length}},
                           density_units(sample.surface().units, 1));
  for (const Axis1D axis : {Axis1D::x, Axis1D::y}) {
    const bool x = axis == Axis1D::x;
    const auto own = profile_spectrum(sample, axis, x ? windows.x : windows.y);
    const Reach reach = reach_along(axis, sample.grid(), common.finest);
    for (const SpectrumPoint& p : (x ? common.x : common.y).means(own, reach))
      out.rows.push_back({x ? "x" : "y", p.wave_number, p.density, p.standard_error});
  }
  return out;
}

Table scale_table(const Sample& sample, const DataWindows& windows, double least) {
  Table out{{{"quantity", ""}, {"direction", ""}, {"scale", "m"}, {"unit", ""}}, {}};
  std::ranges::copy(of_errors("SI"), std::back_inserter(out.columns));
  out.columns[4] = {"value", "SI", Holds::unknown};
  for (ScalePoint& at : by_scale(sample, windows)) {
    if (at.scale < least) at.no_error = NoError::tip, at.estimate = {at.estimate.value};
    const Interval ends = at.estimate.interval.value_or(Interval());
    out.rows.push_back({at.quantity, at.axis == Axis1D::x ? "x" : "y", at.scale,
                        unit_of_derivative(sample.surface().units, at.order), at.estimate.value,
                        at.estimate.standard_error, ends.low, ends.high, word(at.no_error)});
  }
  if (out.rows.empty())
    throw DataError("heights", "no scale fits a field of " + described(sample.grid()) +
                                   ": scales need a side of 4 points; use --result profiles");
  return out;
}

EnsembleTable::Content psd_content(const Table& one) {
  if (one.columns[0].name == "quantity")
    return {.keys = {"quantity", "direction", "scale", "unit"}, .value = "value", .reason = "no_error"};
  if (std::ranges::find(one.columns, "no_error", &Column::name) == one.columns.end())
    return {.keys = one.columns[0].name == "direction" ? std::vector<std::string>{"direction", "wave_number"}
                                                       : std::vector<std::string>{"wave_number"},
            .value = "psd"};
  if (one.columns[0].name == "direction")
    return {.keys = {"direction", "wave_number"}, .value = "psd", .reason = "no_error"};
  return {.keys = {"wave_number", "count"}, .value = "psd", .reason = "no_error"};
}

}  // namespace asperity::cli
