#include "tools/contact/scene.hpp"

#include <cmath>

#include <fmt/format.h>

#include "contact/flattening.hpp"
#include "contact/hertz.hpp"
#include "contact/influence.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/record.hpp"
#include "tools/cli/surface_words.hpp"
#include "tools/contact/figures.hpp"
#include "tools/contact/resolution.hpp"

using namespace std::string_literals;

namespace asperity::cli {
namespace {

Periodic periodic_of(std::string_view boundary) {
  const bool both = boundary == "periodic";
  return {both || boundary == "periodic_x", both || boundary == "periodic_y"};
}

std::string boundary_of(Periodic periodic) {
  if (!periodic.any()) return "free";
  return periodic.both() ? "periodic" : periodic.x ? "periodic_x" : "periodic_y";
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

// A periodic surface may be pressed as a single patch; no other becomes periodic by being told so.
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

void record_bodies(Attributes& a, const ContactOptions& o, const Grid& grid) {
  auto set_pair = [&a](const char* name, double first, double second) {
    a.set_values(name, std::vector<double>{first, second});
  };
  const Bodies& b = o.bodies;
  set_pair("contact_radius_x", b.radius[0].x, b.radius[1].x);
  set_pair("contact_radius_y", b.radius[0].y, b.radius[1].y);
  set_pair("contact_young", b.young[0], b.young[1]);
  set_pair("contact_poisson", b.poisson[0], b.poisson[1]);
  a.set("contact_composite_modulus", b.composite_modulus());
  a.set("contact_prescribed", o.contact.approach ? "approach" : "load");
  a.set("contact_boundary", boundary_of(grid.periodic));
  if (grid.periodic.one()) a.set("contact_approach_datum", displacement_datum(grid));
  if (!o.counter.empty()) a.set("contact_counter", o.counter);
  a.set("contact_limit_pressure", o.contact.limit_pressure);
  a.set("contact_tolerance", o.contact.tolerance);
}

// What the bodies would do were they smooth, where that has a closed form.
void record_hertz(Attributes& a, const Grid& grid, const Bodies& bodies, double load) {
  if (has_line_contact(grid, bodies)) {
    const HertzLine smooth = hertz_line(grid, bodies, load);
    a.set("contact_hertz_pressure", smooth.pressure);
    a.set("contact_hertz_half_width", smooth.half_width);
    a.set("contact_hertz_approach", smooth.approach);
  }
  if (!has_point_contact(bodies)) return;
  const Hertz smooth = hertz(bodies, load);
  a.set("contact_hertz_pressure", smooth.pressure);
  a.set("contact_hertz_radius", smooth.radius);
  a.set("contact_hertz_radius_x", smooth.radius_x);
  a.set("contact_hertz_radius_y", smooth.radius_y);
  a.set("contact_hertz_approach", smooth.approach);
}

void record_result(Attributes& a, const Contact& c) {
  a.set("contact_load", c.load);
  if (c.flattening_load > 0) a.set("contact_flattening_load", c.flattening_load);
  a.set("contact_approach", c.approach);
  a.set("contact_max_pressure", c.max_pressure);
  a.set("contact_area", c.area);
  a.set("contact_plastic_area", c.plastic_area);
  a.set("contact_mean_gap", c.mean_gap);
  a.set("contact_residual", c.residual);
  a.set("contact_load_residual", c.load_residual);
  a.set("contact_converged", c.converged ? 1 : 0);
  a.set("contact_convolutions", c.convolutions);
  a.set("contact_preconditionings", c.preconditionings);
  a.set("contact_levels", c.levels);
  a.set("contact_setup_seconds", on_record(c.setup_seconds));
  a.set("contact_seconds", on_record(c.seconds));
}

// Not that of a former run.
void record_stiffness(Attributes& a, const ContactOptions& o, const Contact& c) {
  if (!o.contact.stiffness) return;
  a.set("contact_stiffness", c.stiffness);
  a.set("contact_stiffness_residual", c.stiffness_residual);
  a.set("contact_stiffness_converged", std::isnan(c.stiffness) ? 0 : 1);
}

void record_fields(Dataset& data, SharedFields& fields, const Contact& c) {
  fields.set(data, "pressure", c.pressure, {"Pa", "contact pressure"});
  fields.set(data, "gap", c.gap, {"m", "gap between the pressed bodies, negative where flattened"});
  fields.set(data, "displacement", c.displacement, {"m", "elastic displacement of both bodies together"});
  set_flags(data, "contact", c.state, "state of contact", "open elastic at_limit_pressure");
}

void record_flattening(Dataset& data, SharedFields& fields, const ContactOptions& o, const Contact& c,
                       const Field& pressed) {
  if (std::isinf(o.contact.limit_pressure)) return;
  const Field flattened = plastic_flattening(c);
  fields.set(data, "displacement_plastic", flattened, {"m", "plastic flattening of both bodies together"});
  if (!o.unloads()) return;
  const Field left = o.smooth ? Field(-flattened) : Field(pressed - flattened);
  fields.set(data, "heights_residual", left, {"m", "heights after the load is removed"});
}

// A column of a sweep, and the error that the grid leaves of it.
struct LoadColumn {
  const char *name, *unit;
  double (*value)(const Contact&, const GridFigures&);
  double GridErrors::*error = nullptr;
  Holds holds = Holds::known;
};

template <auto member>
constexpr auto figure = [](const Contact& c, const GridFigures&) { return static_cast<double>(c.*member); };

const LoadColumn load_columns[] = {
    {"load", "N", figure<&Contact::load>},
    {"approach", "m", figure<&Contact::approach>, &GridErrors::approach},
    {"area", "m2", figure<&Contact::area>, &GridErrors::area},
    {"area_corrected", "m2", [](const Contact&, const GridFigures& f) { return f.area_corrected; },
     &GridErrors::area_corrected},
    {"plastic_area", "m2", figure<&Contact::plastic_area>, &GridErrors::plastic_area},
    {"mean_gap", "m", figure<&Contact::mean_gap>, &GridErrors::mean_gap},
    {"stiffness", "N/m", figure<&Contact::stiffness>, &GridErrors::stiffness, Holds::open},
    {"max_pressure", "Pa", figure<&Contact::max_pressure>, &GridErrors::max_pressure},
    {"residual", "1", figure<&Contact::residual>},
    {"convolutions", "1", figure<&Contact::convolutions>},
    {"converged", "1", figure<&Contact::converged>}};

// What the whole gap tells. Where that is not kept, it is worked in.
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

void record(ContactScene& scene, const ContactOptions& options, const Contact& contact,
            const GridFigures& grid) {
  const bool keeps = options.unloads() && !options.smooth;
  const Slabs slabs = contact.slabs();
  const Field pressed = keeps ? own_rows(field_of(scene.data, options.variable, "m"), slabs) : Field();
  SharedFields& fields = scene.fields.emplace(slabs);
  const bool overwrites = options.unloads() && options.variable == "heights_residual";
  drop_results(scene.data, "contact", overwrites ? "" : options.variable);
  Attributes& a = scene.data.attributes;
  if (!options.smooth) a.set("contact_variable", options.variable);
  record_bodies(a, options, scene.grid);
  record_hertz(a, scene.grid, options.bodies, contact.load);
  record_result(a, contact);
  record_stiffness(a, options, contact);
  record(a, scene.growth, grid);
  record_fields(scene.data, fields, contact);
  record_flattening(scene.data, fields, options, contact, pressed);
  for (const Figure& f : figures(scene, options, contact, grid)) {
    a.set("contact_" + f.name, f.value);
    if (const double error = f.error.value_or(NAN); !std::isnan(error))
      a.set("contact_" + f.name + "_error", error);
  }
  if (options.adds("patches")) record_patches(scene.data, scene.grid, contact);
}

void add_load(Table& table, const ContactScene& scene, const ContactOptions& options, const Contact& c,
              const GridFigures& grid) {
  const Figures further = figures(scene, options, c, grid);
  const bool errors = options.adds("grid_errors");
  if (table.columns.empty()) {
    for (const LoadColumn& l : load_columns) {
      table.columns.push_back({l.name, l.unit, l.holds});
      if (errors && l.error) table.columns.push_back({l.name + "_error"s, l.unit, Holds::unknown});
    }
    for (const Figure& f : further)
      if (f.of_load) {
        table.columns.push_back({f.name, f.unit});
        if (errors && f.error) table.columns.push_back({f.name + "_error", f.unit, Holds::unknown});
      }
  }
  std::vector<Cell> row;
  for (const LoadColumn& l : load_columns) {
    row.push_back(l.value(c, grid));
    if (errors && l.error) row.push_back(grid.errors.*l.error);
  }
  for (const Figure& f : further)
    if (f.of_load) {
      row.push_back(f.value);
      if (errors && f.error) row.push_back(*f.error);
    }
  table.rows.push_back(std::move(row));
}

}  // namespace asperity::cli
