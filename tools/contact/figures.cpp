#include "tools/contact/figures.hpp"

#include <cmath>

#include "contact/energy.hpp"
#include "contact/outline.hpp"
#include "core/error.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/sample/moments.hpp"

namespace asperity::cli {
namespace {

// Nothing where the field has too few points.
template <class Measure>
void if_possible(Measure measure) try {
  measure();
} catch (const DataError&) {
}

void add_ratios(Figures& out, const ContactScene& scene, const ContactOptions& o, const Contact& c,
                const GridFigures& grid) {
  const GapRoughness& gap = scene.roughness;
  const double area = grid.area_corrected, load_error = o.contact.approach ? grid.errors.load : 0;
  const ContactRatios ratios = contact_ratios(scene.grid, o.bodies, gap, o.contact.limit_pressure, c, area),
                      errors = ratio_errors(ratios, gap, c, area, grid.errors, load_error);
  auto add = [&out](const char* name, const char* unit, double value, bool of_load,
                    std::optional<double> error = {}) {
    if (std::isfinite(value)) out.push_back({name, unit, value, of_load, error});
  };
  add("area_share", "1", ratios.area_share, true, errors.area_share);
  add("reduced_pressure", "1", ratios.reduced_pressure, true, errors.reduced_pressure);
  add("kappa", "1", ratios.kappa, true, errors.kappa);
  add("reduced_gap", "1", ratios.reduced_gap, true, errors.reduced_gap);
  add("sphere_roughness", "1", ratios.sphere_roughness, true);
  add("plasticity_index", "1", ratios.plasticity_index, false);
  add("nayak_alpha", "1", gap.nayak_alpha, false);
  add("rms_slope", "1", gap.rms_slope, false, gap.rms_slope_error);
  add("rms_height", "m", gap.rms_height, false);
}

void add_energies(Figures& out, const ContactScene& scene, const ContactOptions& o, const Contact& c,
                  const GridErrors& errors) {
  const double limit = o.contact.limit_pressure;
  out.push_back({"elastic_energy", "J", elastic_energy(scene.grid, c), true, errors.elastic_energy});
  if (std::isfinite(limit))
    out.push_back({"plastic_work", "J", plastic_work(scene.grid, c, limit), true, errors.plastic_work});
}

void add_patches(Figures& out, const Grid& grid, const Contact& c) {
  const Patches patches = find_patches(grid, c.state);
  out.push_back({"patches", "1", static_cast<double>(patches.count())});
  out.push_back({"largest_patch", "m2", static_cast<double>(patches.largest()) * grid.cell_area()});
  out.push_back({"percolates_x", "1", patches.percolates_x ? 1.0 : 0.0});
  out.push_back({"percolates_y", "1", patches.percolates_y ? 1.0 : 0.0});
}

}  // namespace

GapRoughness roughness_of(const Field& rough_gap, const Grid& grid, int threads, double largest) {
  GapRoughness out;
  const Strip whole = Strip::whole(rough_gap, grid);
  const double mean = rough_gap.mean();
  if_possible([&] { out.rms_height = moments(rough_gap).sq; });
  const RmsSlope slope = rms_slope(rough_gap, grid);
  out.rms_slope = slope.value, out.rms_slope_error = slope.error;
  if_possible([&] {
    SpectralMomentSums spectral;
    spectral.add(whole, mean, threads);
    out.nayak_alpha = spectral.moments(grid).isotropic().bandwidth();
  });
  if_possible([&] {
    constexpr double round_off = 1e-10;  // of values that cancelled, and far more
    SummitSums summits(round_off * largest);
    summits.add(whole, mean, threads);
    const CountedSummits counted = summits.summits(grid);
    if (counted.count > 0) out.plateaus = counted.plateaus / counted.count;
    out.summit_deviation = counted.height_deviation;
    out.summit_curvature = counted.mean_curvature;
  });
  return out;
}

Figures figures(const ContactScene& scene, const ContactOptions& o, const Contact& contact,
                const GridFigures& grid) {
  Figures out;
  if (o.adds("contact_ratios")) add_ratios(out, scene, o, contact, grid);
  if (o.adds("elastic_energy")) add_energies(out, scene, o, contact, grid.errors);
  if (o.adds("patches")) add_patches(out, scene.grid, contact);
  return out;
}

void record_patches(Dataset& data, const Grid& grid, const Contact& contact) {
  Patches patches = find_patches(grid, contact.state);
  Variable labels{"label", {"x", "y"}, std::move(patches.label), {}};
  labels.attributes.set("long_name", "patch of contact, by falling area; 0 is open");
  labels.attributes.set("units", "1");
  labels.attributes.set_values("actual_range",
                               std::vector<std::int32_t>{0, static_cast<std::int32_t>(patches.count())});
  data.put(std::move(labels));
  if (patches.count() == 0) return;
  data.set_dimension("patch", patches.count());
  std::vector<double> areas;
  for (const Index cells : patches.cells) areas.push_back(static_cast<double>(cells) * grid.cell_area());
  Variable area{"patch_area", {"patch"}, std::move(areas), {}};
  area.attributes.set("long_name", "area of each patch of contact, that of label 1 first");
  area.attributes.set("units", "m2");
  data.put(std::move(area));
}

}  // namespace asperity::cli
