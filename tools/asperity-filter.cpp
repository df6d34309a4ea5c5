// Measured maps made ready: level, filter, fill, cut, resample.
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/filter/chain.hpp"
#include "tools/measure/preparation_words.hpp"

using namespace asperity;

namespace {

Surface surface_of(const Dataset& data, const std::string& variable) {
  return {.grid = grid_of(data),
          .heights = field_of(data, variable, Missing::not_a_number),
          .degree = cli::removed_degree(data, variable),
          .filled = cli::filled_share(data, variable),
          .aligned = cli::aligned_share(data, variable),
          .variable = variable,
          .units = si_unit_of(data.at(variable))};
}

// The map takes the place of the former one.
void replace(const cli::Tool& tool, Dataset& data, Surface surface) {
  Map map{.values = std::move(surface.heights),
          .spacing = {surface.grid.dx, surface.grid.dy},
          .units = surface.units,
          .title = data.at(surface.variable).attributes.text("long_name"),
          .periodic = surface.grid.periodic};
  cli::replace_surface(tool, data, map);
}

// Steps that have changed nothing, such as no outliers, drop nothing.
bool is_map_of(const Dataset& data, const Surface& surface) {
  if (surface.variable != (surface.units == "m" ? "heights" : "values")) return false;
  const Surface now = surface_of(data, surface.variable);
  const bool same_grid = now.grid.shape == surface.grid.shape && now.grid.dx == surface.grid.dx &&
                         now.grid.dy == surface.grid.dy && now.grid.periodic == surface.grid.periodic;
  return same_grid &&
         ((now.heights == surface.heights) || (now.heights.isNaN() && surface.heights.isNaN())).all();
}

std::string output_for(const cli::Tool& tool, std::size_t number, std::size_t of) {
  const std::string name = tool.output_name();
  const bool several = of > 1 || cli::has_place_for_number(name);
  return several ? cli::numbered("output", name, static_cast<std::int64_t>(number)) : name;
}

// Before the work: no output is one of the inputs.
void claim_outputs(cli::Tool& tool, cli::EnsembleInput& surfaces) {
  const std::size_t of = surfaces.resolve(tool);
  if (of == 1) return;
  std::vector<std::string> outputs;
  for (std::size_t k = 1; k <= of; ++k) outputs.push_back(output_for(tool, k, of));
  surfaces.claim(tool, "output", outputs);
}

// Writes the map; whether its solvers have converged.
bool filter(const cli::Tool& tool, const std::string& variable, const cli::Chain& chain, Dataset data,
            const std::string& output) {
  Surface surface = surface_of(data, variable);
  const auto [lines, converged] = chain(tool, surface);
  cli::warn_of_proportions(tool, Proportions(surface.heights, surface.grid), surface.units);
  const int degree = surface.degree;
  const double filled = surface.filled, aligned = surface.aligned;
  if (!is_map_of(data, surface)) replace(tool, data, std::move(surface));
  cli::set_preparation(data, degree, filled, aligned);
  tool.write(data, output, lines);
  return converged;
}

int filter_all(cli::Tool& tool, cli::EnsembleInput& surfaces, const std::string& variable) {
  const cli::Chain chain(tool);
  claim_outputs(tool, surfaces);
  return surfaces.for_each(
      tool,
      [&](cli::EnsembleMember&& member) {
        const std::string output = output_for(tool, member.number, member.of);
        return filter(tool, variable, chain, std::move(member.data), output);
      },
      [](bool converged, const std::string&) -> int { return converged ? cli::done : cli::not_converged; },
      {.go_on = cli::Several::GoOn::after_any_error});
}

}  // namespace

int main(int argc, char** argv) {
  cli::Tool tool(
      "asperity-filter",
      "Makes a measured map ready: levels, filters, fills, cuts or resamples it. Each option under Form and "
      "waves, Points and Grid is a step; steps run in the order of the command line, and one may come again. "
      "The history of the dataset tells what each did. Missing points stay missing unless they are filled. "
      "Results of the former surface are dropped. Of several maps, --output is a pattern, f_%02d.nc.");
  cli::EnsembleInput surfaces;
  std::string variable = "heights";
  surfaces.declare(tool);
  tool.text("--variable", variable, "NAME", "Field on (x, y) to read; it becomes the map", "Input");
  cli::Chain::declare(tool);
  tool.output();
  tool.threads();
  tool.example(
      "asperity-filter map.x3p --remove-form plane --outliers 5 --fill laplace --lambda-s 8um --lambda-c "
      "0.8mm | asperity-stats");
  tool.essential({"INPUT", "--remove-form", "--lambda-s", "--lambda-c", "--outliers", "--fill", "--crop",
                  "--rotate", "--output"});
  return tool.run(argc, argv, [&] { return filter_all(tool, surfaces, variable); });
}
