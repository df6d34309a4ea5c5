#include "tools/report/flow.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/conventions.hpp"
#include "dataset/layout.hpp"
#include "stress/equivalent.hpp"
#include "tools/stress/scene.hpp"

namespace asperity::report {
namespace {

struct Body {
  int number;
  const char *strain, *stress, *words;
};
constexpr Body bodies[] = {
    {1, "plastic_strain", "residual_von_mises", ""},
    {2, "plastic_strain_counter", "residual_von_mises_counter", " of the second body"}};

constexpr double bytes_a_cell = 900;  // of a layer, to compute the residual stress

void add(Flow& flow, const Grid& grid, Variable volume, FlowVolume words) {
  const std::vector<double> values = present_numbers(volume);
  const Index layer = grid.shape.cells();
  if (volume.dimensions != std::vector<std::string>{"layer", "x", "y"} || values.empty() ||
      std::ssize(values) != std::ssize(flow.depths) * layer ||
      !std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
    throw DataError(volume.name, "must be numbers on (layer, x, y), as asperity-contact writes it");
  const Index k = std::ranges::max_element(values) - values.begin();
  if (!(values[size(k)] > 0)) return;
  words.variable = volume.name;
  words.largest = values[size(k)];
  words.depth = flow.depths[size(k / layer)];
  words.section = grid.shape.nx < 2 ? "x=0" : fmt::format("y={}m", grid.y(k % grid.shape.ny));
  flow.dataset[0].data.put(std::move(volume));
  flow.volumes.push_back(std::move(words));
}

Variable residual_stress(const cli::Tool& tool, const Dataset& data, const Body& body) {
  const double bytes = bytes_a_cell * static_cast<double>(data.length("layer") * grid_of(data).shape.cells());
  if (bytes > static_cast<double>(tool.memory_bound().bytes))
    throw DataError("residual stress", "needs more than the memory of --memory");
  if (!data.attributes.find("contact_poisson")) throw DataError("contact_poisson", "is missing");
  cli::StressOptions options;
  options.body = body.number;
  options.threads = tool.thread_count();
  const cli::StressScene scene = cli::scene_of(options, data);
  if (!scene.residual) throw DataError("contact_yield", "is infinite, but the body has flown");
  const std::size_t cells = size(scene.body.grid.shape.cells());
  const std::vector<double>& depths = scene.residual->depths();
  Variable out{body.stress, {"layer", "x", "y"}, {}, {}};
  std::vector<double> values(depths.size() * cells);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    std::array<Field, 6> fields;
    StressRow layer;
    for (const stress::Component c : stress::components) {
      fields[c] = scene.residual->layer(depths[k], c);
      layer[c] = {fields[c].data(), cells};
    }
    von_mises(layer, {&values[k * cells], cells});
  }
  out.values = std::move(values);
  out.attributes.set("units", "Pa");
  out.attributes.set("long_name", "residual stress");  // short, beside a bar of colours
  return out;
}

}  // namespace

Flow flow_of(const cli::Tool& tool, const Dataset& data) {
  if (!data.attributes.find("contact_layer_edges")) return {};
  Flow out{.dataset = plot::Cases(1)};
  try {
    const Grid grid = grid_of(data);
    Dataset& shown = out.dataset[0].data;
    set_grid(shown, grid);
    out.depths = present_numbers(shown.put(data.at("layer")));
    shown.set_dimension("layer", std::ssize(out.depths));
    for (const Body& body : bodies) {
      if (!data.has(body.strain)) continue;
      add(out, grid, data.at(body.strain), {std::string("largest plastic strain") + body.words, "1"});
      add(out, grid, residual_stress(tool, data, body),
          {std::string("largest residual von Mises stress") + body.words, "Pa"});
    }
  } catch (const DataError& error) {
    out.unknown = fmt::format("Not all of the flow is shown: {}: {}.", error.name, error.what());
  }
  return out;
}

}  // namespace asperity::report
