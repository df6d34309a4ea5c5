#include "tools/measure/twin_options.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/words.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/quantity.hpp"
#include "tools/measure/acf_result.hpp"

namespace asperity::cli {
namespace {

void refuse_beside_map(const Tool& tool) {
  refuse_model(tool, "like");
  for (const char* option : {"acf", "psd", "kernel"})
    if (tool.given(std::string("--") + option)) throw UsageError(option, "cannot be combined with --like");
}

void refuse_without_map(const Tool& tool) {
  for (const char* option :
       {"variable", "remove-form", "lambda-s", "lambda-c", "from", "channel", "from-order"})
    if (tool.given(std::string("--") + option)) throw UsageError(option, "needs --like");
}

// --size is that of the twins.
Dataset read_map(const Tool& tool, const std::string& name) try {
  return tool.read(name);
} catch (const DataError& error) {
  if (std::string_view(error.what()).find("`size`") == std::string_view::npos) throw;
  throw DataError(error.name, "the file does not give the size of the map: asperity-convert --size adds it");
}

void tell(const Tool& tool, const std::string& map, const AcfResult& of, const std::string& unit) {
  const bool gaussian = std::string_view(of.marginal) == "gaussian";
  const std::string sq = format_quantity(std::stod(number(std::sqrt(of.estimate.variance))), unit);
  tool.note(fmt::format("twins of {}: Sq {} as the taper weights it, {} (Ssk {:.2g}, Sku {:.2g})",
                        map == "-" ? "standard input" : map, sq,
                        gaussian ? "Gaussian heights are not excluded" : "heights evidently not Gaussian",
                        of.moments.ssk, of.moments.sku));
}

// Of tables as large as twice the surface, no more than two at a time.
void add_tapered_acf(const Tool& tool, const std::string& map, Dataset& data, Surface surface) {
  const AcfResult result = tapered_acf(surface, longest_lags(surface.grid), tool.thread_count());
  tell(tool, map, result, surface.units);
  warn_of_taper(tool, surface, result);
  surface.heights.resize(0, 0);
  drop_surface(data, "kernel");  // the map's results are not missed in its twins
  add_acf(data, result, {}, {surface.variable, surface.units, false, taper_of(surface.grid)});
}

}  // namespace

void TwinOptions::declare(Tool& tool) {
  tool.text(
      "--like", like, "FILE",
      "Draw twins of this surface, of any format: surfaces of its size and spacing with its autocorrelation "
      "(asperity-acf --taper), and its distribution of heights if that evidently is not Gaussian. A twin is "
      "homogeneous and without phase: it has the spectrum of scratches and feed marks, not the marks; "
      "asperity-stats MAP TWIN... --compare shows what it lacks. - is standard input",
      "Autocorrelation");
  map.declare_preparation(tool, "Map of --like");
  tool.input_format();
}

std::optional<AcfTable> TwinOptions::table(const Tool& tool, GenerateOptions& generate) const {
  if (!tool.given("--like")) return refuse_without_map(tool), std::nullopt;
  refuse_beside_map(tool);
  Dataset data = read_map(tool, like);
  tool.reads(like);  // no output replaces the map
  Surface surface = map.read(tool, data);
  const bool periodic = surface.grid.periodic.both();
  if (periodic && tool.given("--shape") && generate.shape != surface.grid.shape)
    throw UsageError("shape", text(generate.shape) + ": the map is periodic and its twins have its period, " +
                                  text(surface.grid.shape));
  generate.periodic = generate.periodic || periodic;
  add_tapered_acf(tool, like, data, std::move(surface));
  AcfTable out = acf_table_of(std::move(data));
  drop_results(out.dataset, "acf");
  return out;
}

}  // namespace asperity::cli
