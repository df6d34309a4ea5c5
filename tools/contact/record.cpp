#include "tools/contact/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "contact/bodies.hpp"
#include "contact/energy.hpp"
#include "contact/influence.hpp"
#include "contact/outline.hpp"
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "tools/cli/lineage.hpp"
#include "tools/cli/plain_text.hpp"
#include "tools/cli/record.hpp"

namespace asperity::cli {
namespace {

// ---- the quantities, in the order of a dataset ----

constexpr Quantity<HertzLine> hertz_line_quantities[] = {{"contact_hertz_pressure", &HertzLine::pressure},
                                                         {"contact_hertz_half_width", &HertzLine::half_width},
                                                         {"contact_hertz_approach", &HertzLine::approach}};
constexpr Quantity<Hertz> hertz_quantities[] = {{"contact_hertz_pressure", &Hertz::pressure},
                                                {"contact_hertz_radius", &Hertz::radius},
                                                {"contact_hertz_radius_x", &Hertz::radius_x},
                                                {"contact_hertz_radius_y", &Hertz::radius_y},
                                                {"contact_hertz_approach", &Hertz::approach}};
constexpr Quantity<Contact> solution_quantities[] = {
    {"contact_load", &Contact::load},
    {"contact_flattening_load", &Contact::flattening_load, if_above_0},
    {"contact_approach", &Contact::approach},
    {"contact_max_pressure", &Contact::max_pressure},
    {"contact_area", &Contact::area},
    {"contact_plastic_area", &Contact::plastic_area},
    {"contact_mean_gap", &Contact::mean_gap},
    {"contact_residual", &Contact::residual},
    {"contact_load_residual", &Contact::load_residual},
    {"contact_converged", &Contact::converged},
    {"contact_convolutions", &Contact::convolutions},
    {"contact_preconditionings", &Contact::preconditionings},
    {"contact_levels", &Contact::levels},
    {"contact_setup_seconds", &Contact::setup_seconds},
    {"contact_seconds", &Contact::seconds}};
constexpr Quantity<Contact> stiffness_quantities[] = {
    {"contact_stiffness", &Contact::stiffness}, {"contact_stiffness_residual", &Contact::stiffness_residual}};
constexpr Quantity<SlopeGrowth> growth_quantities[] = {
    {"contact_slope_growth", &SlopeGrowth::gamma, if_known}};
constexpr Quantity<GridFigures> outline_quantities[] = {
    {"contact_perimeter", &GridFigures::perimeter}, {"contact_area_corrected", &GridFigures::area_corrected}};
constexpr Quantity<GridFigures> grid_cost[] = {
    {"contact_grid_errors_seconds", &GridFigures::seconds, if_above_0}};
constexpr Quantity<GridErrors> quantities_with_errors[] = {
    {"contact_area", &GridErrors::area},
    {"contact_area_corrected", &GridErrors::area_corrected},
    {"contact_load", &GridErrors::load},
    {"contact_approach", &GridErrors::approach},
    {"contact_max_pressure", &GridErrors::max_pressure},
    {"contact_plastic_area", &GridErrors::plastic_area},
    {"contact_mean_gap", &GridErrors::mean_gap},
    {"contact_stiffness", &GridErrors::stiffness},
    {"contact_elastic_energy", &GridErrors::elastic_energy},
    {"contact_plastic_work", &GridErrors::plastic_work}};
constexpr Quantity<ContactRatios> ratio_quantities[] = {
    {"contact_area_share", &ContactRatios::area_share, if_finite},
    {"contact_reduced_pressure", &ContactRatios::reduced_pressure, if_finite},
    {"contact_kappa", &ContactRatios::kappa, if_finite},
    {"contact_reduced_gap", &ContactRatios::reduced_gap, if_finite},
    {"contact_sphere_roughness", &ContactRatios::sphere_roughness, if_finite},
    {"contact_plasticity_index", &ContactRatios::plasticity_index, if_finite}};
constexpr Quantity<GapRoughness> roughness_quantities[] = {
    {"contact_nayak_alpha", &GapRoughness::nayak_alpha, if_finite},
    {"contact_rms_slope", &GapRoughness::rms_slope, if_finite},
    {"contact_rms_slope_error", &GapRoughness::rms_slope_error, if_known},
    {"contact_rms_height", &GapRoughness::rms_height, if_finite}};

struct Energies {
  double elastic = 0, plastic = GridErrors::none;
};
constexpr Quantity<Energies> energy_quantities[] = {{"contact_elastic_energy", &Energies::elastic},
                                                    {"contact_plastic_work", &Energies::plastic, if_known}};

// The columns of a sweep, without contact_.
constexpr std::string_view load_columns =
    "load mean_pressure approach area area_corrected plastic_area mean_gap stiffness max_pressure residual "
    "convolutions "
    "converged area_share reduced_pressure kappa reduced_gap sphere_roughness elastic_energy plastic_work "
    "patches largest_patch percolates_x percolates_y dent plastic_volume max_plastic_strain "
    "dissipated_energy "
    "stored_energy";

// ---- attributes ----

std::string boundary_of(Periodic periodic) {
  if (!periodic.any()) return "free";
  return periodic.both() ? "periodic" : periodic.x ? "periodic_x" : "periodic_y";
}

void record_bodies(Attributes& a, const ContactOptions& o, const Grid& grid) {
  auto set_pair = [&a](AttributeName name, double first, double second) {
    a.set_values(name.text, std::vector<double>{first, second});
  };
  const Bodies& b = o.bodies;
  if (!o.smooth) a.set("contact_variable", o.variable);
  set_pair("contact_radius_x", b.radius[0].x, b.radius[1].x);
  set_pair("contact_radius_y", b.radius[0].y, b.radius[1].y);
  set_pair("contact_young", b.young[0], b.young[1]);
  set_pair("contact_poisson", b.poisson[0], b.poisson[1]);
  a.set("contact_composite_modulus", b.composite_modulus());
  a.set("contact_prescribed", o.contact.approach   ? "approach"
                              : o.by_mean_pressure ? "mean_pressure"
                                                   : "load");
  a.set("contact_boundary", boundary_of(grid.periodic));
  if (grid.periodic.one()) a.set("contact_approach_datum", displacement_datum(grid));
  if (!o.counter.empty()) a.set("contact_counter", o.counter);
  a.set("contact_limit_pressure", o.contact.limit_pressure);
  a.set("contact_tolerance", o.contact.tolerance);
}

// The contact of smooth bodies, where that has a closed form.
void record_hertz(Attributes& a, const Grid& grid, const Bodies& bodies, double load) {
  if (has_line_contact(grid, bodies)) record(a, hertz_line_quantities, hertz_line(grid, bodies, load));
  if (has_point_contact(bodies)) record(a, hertz_quantities, hertz(bodies, load));
}

void record_ratios(Attributes& a, const ContactScene& scene, const ContactOptions& o, const Contact& c,
                   const GridFigures& grid) {
  const double area = grid.area_corrected, load_error = o.contact.approach ? grid.errors.load : 0;
  const ContactRatios ratios =
      contact_ratios(scene.grid, o.bodies, scene.roughness, o.contact.limit_pressure, c, area);
  record(a, ratio_quantities, ratios,
         ratio_errors(ratios, scene.roughness, c, area, grid.errors, load_error));
  record(a, roughness_quantities, scene.roughness);
}

void record_energies(Attributes& a, const ContactScene& scene, double limit, const Contact& c,
                     const GridErrors& errors) {
  Energies energies{elastic_energy(scene.grid, c)};
  if (std::isfinite(limit)) energies.plastic = plastic_work(scene.grid, c, limit);
  record(a, energy_quantities, energies, {errors.elastic_energy, errors.plastic_work});
}

void record_patches(Attributes& a, const Grid& grid, const Patches& patches) {
  a.set("contact_patches", static_cast<double>(patches.count()));
  a.set("contact_largest_patch", static_cast<double>(patches.largest()) * grid.cell_area());
  a.set("contact_percolates_x", patches.percolates_x ? 1.0 : 0.0);
  a.set("contact_percolates_y", patches.percolates_y ? 1.0 : 0.0);
}

// What a load makes of the scene; the patches where they are wanted.
std::optional<Patches> record_load(Attributes& a, const ContactScene& scene, const ContactOptions& o,
                                   const Contact& c, const GridFigures& grid, const Flow* flow) {
  record(a, solution_quantities, c);
  if (flow) record_flow(a, o.plastic, *flow);
  if (o.by_mean_pressure) a.set("contact_mean_pressure", mean_pressure(scene.grid, c));
  if (o.contact.stiffness) {
    record(a, stiffness_quantities, c);
    a.set("contact_stiffness_converged", std::isnan(c.stiffness) ? 0 : 1);
  }
  record(a, growth_quantities, scene.growth);
  record(a, outline_quantities, grid);
  record(a, grid.errors);
  record(a, grid_cost, grid);
  if (o.adds("contact_ratios")) record_ratios(a, scene, o, c, grid);
  if (o.adds("elastic_energy")) record_energies(a, scene, o.contact.limit_pressure, c, grid.errors);
  if (!o.adds("patches")) return std::nullopt;
  Patches patches = find_patches(scene.grid, c.state);
  record_patches(a, scene.grid, patches);
  return patches;
}

// The columns of a sweep that have something recorded, with errors. The load is prescribed and has none.
std::vector<Column> columns_of(const Attributes& recorded, bool errors) {
  std::vector<Column> out;
  for (const std::string_view word : words_of(load_columns)) {
    const std::string shown(word), name = "contact_" + shown;
    if (!recorded.find(name)) continue;
    const KnownAttribute& known = *known_attribute(name);
    const std::string unit(known.column_unit());
    out.push_back({shown, unit, known.open ? Holds::open : Holds::known});
    if (errors && shown != "load" && known_attribute(error_name(name)))
      out.push_back({error_name(shown), unit, Holds::unknown});
  }
  return out;
}

// ---- fields ----

void record_fields(Dataset& data, SharedFields& fields, const Contact& c) {
  fields.set(data, "pressure", c.pressure, {"Pa", "contact pressure"});
  fields.set(data, "gap", c.gap, {"m", "gap between the pressed bodies, negative where flattened"});
  fields.set(data, "displacement", c.displacement, {"m", "elastic displacement of both bodies together"});
  set_flags(data, "contact", c.state, "state of contact", "open elastic at_limit_pressure");
}

void record_flattening(Dataset& data, SharedFields& fields, const ContactOptions& o, const Contact& c,
                       const Field& pressed, const Flow* flow) {
  if (std::isinf(o.contact.limit_pressure) && flow == nullptr) return;
  const Field of_first = flow ? flow->path->displacement(0) : plastic_flattening(c),
              flattened = flow ? of_first + flow->path->displacement(1) : of_first;
  fields.set(data, "displacement_plastic", flattened, {"m", "plastic flattening of both bodies together"});
  if (!o.unloads()) return;
  const Field left = o.smooth ? Field(-of_first) : Field(pressed - of_first);
  fields.set(data, "heights_residual", left, {"m", "heights after the load is removed"});
}

// label(x, y) and patch_area(patch).
void record_labels(Dataset& data, const Grid& grid, Patches patches) {
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

// ---- the way back ----

constexpr double not_recorded = std::numeric_limits<double>::quiet_NaN();
constexpr double edited = 1e-6;          // of a figure: round-off leaves 1e-12
constexpr double gap_round_off = 1e-12;  // of the displacements

std::string missing(const Dataset& data) {
  if (data.attributes.text("contact_plasticity") == "j2")
    return "the bodies flow, and contacts on coarser cells would be elastic";
  auto number = [&](AttributeName name) { return data.attributes.number(name.text, not_recorded); };
  for (const char* name : {"pressure", "gap", "displacement"})
    if (!data.has(name)) return fmt::format("the dataset has no {}, which asperity-contact writes", name);
  for (const AttributeName name : {AttributeName("contact_composite_modulus"), AttributeName("contact_load"),
                                   AttributeName("contact_limit_pressure")})
    if (!(number(name) > 0))
      return fmt::format("{} must be above 0, as asperity-contact writes it", name.text);
  for (const AttributeName name : {AttributeName("contact_approach"), AttributeName("contact_mean_gap"),
                                   AttributeName("contact_max_pressure")})
    if (!std::isfinite(number(name)))
      return fmt::format("the dataset has no number {}, which asperity-contact writes", name.text);
  return {};
}

void read_radii(const Attributes& a, Bodies& bodies) {
  for (const auto& [name, radius] :
       {std::pair{"contact_radius_x", &Radii::x}, std::pair{"contact_radius_y", &Radii::y}})
    if (const Values* both = a.find(name); both && !std::holds_alternative<std::string>(*both))
      for (std::size_t k = 0; k < std::min<std::size_t>(2, count(*both)); ++k)
        bodies.radius[k].*radius = numbers(*both)[k];
}

// The figures by the fields; the rest as recorded.
Contact contact_of(const Dataset& data, const Grid& grid, double limit) {
  Contact out;
  out.converged = true;
  read_back(data.attributes, solution_quantities, out);
  read_back(data.attributes, stiffness_quantities, out);
  out.pressure = field_of(data, "pressure", "Pa");
  out.displacement = field_of(data, "displacement", "m");
  out.gap = field_of(data, "gap", "m");
  for (const double p : out.pressure.reshaped<Eigen::RowMajor>())
    out.state.push_back(p >= limit ? Contact::plastic : p > 0 ? Contact::elastic : Contact::open);
  out.max_pressure = out.pressure.maxCoeff();
  out.area = static_cast<double>((out.pressure > 0).count()) * grid.cell_area();
  out.plastic_area = static_cast<double>((out.pressure >= limit).count()) * grid.cell_area();
  out.mean_gap = out.gap.cwiseMax(0).mean();
  return out;
}

// Where the fields are no longer those of the figures.
std::string changed(const Dataset& data, const Grid& grid, const Contact& contact) {
  auto differs = [&](AttributeName name, double found, double noise) -> std::string {
    const double recorded = data.attributes.number(name.text, not_recorded);
    if (std::abs(found - recorded) <= edited * std::abs(recorded) + noise) return {};
    return fmt::format("by its fields {0} is {1:.6g} {2}, not {3:.6g} {2}; it was cropped or changed since",
                       name.text, found, name.known().unit, recorded);
  };
  const double noise = gap_round_off * contact.displacement.abs().maxCoeff();
  for (const std::string& why : {differs("contact_load", contact.pressure.sum() * grid.cell_area(), 0),
                                 differs("contact_max_pressure", contact.max_pressure, 0),
                                 differs("contact_mean_gap", contact.mean_gap, noise)})
    if (!why.empty()) return why;
  return {};
}

std::string unusable(const Dataset& data, const RecordedContact& r) {
  if (!r.contact.converged) return "the contact did not converge";
  if (r.growth.resolved() == Resolved::no)
    return fmt::format("the grid does not resolve the surface (contact_slope_growth {:.2g}, not below 1)",
                       r.growth.gamma);
  return changed(data, r.grid, r.contact);
}

}  // namespace

void record(Attributes& a, const GridErrors& errors) {
  for (const auto& quantity : quantities_with_errors) record_error(a, quantity, errors);
}

void record(ContactScene& scene, const ContactOptions& options, const Contact& contact,
            const GridFigures& grid, const Flow* flow) {
  const bool keeps = options.unloads() && !options.smooth;
  const Slabs slabs = contact.slabs();
  const Field pressed = keeps ? own_rows(field_of(scene.data, options.variable, "m"), slabs) : Field();
  SharedFields& fields = scene.fields.emplace(slabs);
  const bool overwrites = options.unloads() && options.variable == "heights_residual";
  drop_results(scene.data, "contact", overwrites ? "" : options.variable);
  Attributes& a = scene.data.attributes;
  record_bodies(a, options, scene.grid);
  if (contact.load > 0) record_hertz(a, scene.grid, options.bodies, contact.load);
  record_fields(scene.data, fields, contact);
  record_flattening(scene.data, fields, options, contact, pressed, flow);
  std::optional<Patches> patches = record_load(a, scene, options, contact, grid, flow);
  if (flow) record_strain(scene.data, scene.grid, *flow);
  if (patches) record_labels(scene.data, scene.grid, std::move(*patches));
  if (!(options.accuracy > 0)) return;
  a.set("contact_accuracy", options.accuracy);
  a.set("contact_refinement", static_cast<double>(scene.refinement));
}

void add_load(Table& table, const ContactScene& scene, const ContactOptions& options, const Contact& contact,
              const GridFigures& grid, const Flow* flow) {
  Attributes recorded;
  record_load(recorded, scene, options, contact, grid, flow);
  if (table.columns.empty()) table.columns = columns_of(recorded, options.adds("grid_errors"));
  std::vector<Cell>& row = table.rows.emplace_back();
  for (const Column& column : table.columns)
    row.emplace_back(recorded.number("contact_" + column.name, not_recorded));
}

RecordedContact recorded_contact(const Dataset& data, int threads) {
  RecordedContact out;
  out.unknown = missing(data);
  if (!out.unknown.empty()) return out;
  const Attributes& a = data.attributes;
  out.grid = grid_of(data);
  out.modulus = a.number("contact_composite_modulus", not_recorded);
  out.parameters.limit_pressure = a.number("contact_limit_pressure", not_recorded);
  out.parameters.threads = threads;
  out.contact = contact_of(data, out.grid, out.parameters.limit_pressure);
  out.parameters.stiffness = std::isfinite(out.contact.stiffness);
  if (a.text("contact_prescribed") == "approach")
    out.parameters.approach = out.contact.approach;
  else
    out.parameters.load = out.contact.load;
  out.gap = out.contact.gap - out.contact.displacement + out.contact.approach;
  read_radii(a, out.bodies);
  out.growth.gamma = not_recorded;
  read_back(a, growth_quantities, out.growth);
  out.unknown = unusable(data, out);
  return out;
}

CoarserContacts coarser_contacts(const RecordedContact& r) {
  if (!r.unknown.empty()) {
    CoarserContacts out;
    out.unknown = r.unknown;
    return out;
  }
  const auto influence = make_influence(r.grid, r.modulus, r.parameters.threads);
  return coarser_contacts(r.grid, r.gap, *influence, r.contact, r.parameters, r.bodies);
}

}  // namespace asperity::cli
