/// Computes the stress below a loaded surface: in layers, in a section, at points, and where it is largest.
#include <algorithm>
#include <optional>

#include "core/stopwatch.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/section.hpp"
#include "tools/stress/maximum.hpp"
#include "tools/stress/writer.hpp"

using namespace asperity;

namespace {

void compute(cli::Tool& tool, cli::StressOptions& options, const cli::StressSelection& selection) {
  cli::StressScene scene = cli::read_scene(tool, options);
  const StressSearch search = cli::search_of(options, scene.body.grid);
  std::optional<cli::RecordedContact> loading;
  if (options.adds("grid_errors")) loading = cli::loading_contact(scene.data, tool.thread_count());
  const Stopwatch clock;
  const cli::Inventory before(scene.data);
  cli::drop_results(scene.data, "stress");

  double largest = 0;    // von Mises stress
  bool shallow = false;  // as a warning of the maximum said
  if (options.maximum || cli::through_maximum(options.section)) {
    const StressMaximum top = cli::find_maximum(tool, scene, search);
    if (search.of == Criterion::von_mises) largest = top.value;
    shallow = cli::is_shallow(scene.body, top.depth);
    if (loading && top.value > 0) cli::record_grid_errors(tool, scene, *loading, search, top);
    if (cli::through_maximum(options.section)) cli::cut(scene, options.section, {top.x, top.y});
  }
  cli::record_parameters(scene);
  auto finish = [&](double in_layers) {
    scene.data.attributes.set("stress_seconds", cli::on_record(clock.seconds()));
    before.tell(tool, scene.data, "stress");
    cli::warn_of_yield(tool, scene, std::max(largest, in_layers));
    tool.record_warnings(scene.data.attributes, "stress_");
  };
  if (scene.depths.empty()) {
    finish(0);
    return tool.write(scene.data);
  }
  scene.data.attributes.set("stress_seconds", 0.0);
  const auto solver = scene.solver(scene.body, scene.plane, tool.thread_count());
  cli::StressWriter writer(tool, scene, selection, *solver);
  if (!shallow) cli::warn_of_shallow_layers(tool, scene);
  writer.write([&] { finish(writer.largest("von_mises")); });
}

cli::Several several_stresses() {
  return {.on_one_grid = "the mean over surfaces", .go_on = cli::Several::GoOn::after_bad_data};
}

// A row for each of several surfaces.
int print_maxima(const cli::Tool& tool, cli::StressOptions& options) {
  return cli::print_rows(tool, options.surfaces, several_stresses(),
                         {.prefix = "stress_", .achieved = {"accurate_depth"}, .places = {"max_x", "max_y"}},
                         [&](cli::EnsembleMember&& member) {
                           cli::StressScene scene = cli::scene_of(options, std::move(member.data));
                           cli::drop_results(scene.data, "stress");
                           const StressSearch search = cli::search_of(options, scene.body.grid);
                           const StressMaximum top = cli::find_maximum(tool, scene, search);
                           cli::record_parameters(scene);
                           if (search.of == Criterion::von_mises) cli::warn_of_yield(tool, scene, top.value);
                           return cli::SurfaceResults{std::move(scene.data.attributes)};
                         });
}

// A row for each depth, of several surfaces with the mean.
int print_maxima_by_depth(const cli::Tool& tool, cli::StressOptions& options) {
  const auto content_of = [&](const cli::Table&) {
    return cli::EnsembleTable::Content{.keys = {"depth"}, .value = options.of};
  };
  return cli::print_table(
      tool, options.surfaces, several_stresses(), content_of, [&](cli::EnsembleMember&& member) {
        return cli::maxima_of(tool, options, cli::scene_of(options, std::move(member.data), tool.ranks()));
      });
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-stress",
      "Computes the elastic stress below a loaded surface: in layers, in a section, at points, "
      "and where it is largest. Of several surfaces --maximum prints a table: a row for each, then "
      "the mean, its standard error and the spread between them, of surfaces - 1 degrees of freedom "
      "of Student's t; and --result maxima the mean at "
      "each depth.");
  cli::StressOptions options;
  options.declare(tool);
  tool.example("asperity-stress --depths 0:0.8mm:32 --components von_mises,zz pressed.nc -o stress.nc");

  return tool.run(argc, argv, [&] {
    options.check(tool);
    const cli::StressSelection selection(options.components);
    if (options.several() && options.maximum) return print_maxima(tool, options);
    if (options.result == "maxima") return print_maxima_by_depth(tool, options);
    options.points.empty() ? compute(tool, options, selection) : cli::print_points(tool, options, selection);
    return int{cli::done};
  });
}
