/// Computes the stress below a loaded surface: in layers, in a section, at points, and where it is largest.
#include <algorithm>

#include <fmt/format.h>

#include "core/stopwatch.hpp"
#include "core/words.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/stream.hpp"
#include "tools/stress/record.hpp"
#include "tools/stress/warning.hpp"
#include "tools/stress/writer.hpp"

using namespace asperity;

namespace {

std::string told(const StressMaximum& m) {
  return fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {}", m.von_mises * 1e-6,
                     m.depth * 1e6, counted(m.layers, "layer"));
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

// 0 where the table has no such column.
double largest_in(const cli::Table& table, const std::string& name) {
  double top = 0;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    for (const auto& row : table.rows)
      if (table.columns[k].name == name) top = std::max(top, std::get<double>(row[k]));
  return top;
}

int tabulate(const cli::Tool& tool, const cli::StressOptions& options,
             const cli::StressSelection& selection) {
  tool.reads(options.points);
  const cli::Bytes text = cli::read_all(options.points, tool.memory_bound());
  const auto points = cli::parse_points(text, tool.memory_bound(2 * text.size()));
  const cli::StressScene scene = cli::read_scene(tool, options);
  const cli::Table table = cli::stress_table(scene, selection, points, tool.thread_count());
  cli::print(tool, table);
  cli::warn_of_points(tool, scene, points);
  cli::warn_of_yield(tool, scene.data.attributes, largest_in(table, "von_mises"));
  return cli::done;
}

int compute(cli::Tool& tool, const cli::StressOptions& options, const cli::StressSelection& selection) {
  cli::StressScene scene = cli::read_scene(tool, options);
  const Stopwatch clock;
  const cli::Inventory before(scene.data);
  cli::drop_results(scene.data, "stress");
  double largest = 0;  // von Mises stress
  if (options.maximum) {
    const StressMaximum top = search(tool, scene.solver(options, tool.thread_count()));
    cli::record_maximum(scene.data.attributes, top);
    tool.detail(told(top));
    cli::warn_of_place(tool, scene, top);
    largest = top.von_mises;
  }
  cli::record_parameters(scene, options);
  auto finish = [&](Attributes& a) { a.set("stress_seconds", cli::on_record(clock.seconds())); };
  finish(scene.data.attributes);
  if (scene.depths.empty()) {
    tool.write(scene.data);
  } else {
    cli::StressWriter writer(tool, scene, selection, options);
    writer.write(finish);
    largest = std::max(largest, writer.largest("von_mises"));
  }
  before.tell(tool, scene.data, "stress");
  cli::warn_of_yield(tool, scene.data.attributes, largest);
  return cli::done;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress", "Computes the stress below a loaded surface, and where it is largest");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depths 0:0.8mm:32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "Exact to 1e-14 for a pressure constant in each cell, of a periodic contact for the waves through the "
      "cells' pressures, the mean of which a body held at its sides bears; to 2e-6 of its largest value "
      "where "
      "layers are ten cells deep and more, unless --resolution full; at --points of a free contact to 4e-13 "
      "of "
      "their stress however far they lie. On n cells across a Hertz contact the largest von Mises stress "
      "errs "
      "by 0.95/n^2. From two cells' depth on every value is within 1 % of the largest pressure, friction up "
      "to "
      "0.5 included; above it, cells within two cells of an edge of the contact may be off by 9 %, of a "
      "Poisson's ratio nu below 0.1 by 11 (1 - 2 nu) %, and by 26 % of the friction more, and a maximum "
      "rests "
      "on single cells: compare stress_max_depth with stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    const cli::StressSelection selection(options.components);
    return options.points.empty() ? compute(tool, options, selection) : tabulate(tool, options, selection);
  });
}
