#include "tools/report/grid_errors.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "tools/contact/record.hpp"
#include "tools/stress/maximum.hpp"

namespace asperity::report {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::optional<Criterion> searched(const Attributes& a) {
  for (const Criterion of : {Criterion::von_mises, Criterion::max_shear, Criterion::principal})
    if (a.number(cli::attribute_of(of), 0) > 0) return of;
  return {};
}

struct Coarser {
  cli::RecordedContact recorded;
  CoarserContacts contacts;
};

Coarser coarser_of(const cli::Tool& tool, const Dataset& data) {
  Coarser out;
  try {
    if (cli::fits(tool, grid_of(data).shape))
      out.recorded = cli::recorded_contact(data, tool.thread_count());
    else
      out.recorded.unknown = "to solve the contact again needs more than the memory of --memory";
    out.contacts = coarser_contacts(out.recorded);
  } catch (const DataError& error) {
    out.contacts.unknown = error.name + ": " + error.what();
  }
  return out;
}

std::string add_to_contact(Attributes& a, const Coarser& coarser) {
  if (!coarser.contacts.unknown.empty()) return coarser.contacts.unknown;
  const auto& [grid, contact] = std::pair{coarser.recorded.grid, coarser.recorded.contact};
  cli::record(a, grid_errors(grid, contact, coarser.contacts));
  return {};
}

std::string add_to_stress(const cli::Tool& tool, Dataset& data, Criterion of, const Coarser& coarser) {
  if (!coarser.contacts.unknown.empty()) return coarser.contacts.unknown;
  Attributes& a = data.attributes;
  const cli::RecordedContact& r = coarser.recorded;
  const LoadedBody body{r.grid,
                        r.contact.pressure,
                        a.number("stress_poisson", none),
                        {a.number("stress_friction", 0), a.number("stress_friction_angle", 0)}};
  const StressMaximum maximum{a.number(cli::attribute_of(of), none), 0, 0,
                              a.number("stress_max_depth", none)};
  const auto resolution =
      a.text("stress_resolution") == "full" ? DepthResolution::full : DepthResolution::adapted;
  const StressMaximum error =
      cli::maximum_error(body, resolution, coarser.contacts, {of, a.number("stress_max_below", 0)}, maximum,
                         r.at_limit(), tool.thread_count());
  cli::record(a, of, error);
  return std::isnan(error.value) ? "at an edge of a contact at its limit pressure the stress may be larger, "
                                   "by how much is not known"
                                 : "";
}

std::string in_words(const std::string& why) {
  return why.empty() ? "" : "Not all errors of the grid are known: " + why + ".";
}

}  // namespace

NoGridErrors add_grid_errors(const cli::Tool& tool, Dataset& data) {
  Attributes& a = data.attributes;
  const auto of = searched(a);
  const bool contact = a.find("contact_load") && !a.find("contact_mean_gap_error"),
             stress = of && !a.find("stress_max_depth_error");
  if (!data.has("pressure") || (!contact && !stress)) return {};
  const Coarser coarser = coarser_of(tool, data);
  NoGridErrors out;
  if (contact) out.contact = in_words(add_to_contact(a, coarser));
  if (stress) out.stress = in_words(add_to_stress(tool, data, *of, coarser));
  return out;
}

}  // namespace asperity::report
