// Power spectral densities of a surface, of its profiles, and over rings.
#include <numbers>

#include "dataset/layout.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "tools/cli/grid_words.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/field_options.hpp"

using namespace asperity;

namespace {

struct Options {
  std::string window = "auto";
  cli::ResultOption result{{"profiles", "radial"}};

  DataWindows windows(const Grid& grid) const {
    if (window == "auto") return default_windows(grid);
    const DataWindow both = window == "hann" ? DataWindow::hann : DataWindow::none;
    return {both, both};
  }
};

// "m3" or "m4" for heights, "Pa2 m" or "Pa2 m2" for a pressure.
std::string density_units(const Surface& surface, int lengths) {
  if (surface.units == "m") return cli::unit_to(surface.units, 2 + lengths);
  const std::string length = lengths == 1 ? "m" : "m" + std::to_string(lengths);
  return surface.units == "1" ? length : cli::unit_to(surface.units, 2) + " " + length;
}

constexpr const char* per_length = "rad m-1";

cli::Table radial(const Surface& surface, const LagField& psd, const DataWindows& windows) {
  const double inflation = spectrum_inflation(surface.heights, windows);
  const std::string unit = density_units(surface, 2);
  cli::Table out{{{"wave_number", per_length},
                  {"psd", unit},
                  {"standard_error", unit, cli::Holds::unknown},
                  {"count", "1"}},
                 {}};
  for (const SpectrumPoint& ring : radial_spectrum(psd, surface.grid, inflation))
    out.rows.push_back({ring.wave_number, ring.density, ring.standard_error, ring.count});
  if (out.rows.empty())
    throw DataError("heights",
                    "no ring of wave numbers fits a field of " + cli::described(surface.grid) +
                        ": its shorter side is below twice the larger spacing; use --result profiles or "
                        "--result dataset");
  return out;
}

cli::Table profiles(const Surface& surface, const DataWindows& windows, int threads) {
  const std::string unit = density_units(surface, 1);
  cli::Table out{{{"direction", ""},
                  {"wave_number", per_length},
                  {"psd", unit},
                  {"standard_error", unit, cli::Holds::unknown}},
                 {}};
  auto add = [&](const char* direction, Axis1D axis, DataWindow window) {
    for (const SpectrumPoint& point : profile_spectrum(surface.heights, surface.grid, axis, window, threads))
      out.rows.push_back({direction, point.wave_number, point.density, point.standard_error});
  };
  add("x", Axis1D::x, windows.x);
  add("y", Axis1D::y, windows.y);
  return out;
}

void add_to(Dataset& data, const Surface& surface, const LagField& psd, const std::string& variable,
            const std::string& window) {
  cli::drop_results(data, "psd", variable);
  const auto step = [](double size) { return 2 * std::numbers::pi / size; };
  set_table(data, "psd", psd.half_plane(),
            {"wave_number_x", 0, step(surface.grid.size_x()), per_length, "wave number in x"},
            {"wave_number_y", -psd.max_q(), step(surface.grid.size_y()), per_length, "wave number in y"},
            {density_units(surface, 2), "power spectral density of the field"});
  data.attributes.set("psd_variable", variable);
  data.attributes.set("psd_window", window);
}

void declare(cli::Tool& tool, Options& what) {
  what.result.declare(
      tool,
      "Write the dataset, or print profiles or rings. dataset: with the PSD added; profiles: the "
      "mean PSD of the profiles along x, and along y; radial: the mean over rings of wave "
      "numbers");
  tool.choice("--window", what.window, {"auto", "none", "hann"},
              "Window function; auto: Hann's, or none if the field is periodic", "Estimate");
  tool.input();
  tool.table();
  tool.output();
  tool.threads();
  tool.essential({"--result", "--window", "--variable", "--remove-form", "--lambda-s", "--lambda-c", "--json",
                  "--output", "--threads", "--from"});
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-psd --result "
      "radial");
  tool.accuracy(
      "Without a window the PSD adds up to Sq squared to round-off: sum / (Lx Ly) over all wave numbers of "
      "both signs, or sum / L for a profile. Standard errors hold for a Gaussian field and allow for the "
      "correlation that a window causes between neighbouring wave numbers. Wave numbers are 2 pi / "
      "wavelength. Missing points are set to the mean, and the sum is divided by the squared window over "
      "the other points: a share g of scattered holes adds about g Sq^2 dx dy at every wave number.");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-psd",
      "Measures the power spectral density (PSD) of a surface and adds it to the dataset: psd over "
      "wave_number_x >= 0 and wave_number_y of both signs, in m4, is (dx dy)^2 / (Lx Ly) |transform|^2 "
      "with a window of mean square 1. --result radial prints its mean over rings of wave numbers; "
      "--result profiles prints the PSD of the profiles, in m3.");
  cli::FieldOptions options;
  Options what;
  options.declare_field(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] {
    what.result.check(tool);
    Dataset data = tool.read();
    const Surface surface = options.read(tool, data);
    const DataWindows windows = what.windows(surface.grid);
    if (what.result.result == "profiles") {
      cli::print(tool, profiles(surface, windows, tool.thread_count()));
      return cli::done;
    }
    const LagField psd = power_spectrum(surface.heights, surface.grid, windows, tool.thread_count());
    if (!what.result.dataset()) {
      cli::print(tool, radial(surface, psd, windows));
      return cli::done;
    }
    const cli::Inventory before(data);
    add_to(data, surface, psd, options.variable, windows.x == DataWindow::hann ? "hann" : "none");
    before.tell(tool, data, "psd");
    tool.write(data);
    return cli::done;
  });
}
