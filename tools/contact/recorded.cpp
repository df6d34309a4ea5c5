#include "tools/contact/recorded.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "contact/influence.hpp"
#include "core/error.hpp"
#include "dataset/layout.hpp"

namespace asperity::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double edited = 1e-6;      // of a figure: round-off leaves 1e-12
constexpr double round_off = 1e-12;  // of the displacements, in gaps

std::string missing(const Dataset& data) {
  for (const char* name : {"pressure", "gap", "displacement"})
    if (!data.has(name)) return fmt::format("the dataset has no {}, which asperity-contact writes", name);
  for (const char* name : {"composite_modulus", "load", "limit_pressure"})
    if (!(data.attributes.number(std::string("contact_") + name, none) > 0))
      return fmt::format("contact_{} must be above 0, as asperity-contact writes it", name);
  for (const char* name : {"approach", "mean_gap", "max_pressure"})
    if (!std::isfinite(data.attributes.number(std::string("contact_") + name, none)))
      return fmt::format("the dataset has no number contact_{}, which asperity-contact writes", name);
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
  const Attributes& a = data.attributes;
  Contact out;
  out.pressure = field_of(data, "pressure", "Pa");
  out.displacement = field_of(data, "displacement", "m");
  out.gap = field_of(data, "gap", "m");
  for (const double p : out.pressure.reshaped<Eigen::RowMajor>())
    out.state.push_back(p >= limit ? Contact::plastic : p > 0 ? Contact::elastic : Contact::open);
  out.load = a.number("contact_load", none);
  out.approach = a.number("contact_approach", none);
  out.stiffness = a.number("contact_stiffness", none);
  out.max_pressure = out.pressure.maxCoeff();
  out.area = static_cast<double>((out.pressure > 0).count()) * grid.cell_area();
  out.plastic_area = static_cast<double>((out.pressure >= limit).count()) * grid.cell_area();
  out.mean_gap = out.gap.cwiseMax(0).mean();
  out.converged = a.number("contact_converged", 1) != 0;
  return out;
}

// Where the fields are no longer those of the figures.
std::string changed(const Dataset& data, const Grid& grid, const Contact& contact) {
  auto differs = [&](const char* name, double found, const char* unit, double noise) -> std::string {
    const double recorded = data.attributes.number(name, none);
    if (std::abs(found - recorded) <= edited * std::abs(recorded) + noise) return {};
    return fmt::format("by its fields {} is {:.6g} {}, not {:.6g} {}; it was cropped or changed since", name,
                       found, unit, recorded, unit);
  };
  const double noise = round_off * contact.displacement.abs().maxCoeff();
  for (const std::string& why : {differs("contact_load", contact.pressure.sum() * grid.cell_area(), "N", 0),
                                 differs("contact_max_pressure", contact.max_pressure, "Pa", 0),
                                 differs("contact_mean_gap", contact.mean_gap, "m", noise)})
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

RecordedContact recorded_contact(const Dataset& data, int threads) {
  RecordedContact out;
  out.unknown = missing(data);
  if (!out.unknown.empty()) return out;
  const Attributes& a = data.attributes;
  out.grid = grid_of(data);
  out.modulus = a.number("contact_composite_modulus", none);
  out.parameters.limit_pressure = a.number("contact_limit_pressure", none);
  out.parameters.threads = threads;
  out.contact = contact_of(data, out.grid, out.parameters.limit_pressure);
  out.parameters.stiffness = std::isfinite(out.contact.stiffness);
  if (a.text("contact_prescribed") == "approach")
    out.parameters.approach = out.contact.approach;
  else
    out.parameters.load = out.contact.load;
  out.gap = out.contact.gap - out.contact.displacement + out.contact.approach;
  read_radii(a, out.bodies);
  out.growth = {a.number("contact_slope_growth", none)};
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
