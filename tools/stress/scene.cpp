#include "tools/stress/scene.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/series.hpp"

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

// A share of Hertz's pressure, where the smooth bodies have one, else of the largest pressure.
double least_value(const StressOptions& o, const Dataset& data, const Field& pressure) {
  if (std::isnan(o.above)) return 0;
  return o.above * data.attributes.number("contact_hertz_pressure", pressure.abs().maxCoeff());
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
  scene.grid = grid_of(scene.data);
  scene.depths = depths_on(scene.grid, options.depths);
  scene.plane = plane_on(scene.grid, options.section);
  scene.friction = options.sliding();
  scene.poisson = options.poisson_of(scene.data);
  scene.pressure = field_of(scene.data, "pressure", "Pa");
  refuse_tension(scene.pressure);
  scene.least = least_value(options, scene.data, scene.pressure);
  return scene;
}

}  // namespace asperity::cli
