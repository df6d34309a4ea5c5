#include "tools/stress/warning.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "contact/flattening.hpp"

namespace asperity::cli {
namespace {

constexpr double round_off = 1e-12;  // of a pressure that is balanced to it

// A maximum in the outermost cells has no parabola and stays at their centres.
bool at_end(double place, double first, double last) { return place == first || place == last; }

}  // namespace

void warn_of_yield(const Tool& tool, const Attributes& contact, double von_mises) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double yield = contact.number("contact_limit_pressure", none) / hardness;
  if (!(von_mises > yield)) return;
  tool.warn(fmt::format(
      "von Mises stress reaches {:.4g} MPa, above the yield stress of {:.4g} MPa, a third of "
      "contact_limit_pressure: it is the elastic stress below that pressure, without plastic flow",
      von_mises * 1e-6, yield * 1e-6));
}

void warn_of_points(const Tool& tool, const StressScene& scene,
                    const std::vector<std::array<double, 3>>& points) {
  const double accurate = accurate_depth(scene.grid);
  const auto shallow = std::ranges::count_if(points, [&](const auto& p) { return p[2] < accurate; });
  if (shallow == 0) return;
  tool.warn(fmt::format(
      "{} of {} points lie less than {:.4g} um deep, which is stress_accurate_depth: their stress is that of "
      "single cells, off by up to {:.0f} % of the largest pressure below a cell's centre, and without a "
      "bound "
      "at the surface towards its edges and corners",
      shallow, points.size(), accurate * 1e6, 100 * shallow_error(scene.poisson, scene.friction)));
}

void warn_of_place(const Tool& tool, const StressScene& scene, const StressMaximum& maximum) {
  if (maximum.von_mises == 0) return;
  const Grid& grid = scene.grid;
  const double accurate = accurate_depth(grid);
  const bool uniform = grid.periodic && scene.pressure.maxCoeff() - scene.pressure.minCoeff() <=
                                            round_off * scene.pressure.maxCoeff();  // at any depth
  if (maximum.depth < accurate && !uniform)
    tool.warn(fmt::format(
        "the largest von Mises stress lies {:.4g} um deep, less than the {:.4g} um of "
        "stress_accurate_depth: it rests on single cells and may be off by {:.0f} % of the largest "
        "pressure; make the cells finer",
        maximum.depth * 1e6, accurate * 1e6, 100 * shallow_error(scene.poisson, scene.friction)));
  const auto [nx, ny] = grid.shape;
  const bool end_of_x = nx > 1 && at_end(maximum.x, grid.x(0), grid.x(nx - 1)),
             end_of_y = ny > 1 && at_end(maximum.y, grid.y(0), grid.y(ny - 1));
  if (!grid.periodic && (end_of_x || end_of_y))
    tool.warn(fmt::format(
        "the largest von Mises stress lies at the edge of the domain, at ({:.4g}, {:.4g}) um: beyond "
        "it none is looked for; make the domain larger",
        maximum.x * 1e6, maximum.y * 1e6));
}

}  // namespace asperity::cli
