#include "stress_options.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/series.hpp"
#include "stress_quantity.hpp"

namespace asperity::cli {
namespace {

std::vector<double> listed_depths(const std::string& list) {
  std::vector<double> depths;
  for (const std::string& word : split(list, ',')) {
    const double z = parse_quantity("depths", word, "m");
    if (!(z >= 0) || (!depths.empty() && z <= depths.back()))
      throw UsageError("depths", fmt::format("{} is not below the depth before it", word));
    depths.push_back(z);
  }
  return depths;
}

}  // namespace

void StressOptions::declare(Tool& tool) {
  const std::string where = "Depths", content = "Content", which = "Body", load = "Friction";
  tool.input();
  CLI::Option* lowest = tool.quantity("--depth", depth, "m", "Depth of the lowest layer", where);
  CLI::Option* count =
      tool.integer("--layers", layers, 1, "Layers, the first at the surface, the last at --depth", where);
  CLI::Option* steps = tool.choice("--spacing", spacing, {"uniform", "geometric"},
                                   "Steps between layers; geometric starts half a cell deep", where);
  tool.text("--depths", depths, "LENGTH,...", "The depths themselves, increasing", where)
      ->excludes(lowest)
      ->excludes(count)
      ->excludes(steps);
  tool.choice("--resolution", resolution, {"adapted", "full"},
              "Deep layers from wider cells, within 2e-6 of the largest pressure; or every one in full",
              where);
  tool.text("--components", components, "LIST", "Of " + stress_words() + "; or all", content);
  tool.flag("--no-maximum", no_maximum, "Do not search for the largest von Mises stress", content);
  tool.number("--poisson", poisson, "Poisson's ratio, instead of the dataset's", which);
  tool.integer("--body", body, 1, "Which body's ratio to take from the dataset, 1 or 2", which);
  CLI::Option* slides =
      tool.number("--friction", friction,
                  "Coefficient of friction: a traction of so much of the pressure acts too", load);
  tool.text("--friction-angle", friction_angle, "ANGLE",
            "Its direction from x towards y, in which the other body slides: 30, 30deg, 0.5rad", load)
      ->needs(slides);
  tool.output();
  tool.report();
  tool.threads();
}

std::vector<double> StressOptions::depths_on(const Grid& grid) const {
  if (!depths.empty()) return listed_depths(depths);
  if (std::isnan(depth)) throw UsageError("depth", "is needed, or --depths");
  const bool geometric = spacing == "geometric";
  const double first = geometric ? 0.5 * std::min(grid.dx, grid.dy) : 0;
  if (!(depth > first && std::isfinite(depth)))
    throw UsageError("depth", fmt::format("{} m is not below the first layer, {} m", depth, first));
  std::vector<double> out(static_cast<std::size_t>(layers), depth);
  for (std::size_t k = 0; k + 1 < out.size(); ++k) {
    const double t = static_cast<double>(k) / (layers - 1);
    out[k] = geometric ? first * std::pow(depth / first, t) : depth * t;
  }
  return out;
}

double StressOptions::poisson_of(const Dataset& data) const {
  if (!std::isnan(poisson)) return poisson;
  const Values* recorded = data.attributes.find("contact_poisson");
  if (recorded == nullptr)
    throw UsageError("poisson", "is needed: the dataset has no attribute contact_poisson");
  const std::vector<double> both = numbers(*recorded);
  if (body > static_cast<int>(both.size()))
    throw UsageError("body", fmt::format("{}: the dataset knows Poisson's ratio of {}", body, both.size()));
  return both[static_cast<std::size_t>(body - 1)];
}

Friction StressOptions::sliding() const {
  const Friction out{friction, parse_angle("friction-angle", friction_angle)};
  out.check();
  return out;
}

}  // namespace asperity::cli
