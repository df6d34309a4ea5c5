/// Computes the stress below a loaded surface: in layers, in a section, at points, and where it is largest.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/stopwatch.hpp"
#include "core/words.hpp"
#include "stress/maximum.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/progress.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/section.hpp"
#include "tools/stress/points.hpp"
#include "tools/stress/writer.hpp"

using namespace asperity;

namespace {

constexpr double round_off = 1e-12;  // of a pressure that is balanced to it

// `layers`: those of a dataset follow.
StressMaximum search(const cli::Tool& tool, const StressSolver& volume, bool layers) {
  cli::Progress progress(tool, layers ? 0.5 : 1);
  cli::StepTable probes(tool, {"layer", "depth [um]", "greatest von_mises [MPa]"});
  return maximum_von_mises(volume, [&](const StressProbe& p) {
    progress.count(static_cast<double>(p.done), static_cast<double>(p.expected), "layers searched");
    probes.row({std::to_string(p.done), fmt::format("{:.6g}", p.depth * 1e6),
                fmt::format("{:.6g}", p.von_mises * 1e-6)});
  });
}

void warn_if_shallow(const cli::Tool& tool, const LoadedBody& body, const StressMaximum& maximum) {
  const auto& [grid, pressure, poisson, friction] = body;
  const double accurate = accurate_depth(grid), spread = pressure.maxCoeff() - pressure.minCoeff();
  const bool uniform = grid.periodic && spread <= round_off * pressure.maxCoeff();  // at any depth
  if (maximum.depth >= accurate || uniform) return;
  tool.warn(
      fmt::format("the largest von Mises stress lies {:.4g} um deep, less than the {:.4g} um of "
                  "stress_accurate_depth: it rests on single cells and may be off by {:.0f} % of the largest "
                  "pressure; refine the grid",
                  maximum.depth * 1e6, accurate * 1e6, 100 * shallow_error(poisson, friction)));
}

// A maximum in the outermost cells has no parabola through it and stays at their centres.
bool at_end(double place, double first, double last) {
  return first != last && (place == first || place == last);
}

void warn_if_at_edge(const cli::Tool& tool, const Grid& grid, const StressMaximum& maximum) {
  const auto [nx, ny] = grid.shape;
  if (grid.periodic ||
      !(at_end(maximum.x, grid.x(0), grid.x(nx - 1)) || at_end(maximum.y, grid.y(0), grid.y(ny - 1))))
    return;
  tool.warn(
      fmt::format("the largest von Mises stress lies at the edge of the domain, at ({:.4g}, {:.4g}) um, and "
                  "may be larger "
                  "beyond it; choose a larger domain",
                  maximum.x * 1e6, maximum.y * 1e6));
}

// In whole layers.
StressMaximum find_maximum(const cli::Tool& tool, cli::StressScene& scene, const StressSolver& solver) {
  const StressMaximum top = search(tool, solver, !scene.depths.empty());
  Attributes& a = scene.data.attributes;
  a.set("stress_max_von_mises", top.von_mises);
  a.set("stress_max_x", top.x);
  a.set("stress_max_y", top.y);
  a.set("stress_max_depth", top.depth);
  tool.detail(fmt::format("largest von Mises stress {:.6g} MPa, {:.6g} um deep, from {}",
                          top.von_mises * 1e-6, top.depth * 1e6, counted(top.layers, "layer")));
  if (top.von_mises == 0) return top;
  warn_if_shallow(tool, scene.body, top);
  warn_if_at_edge(tool, scene.body.grid, top);
  return top;
}

void compute(cli::Tool& tool, const cli::StressOptions& options, const cli::StressSelection& selection) {
  cli::StressScene scene = cli::read_scene(tool, options);
  const Stopwatch clock;
  const cli::Inventory before(scene.data);
  cli::drop_results(scene.data, "stress");

  const auto threads = tool.thread_count();
  const bool through_maximum = cli::through_maximum(options.section);
  std::optional<StressSolver> solver;
  if (!scene.plane) solver.emplace(scene.body, std::nullopt, threads, scene.resolution);
  double largest = 0;  // von Mises stress
  if (options.maximum || through_maximum) {
    const StressMaximum top =
        solver ? find_maximum(tool, scene, *solver)
               : find_maximum(tool, scene, StressSolver(scene.body, threads, scene.resolution));
    largest = top.von_mises;
    if (through_maximum) cli::cut(scene, options.section, {top.x, top.y});
  }
  if (scene.plane) solver.emplace(scene.body, scene.plane, threads, scene.resolution);
  cli::record_parameters(scene);
  auto record_time = [&](Attributes& a) { a.set("stress_seconds", cli::on_record(clock.seconds())); };
  record_time(scene.data.attributes);

  if (scene.depths.empty()) {
    tool.write(scene.data);
  } else {
    cli::StressWriter writer(tool, scene, selection, *solver);
    writer.write(record_time);
    largest = std::max(largest, writer.largest("von_mises"));
  }
  before.tell(tool, scene.data, "stress");
  cli::warn_of_yield(tool, scene, largest);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress",
                 "Computes the elastic stress below a loaded surface: in layers, in a section, at points, "
                 "and where it is largest.");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depths 0:0.8mm:32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "The stress below a pressure constant in each cell is exact to 1e-14; for a periodic contact, the "
      "stress of the "
      "waves through the cells' pressures, with a body held at its sides under the mean pressure. Layers ten "
      "cells "
      "deep and more are exact to 2e-6 of the maximum pressure, or in full with --resolution full; --points "
      "of a free "
      "contact to 4e-13 of their stress at any distance. With n cells across a Hertz contact the largest von "
      "Mises "
      "stress errs by 0.95/n^2. From two cells' depth on, every value is within 1 % of the maximum pressure, "
      "with "
      "friction up to 0.5. Above that depth, cells within two cells of an edge of the contact may be off by "
      "9 %, for "
      "Poisson's ratios nu below 0.1 by 11 (1 - 2 nu) %, and by 26 % of the friction more; a maximum there "
      "rests on "
      "single cells: compare stress_max_depth with stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    const cli::StressSelection selection(options.components);
    options.points.empty() ? compute(tool, options, selection) : cli::print_points(tool, options, selection);
    return cli::done;
  });
}
