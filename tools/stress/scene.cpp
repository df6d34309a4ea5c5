#include "tools/stress/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "contact/flattening.hpp"
#include "core/error.hpp"
#include "core/poisson.hpp"
#include "dataset/layout.hpp"

namespace asperity::cli {
namespace {

std::vector<double> depths_on(const Grid& grid, const std::string& text) {
  if (text.empty()) return {};
  return parse_series("depths", text, Steps::uniform, [&](const std::string& word) {
    const double z = word == "0" ? 0 : parse_length("depths", word).metres(std::min(grid.dx, grid.dy));
    if (!(z >= 0 && z <= farthest)) throw UsageError("depths", "'" + word + "' is no depth, 0 ... 1e30 m");
    return z;
  });
}

// The plane through the cell centres that lie nearest to the place.
std::optional<Plane> plane_on(const Grid& grid, const std::string& text) {
  if (text.empty()) return std::nullopt;
  if (!text.starts_with("x=") && !text.starts_with("y="))
    throw UsageError("section", "'" + text + "' is not of the form y=0 or x=0.2mm");
  const bool along_x = text[0] == 'y';
  const double size = along_x ? grid.size_y() : grid.size_x(), spacing = along_x ? grid.dy : grid.dx;
  const std::string place = text.substr(2);
  const double wanted = place == "0" ? 0 : parse_length("section", place).metres(spacing);
  if (!(std::abs(wanted) <= 0.5 * size))
    throw UsageError("section", "'" + text + "' lies outside: the surface reaches to ±" +
                                    format_quantity(0.5 * size, "m"));
  const auto nearest = static_cast<Index>(std::floor((wanted + 0.5 * size) / spacing));
  return Plane{along_x, std::min(nearest, (along_x ? grid.shape.ny : grid.shape.nx) - 1)};
}

// From the options, else from the dataset.
double poisson_of(const StressOptions& o, const Dataset& data) {
  if (!std::isnan(o.poisson)) return o.poisson;
  const Values* recorded = data.attributes.find("contact_poisson");
  if (recorded == nullptr)
    throw UsageError("poisson", "is needed: the dataset has no attribute contact_poisson");
  const std::vector<double> both = numbers(*recorded);
  if (std::holds_alternative<std::string>(*recorded) || both.empty() || both.size() > 2)
    throw DataError("contact_poisson", "it must be one number, or one of each body");
  if (o.body > static_cast<int>(both.size()))
    throw UsageError("body", fmt::format("{}: the dataset knows Poisson's ratio of {}", o.body, both.size()));
  const double out = both[static_cast<std::size_t>(o.body - 1)];
  if (!is_poisson_ratio(out))
    throw DataError("contact_poisson", fmt::format("{} must lie above -1 and not above 0.5", out));
  return out;
}

// A contact presses and does not pull.
void refuse_tension(const Field& pressure) {
  Index i = 0, j = 0;
  if (const double least = pressure.minCoeff(&i, &j); least < 0)
    throw DataError("pressure",
                    fmt::format("at point ({}, {}) it is {}, and a contact presses only: turn the sign "
                                "where compression is meant, or cut what pulls off at 0",
                                i, j, format_quantity(least, "Pa")));
}

}  // namespace

double place_of(const Plane& plane, const Grid& grid) {
  return plane.along_x ? grid.y(plane.index) : grid.x(plane.index);
}

StressScene read_scene(const Tool& tool, const StressOptions& options) {
  StressScene scene;
  scene.data = tool.read();
  auto& [grid, pressure, poisson, friction] = scene.body;
  grid = grid_of(scene.data);
  scene.depths = depths_on(grid, options.depths);
  scene.plane = plane_on(grid, options.section);
  friction = {options.friction, parse_angle("friction-angle", options.friction_angle)};
  friction.check();
  poisson = poisson_of(options, scene.data);
  pressure = field_of(scene.data, "pressure", "Pa");
  refuse_tension(pressure);
  if (!std::isnan(options.above))  // a share of Hertz's pressure, where the smooth bodies have one
    scene.least =
        options.above * scene.data.attributes.number("contact_hertz_pressure", pressure.abs().maxCoeff());
  scene.resolution = options.resolution == "full" ? DepthResolution::full : DepthResolution::adapted;
  return scene;
}

void record_parameters(StressScene& scene) {
  const auto& [grid, pressure, poisson, friction] = scene.body;
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

void warn_of_yield(const Tool& tool, const StressScene& scene, double von_mises) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double yield = scene.data.attributes.number("contact_limit_pressure", none) / hardness;
  if (!(von_mises > yield)) return;
  tool.warn(fmt::format(
      "von Mises stress reaches {:.4g} MPa, above the yield stress of {:.4g} MPa, a third of "
      "contact_limit_pressure: it is the elastic stress below that pressure, without plastic flow",
      von_mises * 1e-6, yield * 1e-6));
}

}  // namespace asperity::cli
