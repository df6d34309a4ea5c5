/// Computes the stress below a loaded surface, layer by layer, and where it is largest.
#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "grid/stopwatch.hpp"
#include "stress_record.hpp"

using namespace asperity;

namespace {

std::string told(const StressMaximum& m, const Grid& grid) {
  const bool shallow = m.depth < accurate_depth(grid);
  return fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {} layers{}",
                     m.von_mises * 1e-6, m.depth * 1e6, m.layers,
                     shallow ? ": less than two cells, where it rests on single cells of the pressure" : "");
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress", "Computes the stress below a loaded surface, and where it is largest");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depth 0.8mm --layers 32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "Exact to 1e-14 for a pressure constant in each cell, to 2e-6 of its largest value where layers are\n"
      "  16 cells deep and more, unless --resolution full; on n cells across a Hertz contact the\n"
      "  largest von Mises stress errs by 0.95/n^2. From two cells' depth on every value is within 1 % of\n"
      "  the largest pressure; above it, cells within two cells of an edge of the contact may not be, and\n"
      "  a maximum rests on single cells: compare stress_max_depth with stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    const cli::StressSelection selection(options.components);
    const Friction friction = options.sliding();
    Dataset data = tool.read();
    const Grid grid = grid_of(data);
    const std::vector<double> depths = options.depths_on(grid);
    const double poisson = options.poisson_of(data);

    const Stopwatch clock;
    const StressSolver solver(grid, field_of(data, "pressure"), friction, poisson, tool.thread_count(),
                              options.depth_resolution());
    cli::forget_stress(data);
    cli::record_volumes(data, solver, depths, selection);
    if (!options.no_maximum) {
      const StressMaximum top = maximum_von_mises(solver);
      cli::record_maximum(data.attributes, top);
      tool.detail(told(top, grid));
    }
    cli::record_parameters(data.attributes, options, solver);
    data.attributes.set("stress_seconds", clock.seconds());
    tool.write(data);
    return cli::done;
  });
}
