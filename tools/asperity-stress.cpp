/// Computes the stress below a loaded surface: in layers, in a section, at points, and where it is largest.
#include <algorithm>

#include "core/stopwatch.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/record.hpp"
#include "tools/stress/points.hpp"
#include "tools/stress/search.hpp"
#include "tools/stress/writer.hpp"

using namespace asperity;

namespace {

void compute(cli::Tool& tool, const cli::StressOptions& options, const cli::StressSelection& selection) {
  cli::StressScene scene = cli::read_scene(tool, options);
  const Stopwatch clock;
  const cli::Inventory before(scene.data);
  cli::drop_results(scene.data, "stress");

  const StressSolver solver = scene.solver(tool.thread_count());
  double largest = 0;  // von Mises stress
  if (options.maximum) largest = cli::search_maximum(tool, scene, solver).von_mises;
  cli::record_parameters(scene);
  auto record_time = [&](Attributes& a) { a.set("stress_seconds", cli::on_record(clock.seconds())); };
  record_time(scene.data.attributes);

  if (scene.depths.empty()) {
    tool.write(scene.data);
  } else {
    cli::StressWriter writer(tool, scene, selection, solver);
    writer.write(record_time);
    largest = std::max(largest, writer.largest("von_mises"));
  }
  before.tell(tool, scene.data, "stress");
  cli::warn_of_yield(tool, scene, largest);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool("asperity-stress", "Computes the stress below a loaded surface, and where it is largest");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depths 0:0.8mm:32 --components von_mises,zz pressed.nc -o stress.nc");
  tool.accuracy(
      "Exact to 1e-14 for a pressure constant in each cell, of a periodic contact for the waves through "
      "the cells' pressures, the mean of which a body held at its sides bears; to 2e-6 of its largest "
      "value where layers are ten cells deep and more, unless --resolution full; at --points of a free "
      "contact to 4e-13 of their stress however far they lie. On n cells across a Hertz contact the "
      "largest von Mises stress errs by 0.95/n^2. From two cells' depth on every value is within 1 % of "
      "the largest pressure, friction up to 0.5 included; above it, cells within two cells of an edge of "
      "the contact may be off by 9 %, of a Poisson's ratio nu below 0.1 by 11 (1 - 2 nu) %, and by 26 % of "
      "the friction more, and a maximum rests on single cells: compare stress_max_depth with "
      "stress_accurate_depth.");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    const cli::StressSelection selection(options.components);
    options.points.empty() ? compute(tool, options, selection) : cli::print_points(tool, options, selection);
    return cli::done;
  });
}
