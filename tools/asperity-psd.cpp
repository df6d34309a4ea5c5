// Power spectral densities of a surface, of its profiles, and over rings.
#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "stats/measure.hpp"
#include "stats/measure/scales.hpp"
#include "stats/measure/spectra.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"
#include "tools/measure/preparation_words.hpp"

using namespace asperity;

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

// What several surfaces of unequal grids have in common.
struct Common {
  CommonWaveNumbers radial, x, y;
  std::vector<double> areas;
  Grid finest;  ///< its spacings
};

struct Options {
  std::string window = "auto";
  double tip_radius = INFINITY;
  cli::ResultOption result{{"profiles", "radial", "scales"}};

  DataWindows windows(const Grid& grid) const {
    if (window == "auto") return default_windows(grid);
    const DataWindow both = window == "hann" ? DataWindow::hann : DataWindow::none;
    return {both, both};
  }
  void check(cli::Tool& tool) const {
    result.check(tool);
    if (!tool.given("--tip-radius")) return;
    if (!(tip_radius > 0)) throw cli::UsageError("tip-radius", "is not above 0 m");
    if (result.dataset())
      throw cli::UsageError("tip-radius", "needs --result scales, --result profiles or --result radial");
    if (tool.given("--lambda-s"))
      throw cli::UsageError("tip-radius", "needs heights as the tip left them, but --lambda-s smooths them");
  }
};

constexpr const char* per_length = "rad m-1";

// Columns of the errors of a density.
std::vector<cli::Column> of_errors(const std::string& unit) {
  return {{"psd", unit},
          {"standard_error", unit, cli::Holds::unknown},
          {"low_95", unit, cli::Holds::unknown},
          {"high_95", unit, cli::Holds::unknown},
          {"no_error", ""}};
}

std::string word(NoError why) { return why == NoError::none ? "-" : reason(why); }

// Waves and scales below `least` are not the surface's.
std::vector<cli::Cell> cells(SpectrumPoint point, double least) {
  if (point.wave_number * least > 2 * std::numbers::pi)
    point.no_error = NoError::tip, point.standard_error = NAN;
  const Interval ends = point.interval();
  return {point.density, point.standard_error, ends.low, ends.high, word(point.no_error)};
}

// Without the columns that unequal grids have not in common.
cli::Table common_table(std::vector<cli::Column> keys, const std::string& unit) {
  cli::Table out{std::move(keys), {}};
  out.columns.push_back({"psd", unit});
  out.columns.push_back({"standard_error", unit, cli::Holds::unknown});
  return out;
}

cli::Table common_radial(const Sample& sample, const DataWindows& windows, const Common& common) {
  cli::Table out = common_table({{"wave_number", per_length}}, cli::density_units(sample.surface().units, 2));
  const Reach reach = reach_of_rings(sample.grid(), common.finest);
  for (const SpectrumPoint& p : common.radial.means(radial_spectrum(sample, windows), reach))
    out.rows.push_back({p.wave_number, p.density, p.standard_error});
  return out;
}

cli::Table common_profiles(const Sample& sample, const DataWindows& windows, const Common& common) {
  cli::Table out = common_table({{"direction", ""}, {"wave_number", per_length}},
                                cli::density_units(sample.surface().units, 1));
  for (const Axis1D axis : {Axis1D::x, Axis1D::y}) {
    const bool x = axis == Axis1D::x;
    const auto own = profile_spectrum(sample, axis, x ? windows.x : windows.y);
    const Reach reach = reach_along(axis, sample.grid(), common.finest);
    for (const SpectrumPoint& p : (x ? common.x : common.y).means(own, reach))
      out.rows.push_back({x ? "x" : "y", p.wave_number, p.density, p.standard_error});
  }
  return out;
}

cli::Table radial(const Sample& sample, const DataWindows& windows, double least) {
  const Surface& surface = sample.surface();
  cli::Table out{{{"wave_number", per_length}}, {}};
  std::ranges::copy(of_errors(cli::density_units(surface.units, 2)), std::back_inserter(out.columns));
  out.columns.push_back({"count", "1"});
  for (const SpectrumPoint& ring : radial_spectrum(sample, windows)) {
    std::vector<cli::Cell>& row = out.rows.emplace_back();
    row.emplace_back(ring.wave_number);
    std::ranges::copy(cells(ring, least), std::back_inserter(row));
    row.emplace_back(ring.count);
  }
  if (out.rows.empty())
    throw DataError("heights",
                    "no ring of wave numbers fits a field of " + cli::described(surface.grid) +
                        ": its shorter side is below twice the larger spacing; use --result profiles or "
                        "--result dataset");
  return out;
}

