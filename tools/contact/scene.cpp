#include "tools/contact/scene.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/hybrid/slopes.hpp"
#include "stats/hybrid/summits.hpp"
#include "stats/sample/moments.hpp"
#include "tools/cli/surface_words.hpp"

namespace asperity::cli {
namespace {

Periodic periodic_of(std::string_view boundary) {
  const bool both = boundary == "periodic";
  return {both || boundary == "periodic_x", both || boundary == "periodic_y"};
}

constexpr double bytes_a_cell = 120;

Grid smooth_grid(const ContactOptions& o) {
  if (o.shape.cells() == 0) throw UsageError("shape", "is needed with --smooth");
  for (double side : o.size)
    if (!(side > 0 && std::isfinite(side)))
      throw UsageError("size", "is needed with --smooth, both sides above 0");
  return {o.shape, o.size[0] / static_cast<double>(o.shape.nx), o.size[1] / static_cast<double>(o.shape.ny),
          periodic_of(o.boundary)};
}

void refuse_radius(const ContactOptions& o, Periodic periodic) {
  const bool in_x = periodic.x && o.bodies.curvature_x() != 0;
  if (!in_x && !(periodic.y && o.bodies.curvature_y() != 0)) return;
  if (periodic.both())
    throw UsageError(o.radius_option,
                     "a periodic surface has no radius: leave it out, or press with --boundary free");
  throw UsageError(
      o.radius_option == "radius" ? "radius"
      : in_x                      ? "radius-x"
                                  : "radius-y",
      fmt::format("a surface periodic along {0} has no radius along {0}: give --radius-{1} alone, "
                  "or press with --boundary free",
                  in_x ? "x" : "y", in_x ? "y" : "x"));
}

// A periodic surface may be pressed as a single patch; no other becomes periodic by the option.
Periodic periodic(const ContactOptions& o, const Grid& grid) {
  const Periodic out = o.boundary.empty() ? grid.periodic : periodic_of(o.boundary);
  const bool in_x = out.x && !grid.periodic.x;
  if (in_x || (out.y && !grid.periodic.y))
    throw UsageError("boundary",
                     fmt::format("{} needs a surface that continues at its opposite edge along {}; this one "
                                 "does not (asperity-generate --periodic draws one)",
                                 o.boundary, in_x ? "x" : "y"));
  refuse_radius(o, out);
  return out;
}

// Of the rows of this rank; the first one has all.
Field with_doubts(const Tool& tool, Field heights, const Grid& grid) {
  if (tool.is_first_rank())
    warn_of_heights(tool, Proportions(heights, grid), "m", "asperity-filter --remove-form plane");
  return heights;
}

Field counter_heights(const Tool& tool, const std::string& name, const Grid& grid, std::size_t held,
                      Extent rows) {
  tool.reads(name);  // nothing of it is passed on
  const Dataset data = tool.read(name, held);
  if (const Grid own = grid_of(data); !same_grid(own, grid))
    throw DataError("counter", fmt::format("its grid, {}, differs from that of the first body, {}",
                                           described(own), described(grid)));
  return with_doubts(tool, field_of(data, "heights", "m", rows), grid);
}

// Nothing where the field has too few points.
template <class Measure>
void if_possible(Measure measure) try {
  measure();
} catch (const DataError&) {
}

// Of the rough gap [m], a difference of values up to `largest`. What its size and shape do not allow is
// unknown.
GapRoughness roughness_of(const Field& rough_gap, const Grid& grid, int threads, double largest) {
  GapRoughness out;
  if_possible([&] { out.rms_height = moments(rough_gap).sq; });
  const RmsSlope slope = rms_slope(rough_gap, grid);
  out.rms_slope = slope.value, out.rms_slope_error = slope.error;
  if_possible([&] { out.nayak_alpha = spectral_moments(rough_gap, grid, threads).isotropic().bandwidth(); });
  if_possible([&] {
    constexpr double round_off = 1e-10;  // of values that cancelled, and far more
    const CountedSummits counted = counted_summits(rough_gap, grid, round_off * largest, threads);
    if (counted.count > 0) out.plateaus = counted.plateaus / counted.count;
    out.summit_deviation = counted.height_deviation;
    out.summit_curvature = counted.mean_curvature;
  });
  return out;
}

// Measures the whole gap; where it is not kept, in its own memory.
void learn_from_gap(ContactScene& scene, const ContactOptions& o, bool spends_gap) {
  scene.data.find("x")->attributes.set("periodic", scene.grid.periodic.x ? 1 : 0);
  scene.data.find("y")->attributes.set("periodic", scene.grid.periodic.y ? 1 : 0);
  const bool rough = !o.smooth || !o.counter.empty();
  if (o.adds("contact_ratios")) {
    const Field smooth = undeformed_gap(scene.grid, o.bodies);
    scene.roughness =
        roughness_of(smooth - scene.gap, scene.grid, o.contact.threads, smooth.abs().maxCoeff());
  }
  if (rough) scene.seams = seams(scene.gap, scene.grid.periodic);
  scene.growth =
      rough ? slope_growth(spends_gap ? std::move(scene.gap) : scene.gap, scene.grid, o.contact.threads)
            : SlopeGrowth{GridErrors::none};
  if (scene.growth.resolved() == Resolved::no) scene.roughness.rms_slope_error = GapRoughness::unknown;
}

std::vector<Doubt> doubts(const SlopeGrowth& growth) {
  if (growth.resolved() == Resolved::yes) return {};
  const bool not_at_all = growth.resolved() == Resolved::no;
  return {{"is not resolved",
           fmt::format(
               "the grid {} the surface: the last halving of the cells, to these, adds {:.2g} times as much "
               "to its mean square slope as the halving before (contact_slope_growth; less than 0.8 times "
               "where the grid is fine enough), {}; give the surface a short-wave cut-off of some 8 cells "
               "(asperity help troubleshooting)",
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

ContactScene scene_of(const Tool& tool, const ContactOptions& o, Dataset data) {
  ContactScene scene{.data = std::move(data), .grid = {}, .gap = {}};
  scene.grid = o.smooth ? smooth_grid(o) : grid_of(scene.data);
  const Shape shape = scene.grid.shape;
  const Slabs slabs = shared_rows(shape, *o.ranks);
  tool.require_memory(bytes_a_cell * static_cast<double>(slabs.own().count * shape.ny),
                      o.smooth ? "shape" : "memory",
                      fmt::format("a contact of {}x{} cells", shape.nx, shape.ny));
  if (o.smooth) set_grid(scene.data, scene.grid);
  const Grid given = scene.grid;
  scene.grid.periodic = periodic(o, given);
  const bool whole = !slabs.shared() || o.ranks->rank() == 0;
  const Extent rows = whole ? Extent{0, shape.nx} : slabs.own();
  agree(*o.ranks, [&] {
    scene.gap = undeformed_gap(scene.grid, o.bodies, rows);
    if (!o.smooth) scene.gap -= with_doubts(tool, field_of(scene.data, o.variable, "m", rows), given);
    if (!o.counter.empty())
      scene.gap -= counter_heights(tool, o.counter, given, scene.data.size_in_memory(), rows);
  });
  if (!whole) return scene;
  Field own = slabs.shared() ? own_rows(scene.gap, slabs) : Field();
  learn_from_gap(scene, o, slabs.shared());
  if (slabs.shared()) scene.gap = std::move(own);
  return scene;
}

bool fits(const Tool& tool, Shape shape) {
  return bytes_a_cell * static_cast<double>(shape.cells()) <= static_cast<double>(tool.memory_bound().bytes);
}

ContactScene scene_with(const ContactOptions& o, Dataset data, const Grid& grid, Field gap) {
  ContactScene scene{.data = std::move(data), .grid = grid, .gap = std::move(gap)};
  learn_from_gap(scene, o, false);
  return scene;
}

std::vector<Doubt> doubts(const ContactScene& scene) {
  std::vector<Doubt> out = doubts(scene.growth);
  if (constexpr double many = 0.01; scene.roughness.plateaus > many)
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

}  // namespace asperity::cli
