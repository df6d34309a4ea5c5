#include "tools/contact/resolution.hpp"

#include <cmath>

#include <fmt/format.h>

#include "tools/cli/record.hpp"

namespace asperity::cli {

GridFigures grid_figures(const ContactOptions& options, const ContactScene& scene, ElasticOperator& influence,
                         const Contact& contact) {
  const Grid& grid = scene.grid;
  const Outline around = outline(grid, contact);
  GridFigures out{around.perimeter(grid),
                  corrected_area(grid, contact, around, options.contact.limit_pressure)};
  if (scene.growth.resolved() == Resolved::no || !contact.converged) return out;
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

void record(Attributes& a, const GridErrors& e) {
  auto set = [&a](const char* name, double value) {
    if (!std::isnan(value)) a.set(name, value);
  };
  set("contact_area_error", e.area);
  set("contact_area_corrected_error", e.area_corrected);
  set("contact_load_error", e.load);
  set("contact_approach_error", e.approach);
  set("contact_max_pressure_error", e.max_pressure);
  set("contact_plastic_area_error", e.plastic_area);
  set("contact_mean_gap_error", e.mean_gap);
  set("contact_stiffness_error", e.stiffness);
  for (const auto& [name, error] :
       {std::pair{"contact_elastic_energy", e.elastic_energy}, {"contact_plastic_work", e.plastic_work}})
    if (a.find(name) != nullptr) set((std::string(name) + "_error").c_str(), error);
}

void record(Attributes& a, const SlopeGrowth& growth, const GridFigures& figures) {
  if (!std::isnan(growth.gamma)) a.set("contact_slope_growth", growth.gamma);
  a.set("contact_perimeter", figures.perimeter);
  a.set("contact_area_corrected", figures.area_corrected);
  record(a, figures.errors);
  if (figures.seconds > 0) a.set("contact_grid_errors_seconds", on_record(figures.seconds));
}

namespace {

std::vector<Doubt> doubts(const SlopeGrowth& growth) {
  if (growth.resolved() == Resolved::yes) return {};
  const bool not_at_all = growth.resolved() == Resolved::no;
  return {{"is not resolved",
           fmt::format(
               "the grid {} the surface: the last halving of the cells, to these, adds {:.2g} times as much "
               "to its "
               "mean square slope as the halving before (contact_slope_growth; less than 0.8 times where the "
               "grid "
               "is fine enough), {}; give the surface a short-wave cut-off of some 8 cells (asperity help "
               "troubleshooting)",
               not_at_all ? "does not resolve" : "barely resolves", growth.gamma,
               not_at_all ? "so areas and pressures depend on the grid and have no errors"
                          : "so errors of the grid are in doubt")}};
}

Doubt doubt(const Seam& seam, Periodic periodic, bool in_x) {
  const std::string axis = in_x ? "x" : "y", other = in_x ? "y" : "x";
  return {
      in_x ? "jumps at its seam along x" : "jumps at its seam along y",
      fmt::format("the surface is marked as periodic along {} but jumps at the seam: the rms step from its "
                  "last line to its first, {:.3g} m, is {:.2g} times the largest between neighbouring lines; "
                  "press it with --boundary {}, or remove its trend and taper its edges",
                  axis, seam.step, seam.step / seam.largest, periodic.both() ? "periodic_" + other : "free")};
}

}  // namespace

std::vector<Doubt> doubts(const ContactScene& scene) {
  std::vector<Doubt> out = doubts(scene.growth);
  if (constexpr double told = 0.01; scene.roughness.plateaus > told)
    out.push_back(
        {"has summits that are plateaus",
         fmt::format("{:.2g} % of the summits are plateaus of equal heights, as of heights in coarse steps: "
                     "nayak_alpha and plasticity_index are in doubt; smooth the steps first (asperity-filter "
                     "--lambda-s)",
                     100 * scene.roughness.plateaus)});
  for (const bool in_x : {true, false})
    if (const Seam& seam = scene.seams[in_x ? 0 : 1]; seam.jumps())
      out.push_back(doubt(seam, scene.grid.periodic, in_x));
  return out;
}

std::vector<Doubt> doubts(const GridFigures& figures) {
  if (figures.unknown.empty()) return {};
  return {{"has no errors of the grid", "the errors of the grid are not known: " + figures.unknown}};
}

}  // namespace asperity::cli
