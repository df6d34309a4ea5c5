#include "tools/stress/several.hpp"

#include <optional>
#include <utility>

#include "dataset/layout.hpp"
#include "tools/cli/ensemble_rows.hpp"
#include "tools/cli/ensemble_table.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/turns.hpp"

namespace asperity::cli {
namespace {

using Use = std::function<void(StressScene& scene, const std::string& name)>;
using Failed = std::function<void(const std::string& name)>;

// Visits the scenes of all surfaces, and tells of those that fail; the exit code.
int for_each_scene(Tool& tool, StressOptions& options, const Use& use, const Failed& failed) {
  EnsembleGrid grids("the mean over surfaces");
  int code = done;
  auto fail = [&](const std::string& name, const std::string& why) {
    tool.warn(why);
    in_turn([&code, &failed, name] {
      code = bad_data;
      failed(name);
    });
  };
  options.surfaces.for_each(
      tool,
      [&](EnsembleMember&& member) {
        tool.detail(member.name);
        grids.add(tool, grid_of(member.data), member.name, "Pa");
        try {
          StressScene scene = scene_of(options, std::move(member.data));
          use(scene, member.name);
        } catch (const DataError& error) {
          fail(member.name, tool.in_file(error));
        }
      },
      fail);
  return code;
}

int print_rows(Tool& tool, StressOptions& options) {
  EnsembleRows rows({.prefix = "stress_", .achieved = {"accurate_depth"}, .places = {"max_x", "max_y"}});
  const int code = for_each_scene(
      tool, options,
      [&](StressScene& scene, const std::string& name) {
        drop_results(scene.data, "stress");
        const StressSearch search = search_of(options, scene.body.grid);
        const StressMaximum top = find_maximum(tool, scene, search);
        record_parameters(scene);
        in_turn([&rows, name, results = scene.data.attributes] { rows.add(name, results, true); });
        if (search.of == Criterion::von_mises) warn_of_yield(tool, scene, top.value);
      },
      [&](const std::string& name) { rows.add_failed(name); });
  print(tool, rows.table());
  return code;
}

int print_layers(Tool& tool, StressOptions& options) {
  EnsembleTable mean({.keys = {"depth"}, .value = options.of});
  const int code = for_each_scene(
      tool, options,
      [&](const StressScene& scene, const std::string& name) {
        in_turn([&mean, name, maxima = maxima_of(tool, options, scene)] { mean.add(maxima, name); });
      },
      [](const std::string&) {});
  if (mean.surfaces() > 0) print(tool, mean.table());
  return code;
}

}  // namespace

int print_several(Tool& tool, StressOptions& options) {
  return options.maximum ? print_rows(tool, options) : print_layers(tool, options);
}

}  // namespace asperity::cli
