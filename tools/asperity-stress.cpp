/// Computes the stress below a loaded surface: in layers, in a section, at points, and where it is largest.
#include <fmt/format.h>

#include "cli/lineage.hpp"
#include "cli/progress.hpp"
#include "cli/record.hpp"
#include "cli/stream.hpp"
#include "grid/stopwatch.hpp"
#include "stress_record.hpp"
#include "stress_writer.hpp"

using namespace asperity;

namespace {

std::string told(const StressMaximum& m, const Grid& grid) {
  const bool shallow = m.depth < accurate_depth(grid);
  return fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {} layers{}",
                     m.von_mises * 1e-6, m.depth * 1e6, m.layers,
                     shallow ? ": less than two cells, where it rests on single cells of the pressure" : "");
}

StressMaximum search(const cli::Tool& tool, const StressSolver& solver) {
  cli::Progress progress(tool);
  cli::StepTable probes(tool, {"layer", "depth [um]", "greatest von_mises [MPa]"});
  return maximum_von_mises(solver, [&](const StressProbe& p) {
    progress.count(static_cast<double>(p.done), static_cast<double>(p.expected), "layers of the search");
    probes.row({std::to_string(p.done), fmt::format("{:.6g}", p.depth * 1e6),
                fmt::format("{:.6g}", p.von_mises * 1e-6)});
  });
}

int tabulate(const cli::Tool& tool, const cli::StressOptions& options,
             const cli::StressSelection& selection) {
  const auto points = cli::parse_points(cli::read_all(options.points));
  const cli::StressScene scene = cli::read_scene(tool, options);
  const cli::Table table = cli::stress_table(scene, selection, points, tool.thread_count());
  cli::print(tool, table);
  return cli::done;
}

int compute(cli::Tool& tool, const cli::StressOptions& options, const cli::StressSelection& selection) {
  cli::StressScene scene = cli::read_scene(tool, options);
  const Stopwatch clock;
  const cli::Inventory before(scene.data);
  cli::drop_results(scene.data, "stress");
  if (options.maximum) {
    const StressMaximum top = search(tool, scene.solver(options, tool.thread_count()));
    cli::record_maximum(scene.data.attributes, top);
    tool.detail(told(top, scene.grid));
  }
  cli::record_parameters(scene, options);
  auto finish = [&](Attributes& a) { a.set("stress_seconds", cli::on_record(clock.seconds())); };
  finish(scene.data.attributes);
  if (scene.depths.empty())
    tool.write(scene.data);
  else
    cli::StressWriter(tool, scene, selection, options).write(finish);
  before.tell(tool, scene.data, "stress");
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress", "Computes the stress below a loaded surface, and where it is largest");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depths 0:0.8mm:32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "Exact to 1e-14 for a pressure constant in each cell, to 2e-6 of its largest value where layers are "
      "ten cells deep and more, unless --resolution full; at --points to 4e-13 of their stress however far "
      "they lie. On n cells across a Hertz contact the largest von Mises stress errs by 0.95/n^2. From two "
      "cells' depth on every value is within 1 % of the largest pressure, friction up to 0.5 included; above "
      "it, cells within two cells of an edge of the contact may be off by 9 %, and by 26 % of the friction "
      "more, and a maximum rests on single cells: compare stress_max_depth with stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    const cli::StressSelection selection(options.components);
    return options.points.empty() ? compute(tool, options, selection) : tabulate(tool, options, selection);
  });
}
