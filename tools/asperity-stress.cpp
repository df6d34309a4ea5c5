/// Computes the stress below a loaded surface, layer by layer, and where it is largest.
#include <cmath>
#include <limits>
#include <sstream>

#include <fmt/format.h>

#include "cli/tool.hpp"
#include "dataset/layout.hpp"
#include "grid/stopwatch.hpp"
#include "stress/maximum.hpp"
#include "stress/von_mises.hpp"

using namespace asperity;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Options {
  double depth = none;
  int layers = 32;
  std::string spacing = "uniform", depths, components = "von_mises";
  double poisson = none;
  int body = 1;
  bool no_maximum = false;
  std::string resolution = "adapted";
};

/// What is written: some components, and von Mises, which needs all of them to be computed.
struct Selection {
  stress::Set components;
  bool von_mises = false;

  stress::Set computed() const { return von_mises ? stress::all : components; }
};

void declare(cli::Tool& tool, Options& o) {
  const std::string depths = "Depths", content = "Content", body = "Body";
  tool.input();
  CLI::Option* depth = tool.quantity("--depth", o.depth, "m", "Depth of the lowest layer", depths);
  CLI::Option* layers =
      tool.integer("--layers", o.layers, 1, "Layers, the first at the surface, the last at --depth", depths);
  CLI::Option* spacing = tool.choice("--spacing", o.spacing, {"uniform", "geometric"},
                                     "Steps between layers; geometric starts half a cell deep", depths);
  tool.text("--depths", o.depths, "LENGTH,...", "The depths themselves, increasing", depths)
      ->excludes(depth)
      ->excludes(layers)
      ->excludes(spacing);
  tool.choice("--resolution", o.resolution, {"adapted", "full"},
              "Deep layers from wider cells, within 2e-6 of the largest pressure; or every one in full",
              depths);
  tool.text("--components", o.components, "LIST", "Of von_mises, xx, yy, zz, xy, xz, yz; or all", content);
  tool.flag("--no-maximum", o.no_maximum, "Do not search for the largest von Mises stress", content);
  tool.number("--poisson", o.poisson, "Poisson's ratio, instead of the dataset's", body);
  tool.integer("--body", o.body, 1, "Which body's ratio to take from the dataset, 1 or 2", body);
  tool.output();
  tool.report();
  tool.threads();
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

Selection selection(const Options& o) {
  Selection chosen;
  for (const std::string& word : split(o.components)) {
    const auto name = std::find(stress::names.begin(), stress::names.end(), word);
    if (word == "all")
      chosen = {stress::all, true};
    else if (word == "von_mises")
      chosen.von_mises = true;
    else if (name != stress::names.end())
      chosen.components.set(static_cast<std::size_t>(name - stress::names.begin()));
    else
      throw cli::UsageError("components",
                            fmt::format("'{}' is none of von_mises, xx, yy, zz, xy, xz, yz, all", word));
  }
  return chosen;
}

std::vector<double> listed_depths(const std::string& list) {
  std::vector<double> depths;
  for (const std::string& word : split(list)) {
    const double z = cli::parse_quantity("depths", word, "m");
    if (!(z >= 0) || (!depths.empty() && z <= depths.back()))
      throw cli::UsageError("depths", fmt::format("{} is not below the depth before it", word));
    depths.push_back(z);
  }
  return depths;
}

std::vector<double> depths_of(const Options& o, const Grid& grid) {
  if (!o.depths.empty()) return listed_depths(o.depths);
  if (std::isnan(o.depth)) throw cli::UsageError("depth", "is needed, or --depths");
  const bool geometric = o.spacing == "geometric";
  const double first = geometric ? 0.5 * std::min(grid.dx, grid.dy) : 0;
  if (!(o.depth > first && std::isfinite(o.depth)))
    throw cli::UsageError("depth", fmt::format("{} m is not below the first layer, {} m", o.depth, first));
  std::vector<double> depths(static_cast<std::size_t>(o.layers), o.depth);
  for (std::size_t k = 0; k + 1 < depths.size(); ++k) {
    const double t = static_cast<double>(k) / (o.layers - 1);
    depths[k] = geometric ? first * std::pow(o.depth / first, t) : o.depth * t;
  }
  return depths;
}

double poisson_of(const Options& o, const Dataset& data) {
  if (!std::isnan(o.poisson)) return o.poisson;
  const Values* recorded = data.attributes.find("contact_poisson");
  if (recorded == nullptr)
    throw cli::UsageError("poisson", "is needed: the dataset has no attribute contact_poisson");
  const std::vector<double> both = numbers(*recorded);
  if (o.body > static_cast<int>(both.size()))
    throw cli::UsageError("body",
                          fmt::format("{}: the dataset knows Poisson's ratio of {}", o.body, both.size()));
  return both[static_cast<std::size_t>(o.body - 1)];
}

/// The layers as volumes [z][x][y], by name in the dataset.
struct Volumes {
  std::array<std::vector<double>, 6> components;
  std::vector<double> von_mises;
};

Volumes compute(const StressSolver& solver, const std::vector<double>& depths, const Selection& chosen) {
  const Shape shape = solver.grid().shape;
  const auto points = depths.size() * static_cast<std::size_t>(shape.cells());
  Volumes out;
  for (auto c : stress::components) out.components[c].resize(chosen.components[c] ? points : 0);
  out.von_mises.resize(chosen.von_mises ? points : 0);
  solver.layers(depths, chosen.computed(), [&](Index l, Index i, const StressRow& row) {
    const Index at = (l * shape.nx + i) * shape.ny;
    for (auto c : stress::components)
      if (chosen.components[c]) std::copy_n(row[c], shape.ny, out.components[c].data() + at);
    if (chosen.von_mises) von_mises(row, shape.ny, out.von_mises.data() + at);
  });
  return out;
}

/// Replaces every former volume.
void record_volumes(Dataset& data, const std::vector<double>& depths, const Selection& chosen,
                    Volumes volumes) {
  data.erase("von_mises");
  for (auto name : stress::names) data.erase(fmt::format("stress_{}", name));
  set_depths(data, depths);
  if (chosen.von_mises)
    set_volume(data, "von_mises", std::move(volumes.von_mises), {"Pa", "von Mises equivalent stress"});
  for (auto c : stress::components)
    if (chosen.components[c])
      set_volume(data, fmt::format("stress_{}", stress::names[c]), std::move(volumes.components[c]),
                 {"Pa", fmt::format("stress {}, positive in tension", stress::names[c])});
}

void record_maximum(Attributes& a, const StressMaximum& m) {
  a.set("stress_max_von_mises", m.von_mises);
  a.set("stress_max_x", m.x);
  a.set("stress_max_y", m.y);
  a.set("stress_max_depth", m.depth);
}

std::string told(const StressMaximum& m, const Grid& grid) {
  const bool shallow = m.depth < accurate_depth(grid);
  return fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {} layers{}",
                     m.von_mises * 1e-6, m.depth * 1e6, m.layers,
                     shallow ? ": less than two cells, where it rests on single cells of the pressure" : "");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress", "Computes the stress below a loaded surface, and where it is largest");
  Options options;
  declare(tool, options);
  tool.example("asperity-stress --depth 0.8mm --layers 32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "Exact to 1e-14 for a pressure constant in each cell, to 2e-6 of its largest value where layers are\n"
      "  16 cells deep and more, unless --resolution full; on n cells across a Hertz contact the\n"
      "  largest von Mises stress errs by 0.95/n^2. From two cells' depth on every value is within 1 % of\n"
      "  the largest pressure; above it, cells within two cells of an edge of the contact may not be, and\n"
      "  a maximum rests on single cells: compare stress_max_depth with stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    const Selection chosen = selection(options);
    Dataset data = tool.read();
    const Grid grid = grid_of(data);
    const std::vector<double> depths = depths_of(options, grid);
    const double poisson = poisson_of(options, data);

    const Stopwatch clock;
    const StressSolver solver(
        grid, field_of(data, "pressure"), poisson, tool.thread_count(),
        options.resolution == "full" ? DepthResolution::full : DepthResolution::adapted);
    Volumes volumes = compute(solver, depths, chosen);
    for (const char* name : {"stress_max_von_mises", "stress_max_x", "stress_max_y", "stress_max_depth"})
      data.attributes.erase(name);
    if (!options.no_maximum) {
      const StressMaximum top = maximum_von_mises(solver);
      record_maximum(data.attributes, top);
      tool.detail(told(top, grid));
    }

    data.attributes.set("stress_poisson", poisson);
    data.attributes.set("stress_resolution", options.resolution);
    data.attributes.set("stress_accurate_depth", accurate_depth(grid));
    data.attributes.set("stress_seconds", clock.seconds());
    record_volumes(data, depths, chosen, std::move(volumes));
    tool.write(data);
    return cli::done;
  });
}
