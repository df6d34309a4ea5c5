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
  bool radial = false, profiles = false, dataset = false;

  DataWindows windows(const Grid& grid) const {
    if (window == "auto") return default_windows(grid);
    const DataWindow both = window == "hann" ? DataWindow::hann : DataWindow::none;
    return {both, both};
  }
};

// Of heights "m3" or "m4", of a pressure "Pa2 m" or "Pa2 m2".
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
    throw DataError("heights", "no ring of wave numbers fits a field of " + cli::described(surface.grid) +
                                   ": its longest wave along one side is too short for the other side's "
                                   "spacing; --profiles and --dataset have the spectrum");
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
  tool.choice("--window", what.window, {"auto", "none", "hann"},
              "Weight towards the edges; auto: Hann's unless the field is periodic", "Estimate");
  const cli::Option radial =
      tool.flag("--radial", what.radial,
                "Print the mean over rings of wave numbers; so do --json alone and a terminal", "Result");
  const cli::Option profiles = tool.flag("--profiles", what.profiles,
                                         "Print the mean over the profiles along x, and along y", "Result")
                                   .excludes(radial);
  tool.flag("--dataset", what.dataset, "Write the dataset with the PSD added, as into a pipe or a file",
            "Result")
      .excludes(radial)
      .excludes(profiles);
  tool.input();
  tool.table();
  tool.output();
  tool.threads();
  tool.example(
      "asperity-generate --shape 128x128 --size 3mm --rq 0.4um --length 17px,4px | asperity-psd --radial");
  tool.accuracy(
      "Without a window the PSD adds up to Sq squared to round-off: sum / (Lx Ly) over all wave numbers of "
      "both signs, or sum / L of a profile's. Standard errors are those of a Gaussian field and allow for "
      "what a window makes neighbours share. Wave numbers are 2 pi / wavelength. Missing points stand at the "
      "mean and the sum is divided by the window's square over the others: of scattered holes, a share g, g "
      "Sq^2 dx dy leaks into every wave number.");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-psd",
      "The power spectral density of a surface. Passes the dataset on with psd over wave_number_x >= 0 and "
      "wave_number_y of both signs, in m4: (dx dy)^2 / (Lx Ly) |transform|^2, its window of mean square 1. "
      "Or prints its mean over rings, as on a terminal; or that of the profiles, in m3.");
  cli::FieldOptions options;
  Options what;
  options.declare_field(tool);
  declare(tool, what);

  return tool.run(argc, argv, [&] {
    const bool dataset =
        cli::writes_dataset(tool, what.profiles || what.radial, what.dataset, "rings or profiles");
    Dataset data = tool.read();
    const Surface surface = options.read(tool, data);
    const DataWindows windows = what.windows(surface.grid);
    if (what.profiles) {
      cli::print(tool, profiles(surface, windows, tool.thread_count()));
      return cli::done;
    }
    const LagField psd = power_spectrum(surface.heights, surface.grid, windows, tool.thread_count());
    if (!dataset) {
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
