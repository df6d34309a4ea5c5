#include "tools/stress/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "contact/energy.hpp"
#include "core/error.hpp"
#include "core/poisson.hpp"
#include "core/words.hpp"
#include "dataset/layout.hpp"
#include "dataset/unread.hpp"
#include "tools/cli/section.hpp"

namespace asperity::cli {
namespace {

constexpr double round_off = 1e-12;  // of a pressure that is balanced to it

std::vector<double> depths_on(const Grid& grid, const std::string& text) {
  if (text.empty()) return {};
  return parse_series("depths", text, Steps::uniform,
                      [&](const std::string& word) { return depth_on(grid, "depths", word, farthest); });
}

// From the options, else from the dataset.
double poisson_of(const StressOptions& o, const Dataset& data) {
  if (!std::isnan(o.poisson)) return o.poisson;
  const Values* recorded = data.attributes.find("contact_poisson");
  if (recorded == nullptr)
    throw UsageError("poisson", "is required: the dataset has no attribute contact_poisson");
  const std::vector<double> both = numbers(*recorded);
  if (std::holds_alternative<std::string>(*recorded) || both.empty() || both.size() > 2)
    throw DataError("contact_poisson", "it must be one number, or one for each body");
  if (o.body > static_cast<int>(both.size()))
    throw UsageError("body", fmt::format("{}: the dataset has one Poisson's ratio only", o.body));
  const double out = both[static_cast<std::size_t>(o.body - 1)];
  if (!is_poisson_ratio(out))
    throw DataError("contact_poisson", fmt::format("{} must lie above -1 and not above 0.5", out));
  return out;
}

// A component of the strain in all layers, or nothing.
std::optional<std::vector<double>> strain_of(const Dataset& data, const std::string& name,
                                             std::size_t values) {
  const Variable* found = data.find(name);
  if (found == nullptr) return std::nullopt;
  if (found->dimensions != std::vector<std::string>{"layer", "x", "y"})
    throw DataError(name, "it must lie on (layer, x, y), as asperity-contact writes it");
  Variable whole = *found;
  load(whole);
  std::vector<double> out = numbers(whole.values);
  if (out.size() != values)
    throw DataError(name,
                    "it does not fit contact_layer_edges and the grid; it was cropped or changed since");
  if (!std::ranges::all_of(out, [](double v) { return std::isfinite(v); }))
    throw DataError(name, "holds a value that is not a finite number");
  return out;
}

// Of a body, by its number in the contact, if that has flown.
std::shared_ptr<const ResidualStress> residual_of(const Dataset& data, const Grid& grid, double poisson,
                                                  const StressOptions& options) {
  const Values* recorded = data.attributes.find("contact_layer_edges");
  if (recorded == nullptr) return nullptr;
  auto of_body = [&](const char* name) {
    const Values* both = data.attributes.find(name);
    const std::vector<double> all = both ? numbers(*both) : std::vector<double>();
    if (all.size() != 2)
      throw DataError(name, "it must be a number for each body, as asperity-contact writes it");
    return all[size(options.body - 1)];
  };
  if (!std::isfinite(of_body("contact_yield"))) return nullptr;
  const std::vector<double> edges = numbers(*recorded);
  if (edges.size() < 3 || edges.front() != 0 || !std::ranges::is_sorted(edges, std::less_equal<>()))
    throw DataError("contact_layer_edges", "it must rise from 0");
  const Index layers = std::ssize(edges) - 1, cells = grid.shape.cells();
  const bool counter = options.body == 2 && data.has("plastic_strain_counter_xx");
  constexpr double copies_read = 3 * sizeof(double);  // of one component
  options.memory.require(
      ResidualStress::memory(grid.shape, edges) + copies_read * static_cast<double>(layers * cells),
      "plastic_strain");
  LayeredField strain(layers, deviator::components, grid.shape);
  for (const stress::Component c : stress::components) {
    const std::string name =
        (counter ? "plastic_strain_counter_" : "plastic_strain_") + std::string(stress::names[c]);
    const auto values = strain_of(data, name, size(layers * cells));
    if (!values)
      throw DataError(name,
                      "the dataset has contact_layer_edges, but not this strain of the body that flows");
    const deviator::Vector weights = deviator::of(c);
    for (Index k = 0; k < layers; ++k)
      for (Index d = 0; d < deviator::components; ++d)
        if (weights[size(d)] != 0)
          strain(k, d) += weights[size(d)] *
                          Eigen::Map<const Field>(values->data() + k * cells, grid.shape.nx, grid.shape.ny);
  }
  return std::make_shared<ResidualStress>(grid, edges, strain, of_body("contact_young"), poisson,
                                          options.threads);
}

// In rows from `first` on.
void refuse_tension(const Field& pressure, Index first) {
  Index i = 0, j = 0;
  if (pressure.size() == 0) return;
  if (const double least = pressure.minCoeff(&i, &j); least < 0)
    throw DataError("pressure",
                    fmt::format("at point ({}, {}) it is {}, but a contact has no tension: change the sign "
                                "if it is a compression, or set tension to 0",
                                first + i, j, format_quantity(least, "Pa")));
}

}  // namespace

double depth_on(const Grid& grid, const std::string& option, const std::string& text, double deepest) {
  const double z = text == "0" ? 0 : parse_length(option, text).metres(std::min(grid.dx, grid.dy));
  if (!(z >= 0 && z <= deepest))
    throw UsageError(option, fmt::format("'{}' is not a depth from 0 to {:g} m", text, deepest));
  return z;
}

double place_of(const Plane& plane, const Grid& grid) {
  return plane.along_x ? grid.y(plane.index) : grid.x(plane.index);
}

void cut(StressScene& scene, const std::string& section, std::array<double, 2> maximum) {
  const CellRow row =
      section_row(scene.body.grid, section, [&](bool along_x) { return maximum[along_x ? 1 : 0]; });
  scene.plane = Plane{row.along_x, row.index};
}

StressScene read_scene(const Tool& tool, StressOptions& options) {
  return scene_of(options, options.surfaces.only(tool), tool.ranks());
}

StressScene scene_of(const StressOptions& options, Dataset data, const Ranks& ranks) {
  StressScene scene;
  scene.data = std::move(data);
  auto& [grid, pressure, poisson, friction, shared] = scene.body;
  grid = grid_of(scene.data);
  scene.depths = depths_on(grid, options.depths);
  if (!options.section.empty() && !through_maximum(options.section)) cut(scene, options.section, {});
  friction = {options.friction, parse_angle("friction-angle", options.friction_angle)};
  friction.check();
  shared = &shared_rows(grid.shape, ranks).ranks();
  const Extent own = scene.body.rows().own();
  agree(*shared, [&] { scene.body.pressure = field_of(scene.data, "pressure", "Pa", own); });
  poisson = poisson_of(options, scene.data);
  agree(*shared, [&] { refuse_tension(scene.body.pressure, own.first); });
  if (!options.above.empty())
    scene.least = StressBound(options.above).in(scene.data, [&] { return scene.body.largest(); });
  scene.resolution = options.resolution == "full" ? DepthResolution::full : DepthResolution::adapted;
  if (scene.data.attributes.find("contact_layer_edges") == nullptr) return scene;
  if (ranks.count() > 1)
    throw UsageError("body",
                     fmt::format("has flown: its residual stress cannot be computed by {} ranks; start one "
                                 "process",
                                 ranks.count()));
  scene.residual = residual_of(scene.data, grid, poisson, options);
  return scene;
}

void record_parameters(StressScene& scene) {
  const auto& [grid, pressure, poisson, friction, ranks] = scene.body;
  Attributes& a = scene.data.attributes;
  a.set("stress_poisson", poisson);
  a.set("stress_resolution", scene.resolution == DepthResolution::full ? "full" : "adapted");
  a.set("stress_accurate_depth", accurate_depth(grid));
  a.set("stress_friction", friction.coefficient);
  if (friction.coefficient > 0) a.set("stress_friction_angle", friction.angle);
  if (scene.least > 0) a.set("stress_above", scene.least);
  if (scene.plane)
    a.set(scene.plane->along_x ? "stress_section_y" : "stress_section_x", place_of(*scene.plane, grid));
}

bool at_limit_pressure(const Dataset& contact, const LoadedBody& body) {
  constexpr double none = std::numeric_limits<double>::infinity();
  return body.largest() >= contact.attributes.number("contact_limit_pressure", none);
}

bool is_shallow(const LoadedBody& body, double depth) {
  const double largest = body.largest();
  const bool uniform = body.grid.periodic.both() && largest - body.least() <= round_off * largest;
  return depth < accurate_depth(body.grid) && !uniform;
}

void warn_of_shallow_layers(const Tool& tool, const StressScene& scene) {
  const auto shallow =
      std::ranges::count_if(scene.depths, [&](double z) { return is_shallow(scene.body, z); });
  if (shallow == 0) return;
  tool.warn(fmt::format(
      "{} of {} lie less than {:.4g} um deep, the stress_accurate_depth: within two cells of an edge of the "
      "contact their stress may be off by {:.0f} % of the maximum pressure; refine the grid, or leave them "
      "out",
      shallow, counted(static_cast<Index>(scene.depths.size()), "layer"),
      accurate_depth(scene.body.grid) * 1e6, 100 * shallow_error(scene.body.poisson, scene.body.friction)));
}

std::unique_ptr<StressSolver> StressScene::solver(const LoadedBody& of, const std::optional<Plane>& section,
                                                  int threads) const {
  auto out = std::make_unique<StressSolver>(of, section, threads, resolution);
  out->add(residual);
  return out;
}

double StressScene::yield_stress() const {
  constexpr double none = std::numeric_limits<double>::infinity();
  return data.attributes.number("contact_limit_pressure", none) / hardness;
}

void warn_of_yield(const Tool& tool, const StressScene& scene, double von_mises) {
  const double yield = scene.yield_stress();
  if (!(von_mises > yield)) return;
  tool.warn(fmt::format(
      "von Mises stress reaches {:.4g} MPa, above the yield stress of {:.4g} MPa, a third of "
      "contact_limit_pressure: this is the elastic stress below that pressure, without plastic flow, which "
      "asperity-contact --plasticity j2 computes",
      von_mises * 1e-6, yield * 1e-6));
}

}  // namespace asperity::cli
