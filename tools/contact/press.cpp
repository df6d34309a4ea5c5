#include "tools/contact/press.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "contact/influence.hpp"
#include "contact/outline.hpp"
#include "contact/stiffness.hpp"
#include "core/stopwatch.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/surface_words.hpp"
#include "transform/refinement.hpp"

namespace asperity::cli {
namespace {

constexpr Index finest = 16;  // times the given cells
constexpr double small_strain = 0.05, accurate_increments = 0.01, coarse_layer = 0.6;

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

ElasticOperator& Influence::on(const Grid& grid) {
  if (!made_ || grid.dx != grid_.dx || grid.dy != grid_.dy || !same_grid(grid, grid_)) {
    made_ =
        make_influence(grid, options_.bodies.composite_modulus(), options_.contact.threads, *options_.ranks);
    reported_ = 0;
  }
  grid_ = grid;
  made_->forget_windows();
  return *made_;
}

double Influence::further_seconds() {
  const double now = made_->setup_seconds();
  return now - std::exchange(reported_, now);
}

std::unique_ptr<Influence> Influences::taken() {
  const std::scoped_lock lock(mutex_);
  if (free_.empty()) return std::make_unique<Influence>(options_);
  std::unique_ptr<Influence> out = std::move(free_.back());
  free_.pop_back();
  return out;
}

void Influences::put_back(std::unique_ptr<Influence> one) {
  const std::scoped_lock lock(mutex_);
  free_.push_back(std::move(one));
}

GridFigures grid_figures(const ContactOptions& options, const ContactScene& scene, ElasticOperator& influence,
                         const Contact& contact) {
  const Grid& grid = scene.grid;
  const Outline around = outline(grid, contact);
  GridFigures out{around.perimeter(grid),
                  corrected_area(grid, contact, around, options.contact.limit_pressure)};
  if (scene.growth.resolved() == Resolved::no || !contact.converged) return out;
  if (const std::string few = too_few_cells(grid, contact); !few.empty()) {
    if (options.adds("grid_errors")) out.unknown = few;
    return out;
  }
  out.errors.area = area_excess(grid, around);
  out.errors.area_corrected = corrected_area_error(grid, contact, around);
  if (!options.adds("grid_errors")) return out;
  const CoarserContacts coarser =
      coarser_contacts(grid, scene.gap, influence, contact, options.contact, options.bodies);
  out.seconds = coarser.seconds;
  out.unknown = coarser.unknown;
  if (coarser.unknown.empty()) out.errors = grid_errors(grid, contact, coarser);
  return out;
}

std::vector<Doubt> doubts(const GridFigures& figures) {
  if (figures.unknown.empty()) return {};
  return {{"has no errors of the grid", "the errors of the grid are not known: " + figures.unknown}};
}

std::shared_ptr<PlasticContact> plastic_path(const ContactOptions& options, const ContactScene& scene,
                                             ElasticOperator& influence) {
  return std::make_shared<PlasticContact>(scene.grid, scene.gap, options.bodies, influence, options.contact,
                                          options.plastic.on(scene.grid));
}

Contact contact_of(const ContactOptions& options, const ContactScene& scene, ElasticOperator& influence,
                   const Flow& flow) {
  Contact out = flow.contact();
  if (!options.contact.stiffness || !out.converged || !(out.load > 0)) return out;
  const Stiffness found =
      contact_stiffness(influence, out.pressure, options.contact.limit_pressure, scene.grid.cell_area(),
                        options.contact.max_convolutions, options.contact.threads);
  out.stiffness = found.value;
  out.stiffness_residual = found.residual;
  return out;
}

std::vector<Doubt> doubts(const Flow& flow, const Grid& grid) {
  std::vector<Doubt> out;
  const double cell = std::min(grid.dx, grid.dy);
  if (const auto& edges = flow.path->box().edges; edges.size() > 1 && edges[1] > coarse_layer * cell)
    out.push_back({"has coarse layers",
                   fmt::format("the first layer, {:.3g} cells thick, is coarse: dent and stress near the "
                               "surface may be some 10 % off; let --depths begin with a quarter of a cell, "
                               "{:.3g} m",
                               edges[1] / cell, cell / 4)});
  if (flow.path->reaches_side())
    out.push_back(
        {"flows at the domain's edge",
         "the bodies flow up to the edge of the domain, and what would flow beyond it is missing: choose "
         "a larger domain, or a smaller load"});
  double largest = 0;
  for (const std::size_t body : {0, 1})
    if (const auto n = flow.path->flowing(body))
      largest = std::max(largest, flow.path->body(*n).equivalent().values.maxCoeff());
  if (largest > small_strain)
    out.push_back(
        {"is strained beyond small strains",
         fmt::format("the plastic strain reaches {:.2g} %, above the {:.0f} % up to which strains are small: "
                     "figures are rough estimates",
                     100 * largest, 100 * small_strain)});
  if (flow.increment_error > accurate_increments)
    out.push_back(
        {"depends on the increments",
         fmt::format("{} increments of the load leave an error of {:.2g} %: give more with --increments",
                     flow.increments, 100 * flow.increment_error)});
  return out;
}

// Along a path of increments.
Pressed press_plastically(const ContactOptions& options, ContactScene& scene, Influence& influence) {
  ElasticOperator& body = influence.on(scene.grid);
  const Stopwatch watch;
  PlasticTarget target{options.force_on(scene.grid, options.contact.load), options.contact.approach};
  Pressed out;
  out.flow = press_with_flow(options.plastic, target, [&] { return plastic_path(options, scene, body); });
  out.contact = contact_of(options, scene, body, *out.flow);
  out.contact.setup_seconds = influence.further_seconds();
  out.contact.seconds = watch.seconds() - out.contact.setup_seconds;
  if (out.contact.load > 0) {
    out.figures = grid_figures(options, scene, body, out.contact);
    out.doubts = doubts(scene.grid, options.bodies, out.contact);
  }
  for (Doubt& doubt : doubts(*out.flow, scene.grid)) out.doubts.push_back(std::move(doubt));
  return out;
}

Pressed press(const ContactOptions& options, ContactScene& scene, Influence& influence) {
  if (options.plastic.flows()) return press_plastically(options, scene, influence);
  ElasticOperator& body = influence.on(scene.grid);
  const bool pressed_again = options.adds("grid_errors");  // on coarser cells; else the gap has served
  Field gap = pressed_again ? scene.gap : std::move(scene.gap);
  ContactParameters parameters = options.contact;
  parameters.load = options.force_on(scene.grid, parameters.load);
  Pressed out{solve_contact(scene.grid, std::move(gap), body, parameters), {}, {}};
  out.contact.setup_seconds = influence.further_seconds();
  out.figures = grid_figures(options, scene, body, out.contact);
  out.doubts = doubts(scene.grid, options.bodies, out.contact);
  for (Doubt& doubt : doubts(out.figures)) out.doubts.push_back(std::move(doubt));
  return out;
}

Accurate press_accurately(const Tool& tool, const ContactOptions& options, ContactScene& scene,
                          Influence& influence) {
  const ContactScene given = scene;
  for (Index factor = 1;; factor *= 2) {
    if (factor > 1) scene = finer(given, options, factor);
    Accurate out{press(options, scene, influence), {}};
    const Contact& contact = out.pressed.contact;
    const GridFigures& figures = out.pressed.figures;
    const double error = largest_error(contact, figures);
    const std::string cells = text(scene.grid.shape);
    tool.detail(fmt::format("{} cells: errors of the grid up to {:.2g} %", cells, 100 * error));
    scene.refinement = factor;
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

std::string unconverged(const ContactOptions& options, const Contact& contact) {
  if (!contact.converged) return "not converged: " + contact.reason;
  if (!options.contact.stiffness || !std::isnan(contact.stiffness)) return "";
  return fmt::format("the stiffness is not converged: residual {:.1e} above {:.0e}; see --max-convolutions",
                     contact.stiffness_residual, stiffness_tolerance);
}

}  // namespace asperity::cli