cli::Table profiles(const Sample& sample, const DataWindows& windows, double least) {
  cli::Table out{{{"direction", ""}, {"wave_number", per_length}}, {}};
  std::ranges::copy(of_errors(cli::density_units(sample.surface().units, 1)),
                    std::back_inserter(out.columns));
  auto add = [&](const char* direction, Axis1D axis, DataWindow window) {
    for (const SpectrumPoint& point : profile_spectrum(sample, axis, window)) {
      std::vector<cli::Cell>& row = out.rows.emplace_back();
      row.emplace_back(direction), row.emplace_back(point.wave_number);
      std::ranges::copy(cells(point, least), std::back_inserter(row));
    }
  };
  add("x", Axis1D::x, windows.x);
  add("y", Axis1D::y, windows.y);
  return out;
}

// Of a derivative of order d.
std::string unit_of_derivative(const std::string& unit, int order) {
  if (unit == "m") return order == 0 ? "m" : order == 1 ? "1" : "m-1";
  const std::string per = order == 0 ? "" : "m-" + std::to_string(order);
  return unit == "1" && order > 0 ? per : unit + (order > 0 ? " " : "") + per;
}

cli::Table scales(const Sample& sample, const DataWindows& windows, double least) {
  cli::Table out{{{"quantity", ""}, {"direction", ""}, {"scale", "m"}, {"unit", ""}}, {}};
  std::ranges::copy(of_errors("SI"), std::back_inserter(out.columns));
  out.columns[4] = {"value", "SI", cli::Holds::unknown};
  for (ScalePoint& at : by_scale(sample, windows)) {
    if (at.scale < least) at.no_error = NoError::tip, at.estimate = {at.estimate.value};
    const Interval ends = at.estimate.interval.value_or(Interval());
    out.rows.push_back({at.quantity, at.axis == Axis1D::x ? "x" : "y", at.scale,
                        unit_of_derivative(sample.surface().units, at.order), at.estimate.value,
                        at.estimate.standard_error, ends.low, ends.high, word(at.no_error)});
  }
  if (out.rows.empty())
    throw DataError("heights", "no scale fits a field of " + cli::described(sample.grid()) +
                                   ": scales need a side of 4 points; use --result profiles");
  return out;
}

// The scale from which on a tip has left the surface as it was; 0 without one.
double least_scale(const cli::Tool& tool, const Options& what, const Surface& surface, bool alone) {
  if (!tool.given("--tip-radius")) return 0;
  cli::check_lengths(surface, "the radius of a tip");
  const double reliable = first_reliable_scale(surface, what.tip_radius);
  if (!alone) return reliable;
  const std::string tip = "a tip of " + cli::metres(what.tip_radius), scale = cli::metres(reliable);
  if (reliable == 0)
    tool.note(tip + " follows the surface at all scales of its grid");
  else
    tool.note(tip + " falsifies scales below " + scale +
              ": they have no error here; asperity-stats --lambda-s " + scale +
              " leaves them out of slopes, curvatures and summits");
  return reliable;
}

// Writes psd, or another function of the wave numbers, in place of a former one.
void write(Dataset& data, const char* name, const Field& half_plane, const Surface& surface,
           const char* meaning) {
  const auto step = [](double size) { return 2 * std::numbers::pi / size; };
  set_table(data, name, half_plane,
            {"wave_number_x", 0, step(surface.grid.size_x()), per_length, "wave number in x"},
            {"wave_number_y", -(half_plane.cols() / 2), step(surface.grid.size_y()), per_length,
             "wave number in y"},
            {cli::density_units(surface.units, 2), meaning});
}

void describe(Dataset& data, const Surface& surface, const DataWindows& windows) {
  data.attributes.set("psd_variable", surface.variable);
  data.attributes.set("psd_window", windows.x == DataWindow::hann ? "hann" : "none");
}

