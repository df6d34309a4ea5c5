// Measured maps made ready: level, filter, fill, cut, resample.
#include <algorithm>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "dataset/units.hpp"
#include "tools/cli/ensemble_input.hpp"
#include "tools/cli/heights_words.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/stream.hpp"
#include "tools/cli/turns.hpp"
#include "tools/filter/chain.hpp"
#include "tools/measure/preparation_words.hpp"

using namespace asperity;

namespace {

Surface surface_of(const Dataset& data, const std::string& variable) {
  return {.grid = grid_of(data),
          .heights = field_of(data, variable, Missing::not_a_number),
          .degree = cli::removed_degree(data, variable),
          .filled = cli::filled_share(data, variable),
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

class Filter {
 public:
  Filter(cli::Tool& tool, const std::string& variable) : tool_(tool), variable_(variable), chain_(tool) {}

  int operator()(cli::EnsembleInput& surfaces) {
    if (const std::size_t of = surfaces.resolve(tool_); of > 1) claim(surfaces, of);
    surfaces.for_each(
        tool_, [&](cli::EnsembleMember&& member) { visit(std::move(member)); },
        [&](const std::string&, const std::string& why) { fail(why, cli::bad_data); });
    return code_;
  }

 private:
  // Before the work: no output is one of the inputs.
  void claim(const cli::EnsembleInput& surfaces, std::size_t of) {
    for (std::size_t k = 1; k <= of; ++k) tool_.writes("output", output(k, of));
    for (const std::string& file : surfaces.files) tool_.reads(file);
  }
  std::string output(std::size_t number, std::size_t of) const {
    const std::string name = tool_.output_name();
    const bool several = of > 1 || cli::has_place_for_number(name);
    return several ? cli::numbered("output", name, static_cast<std::int64_t>(number)) : name;
  }
  void fail(const std::string& why, int code) {
    tool_.warn(why);
    cli::in_turn([this, code] { code_ = std::max(code_, code); });
  }
  // Of several maps, one that fails does not keep the others.
  void visit(cli::EnsembleMember&& member) {
    if (!member.alone()) tool_.detail(member.name);
    try {
      write(member.data, output(member.number, member.of));
    } catch (const DataError& error) {
      if (member.alone()) throw;
      fail(tool_.in_file(error), cli::bad_data);
    } catch (const cli::UsageError& error) {  // a step that this map cannot take
      if (member.alone()) throw;
      fail(member.name + ": --" + error.name + ": " + error.what(), cli::usage_error);
    }
  }
  void write(Dataset& data, const std::string& name) {
    Surface surface = surface_of(data, variable_);
    auto [lines, converged] = chain_(tool_, surface);
    cli::warn_of_proportions(tool_, Proportions(surface.heights, surface.grid), surface.units);
    const int degree = surface.degree;
    const double filled = surface.filled;
    if (!is_map_of(data, surface)) replace(tool_, data, std::move(surface));
    cli::set_preparation(data, degree, filled);
    tool_.write(data, name, lines);
    if (!converged) cli::in_turn([this] { code_ = std::max<int>(code_, cli::not_converged); });
  }

  cli::Tool& tool_;
  const std::string& variable_;
  const cli::Chain chain_;
  int code_ = cli::done;
};

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
  return tool.run(argc, argv, [&] { return Filter(tool, variable)(surfaces); });
}
