#include "tools/contact/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dataset/layout.hpp"
#include "tools/cli/lineage.hpp"
#include "transform/refinement.hpp"

namespace asperity::cli {
namespace {

constexpr Index finest = 16;  // times the given cells

// The largest error of a result, relative to it; NaN where none is known.
double largest_error(const Contact& c, const GridFigures& figures) {
  const GridErrors& e = figures.errors;
  double out = e.max_pressure / c.max_pressure;
  for (const auto& [error, value] : {std::pair{e.load, c.load},
                                     {e.approach, c.approach},
                                     {e.area_corrected, figures.area_corrected},
                                     {e.stiffness, c.stiffness}})
    if (std::isfinite(error) && std::isfinite(value)) out = std::max(out, std::abs(error / value));
  return out;
}

ContactScene finer(const ContactScene& given, const ContactOptions& o, Index factor) {
  const Shape times{factor, factor};
  const Field rough = undeformed_gap(given.grid, o.bodies) - given.gap;
  Dataset data = given.data;
  drop_surface(data, "kernel");  // whose lengths count in the given samples
  const Grid grid = refined_grid(given.grid, times);
  set_grid(data, grid);
  if (!o.smooth) {
    const Field heights = refined(field_of(given.data, o.variable, "m"), given.grid, times);
    set_field(data, o.variable, heights, {"m", given.data.at(o.variable).attributes.text("long_name")});
  }
  const Field gap = undeformed_gap(grid, o.bodies) - refined(rough, given.grid, times);
  return scene_with(o, std::move(data), grid, gap);
}

std::string why_not(const ContactScene& scene, const Contact& contact, const GridFigures& figures) {
  if (!contact.converged) return "the contact does not converge";
  if (scene.growth.resolved() == Resolved::no)
    return "the grid does not resolve the surface, whose slope grows with every finer one";
  return figures.unknown;
}

}  // namespace

Accurate press_accurately(const Tool& tool, const ContactOptions& options, ContactScene& scene,
                          Influence& influence) {
  const ContactScene given = scene;
  for (Index factor = 1;; factor *= 2) {
    if (factor > 1) scene = finer(given, options, factor);
    Accurate out{press(options, scene, influence), {}};
    const auto& [contact, figures, doubts] = out.pressed;
    const double error = largest_error(contact, figures);
    const std::string cells = text(scene.grid.shape);
    tool.detail(fmt::format("{} cells: errors of the grid up to {:.2g} %", cells, 100 * error));
    scene.data.attributes.set("contact_accuracy", options.accuracy);
    scene.data.attributes.set("contact_refinement", static_cast<double>(factor));
    if (error <= options.accuracy) return out;
    out.unreached = why_not(given, contact, figures);
    const Shape next{2 * scene.grid.shape.nx, 2 * scene.grid.shape.ny};
    if (out.unreached.empty() && (factor == finest || !fits(tool, next)))
      out.unreached =
          fmt::format("on {} cells, {} times the given ones a side, errors are still up to {:.2g} %", cells,
                      factor, 100 * error);
    if (!out.unreached.empty()) return out;
  }
}

}  // namespace asperity::cli