cli::Table table(const cli::Tool& tool, const Options& what, Surface surface, bool alone,
                 const std::optional<Common>& common) {
  const DataWindows windows = what.windows(surface.grid);
  const bool flat = surface.flat;
  const double least = flat ? 0 : least_scale(tool, what, surface, alone);
  const Sample sample = flat ? stand_in(surface) : Sample(std::move(surface), tool.thread_count());
  const std::string& result = what.result.result;
  if (common) {
    if (flat)
      throw DataError("heights", "a surface is flat, and the grids differ: leave it out, its density is 0");
    return (result == "profiles" ? common_profiles : common_radial)(sample, windows, *common);
  }
  cli::Table out = (result == "profiles" ? profiles
                    : result == "radial" ? radial
                                         : scales)(sample, windows, least);
  const auto value = static_cast<std::size_t>(
      std::ranges::find(out.columns, "standard_error", &cli::Column::name) - out.columns.begin() - 1);
  for (auto& row : out.rows) {
    if (flat)
      row[value] = 0.0, row[value + 1] = row[value + 2] = row[value + 3] = NAN, row[value + 4] = "flat";
    // The spread of several knows no size.
    if (!alone && row[value + 4] == cli::Cell(reason(NoError::size))) row[value + 4] = "-";
  }
  return out;
}

// What of these tables has a mean.
cli::EnsembleTable::Content content_of(const cli::Table& one) {
  if (one.columns[0].name == "quantity")
    return {.keys = {"quantity", "direction", "scale", "unit"}, .value = "value", .reason = "no_error"};
  if (std::ranges::find(one.columns, "no_error", &cli::Column::name) == one.columns.end())
    return {.keys = one.columns[0].name == "direction" ? std::vector<std::string>{"direction", "wave_number"}
                                                       : std::vector<std::string>{"wave_number"},
            .value = "psd"};
  if (one.columns[0].name == "direction")
    return {.keys = {"direction", "wave_number"}, .value = "psd", .reason = "no_error"};
  return {.keys = {"wave_number", "count"}, .value = "psd", .reason = "no_error"};
}

// The dataset of one surface.
Dataset with_psd(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what, Dataset data) {
  const Surface surface = field.read_flat(tool, data);
  const DataWindows windows = what.windows(surface.grid);
  const LagField psd = power_spectrum(surface.heights, surface.grid, windows, tool.thread_count());
  const cli::Inventory before(data);
  cli::drop_results(data, "psd", surface.variable);
  write(data, "psd", over_both_signs(psd, surface.grid), surface, "power spectral density of the field");
  describe(data, surface, windows);
  data.attributes.set("psd_relative_error", 1);
  data.attributes.set("psd_degrees_of_freedom", 2);
  before.tell(tool, data, "psd");
  return data;
}

// That of several: the mean, with errors by the spread between them.
Dataset mean_psd(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                 cli::EnsembleInput& surfaces, const cli::Several& several) {
  struct One {
    Surface surface;  ///< without its heights
    Field psd;
  } last;
  cli::EnsembleField psd;
  int number = 0;
  surfaces.for_each(
      tool,
      [&](const cli::EnsembleMember& member) {
        Surface surface = field.read_flat(tool, member.data);
        const Field heights = std::move(surface.heights);
        const LagField one =
            power_spectrum(heights, surface.grid, what.windows(surface.grid), tool.thread_count());
        Field both = over_both_signs(one, surface.grid);
        return One{std::move(surface), std::move(both)};
      },
      [&](One&& one, const std::string&) {
        psd.add(one.psd);
        last = std::move(one), ++number;
      },
      several);
  const Surface& surface = last.surface;
  Dataset out;
  set_grid(out, surface.grid);
  write(out, "psd", psd.mean(), surface, "mean power spectral density of the surfaces");
  write(out, "psd_error", psd.standard_error(), surface, "standard error of the mean power spectral density");
  describe(out, surface, what.windows(surface.grid));
  out.attributes.set("psd_surfaces", number);
  cli::tell_interval(tool, number);
  return out;
}

// None of one grid.
std::optional<Common> common_to(const std::vector<Grid>& grids, const std::vector<double>& areas) {
  if (std::ranges::all_of(grids, [&](const Grid& one) { return cli::same_grid(grids[0], one); })) return {};
  Grid finest = grids[0];
  for (const Grid& grid : grids)
    finest.dx = std::min(finest.dx, grid.dx), finest.dy = std::min(finest.dy, grid.dy);
  std::vector<Reach> rings, x, y;
  for (const Grid& grid : grids) {
    rings.push_back(reach_of_rings(grid, finest));
    x.push_back(reach_along(Axis1D::x, grid, finest)), y.push_back(reach_along(Axis1D::y, grid, finest));
  }
  return Common{CommonWaveNumbers(rings), CommonWaveNumbers(x), CommonWaveNumbers(y), areas, finest};
}

