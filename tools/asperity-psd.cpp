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
#include "tools/measure/psd_tables.hpp"

using namespace asperity;

namespace {

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
            {"wave_number_x", 0, step(surface.grid.size_x()), cli::per_length, "wave number in x"},
            {"wave_number_y", -(half_plane.cols() / 2), step(surface.grid.size_y()), cli::per_length,
             "wave number in y"},
            {cli::density_units(surface.units, 2), meaning});
}

void describe(Dataset& data, const Surface& surface, const DataWindows& windows) {
  data.attributes.set("psd_variable", surface.variable);
  data.attributes.set("psd_window", windows.x == DataWindow::hann ? "hann" : "none");
}

cli::Table table(const cli::Tool& tool, const Options& what, Surface surface, bool alone,
                 const std::optional<cli::CommonSpectra>& common) {
  const DataWindows windows = what.windows(surface.grid);
  const bool flat = surface.flat;
  const double least = flat ? 0 : least_scale(tool, what, surface, alone);
  const Sample sample = flat ? stand_in(surface) : Sample(std::move(surface), tool.thread_count());
  const std::string& result = what.result.result;
  if (common) {
    if (flat)
      throw DataError("heights", "a surface is flat, and the grids differ: leave it out, its density is 0");
    return (result == "profiles" ? cli::common_profiles : cli::common_radial)(sample, windows, *common);
  }
  cli::Table out = (result == "profiles" ? cli::profile_psds
                    : result == "radial" ? cli::radial_psd
                                         : cli::scale_table)(sample, windows, least);
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

std::optional<cli::CommonSpectra> common_to(const cli::Tool& tool, const std::string& variable,
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
  return cli::common_spectra(grids, areas);
}

int print_tables(const cli::Tool& tool, const cli::FieldOptions& field, const Options& what,
                 cli::EnsembleInput& surfaces) {
  std::optional<cli::CommonSpectra> common;
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
      tool, surfaces, several, &cli::psd_content,
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