std::optional<Common> common_to(const cli::Tool& tool, const std::string& variable,
                                cli::EnsembleInput& surfaces) {
  std::vector<Grid> grids;
  std::vector<double> areas;
  surfaces.for_each(
      tool,
      [&](const cli::EnsembleMember& member) {
        const Grid grid = grid_of(member.data);
        return std::pair{grid, measured_area(field_of(member.data, variable, Missing::not_a_number), grid)};
      },
      [&](const std::pair<Grid, double>& one, const std::string&) {
        grids.push_back(one.first), areas.push_back(one.second);
      });
  return common_to(grids, areas);
}

int print_tables(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                 cli::EnsembleInput& surfaces) {
  std::optional<Common> common;
  cli::Several several{.variable = field.variable};
  if (what.result.result == "scales") {
    several.on_one_grid = "the mean at each scale";
  } else if (surfaces.resolve(tool) > 1) {
    common = common_to(tool, field.variable, surfaces);
    several.of_sizes = several.of_spacings =
        "each wave number is pooled over the surfaces that resolve it, by their areas";
  }
  if (common && tool.given("--tip-radius"))
    throw cli::UsageError("tip-radius", "marks wave numbers of one grid, but those of the surfaces differ");
  return cli::print_table(
      tool, surfaces, several, &content_of,
      [&](const cli::EnsembleMember& member) {
        return table(tool, what, field.read_flat(tool, member.data), member.alone(), common);
      },
      common ? common->areas : std::vector<double>{});
}

int measure(cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
            cli::EnsembleInput& surfaces) {
  what.check(tool);
  if (!what.result.dataset()) return print_tables(tool, field, what, surfaces);
  const cli::Several several{
      .variable = field.variable,
      .on_one_grid = "the mean at each wave number, unless --result radial or profiles pools them,"};
  Dataset data = surfaces.resolve(tool) == 1 ? with_psd(tool, field, what, surfaces.only(tool))
                                             : mean_psd(tool, field, what, surfaces, several);
  tool.write(data);
  return cli::done;
}

void declare(cli::Tool& tool, Options& what) {
  what.result.declare(
      tool,
      "Write the dataset, or print profiles, rings or scales. dataset: with the PSD added; profiles: the "
      "mean PSD of the profiles along x, and along y; radial: the mean over rings of wave "
      "numbers; scales: rms heights, slopes and curvatures (second derivatives) along x and y, at octaves of "
      "scale: of the waves from one wavelength to twice of it (band_height, band_slope, band_curvature), of "
      "patches as long as the scale about lines through them (patch_height), and of differences over it "
      "(distance_slope, distance_curvature)");
  tool.choice("--window", what.window, {"auto", "none", "hann"},
              "Window function; auto: Hann's, or none if the field is periodic", "Estimate");
  tool.quantity(
      "--tip-radius", what.tip_radius, "m",
      "Radius of the tip that scanned the surface. Scales that it falsifies are told, and have no "
      "error: those below the length at which a second difference is no lower than -1/2 of the tip's "
      "curvature (Sanner et al. 2022)",
      "Estimate");
  tool.table();
  tool.output();
  tool.threads();
  tool.essential({"--result", "--window", "--tip-radius", "--variable", "--remove-form", "--lambda-s",
                  "--lambda-c", "--json", "--output", "--threads", "--from"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-psd --result "
      "radial");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-psd",
      "Measures the power spectral density (PSD) of a surface and adds it to the dataset: psd over "
      "wave_number_x >= 0 and wave_number_y of both signs, in m4, is (dx dy)^2 / (Lx Ly) |transform|^2 "
      "with a window of mean square 1. --result radial prints its mean over rings of wave numbers; "
      "--result profiles prints the PSD of the profiles, in m3; --result scales rms heights, slopes and "
      "curvatures by scale. For several surfaces each is the mean over "
      "them, "
      "with the standard error by their spread, of surfaces - 1 degrees of freedom of Student's t, and the "
      "spread expected from the errors of the single surfaces, and none where a bias of all of them exceeds "
      "it; the dataset then holds psd, psd_error and the attributes, but no heights.");
  cli::EnsembleInput inputs;
  cli::FieldOptions options;
  Options what;
  inputs.declare(tool);
  options.declare_field(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] { return measure(tool, options, what, inputs); });
}
