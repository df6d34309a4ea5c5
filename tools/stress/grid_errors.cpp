#include "tools/stress/grid_errors.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "contact/grid_error.hpp"
#include "contact/influence.hpp"
#include "core/error.hpp"
#include "dataset/layout.hpp"
#include "stats/hybrid/slope_growth.hpp"
#include "stress/maximum_error.hpp"
#include "tools/stress/maximum.hpp"

namespace asperity::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

StressMaximum maximum_below(const StressScene& scene, const Grid& grid, const Field& pressure,
                            const StressSearch& search, int threads) {
  const auto& [own_grid, own_pressure, poisson, friction] = scene.body;
  return maximum_stress(StressSolver({grid, pressure, poisson, friction}, threads, scene.resolution), search);
}

}  // namespace

LoadingContact loading_contact(const Dataset& data) {
  const Attributes& a = data.attributes;
  for (const char* name : {"gap", "displacement"})
    if (!data.has(name))
      throw UsageError("add",
                       fmt::format("grid_errors solves the contact again: the dataset has no {}, which "
                                   "asperity-contact writes",
                                   name));
  LoadingContact out;
  out.modulus = a.number("contact_composite_modulus", none);
  out.load = a.number("contact_load", none);
  out.limit = a.number("contact_limit_pressure", std::numeric_limits<double>::infinity());
  if (!(out.modulus > 0 && out.load > 0 && out.limit > 0))
    throw UsageError("add",
                     "grid_errors solves the contact again: contact_composite_modulus, contact_load and "
                     "contact_limit_pressure must be above 0, as asperity-contact writes them");
  constexpr double edited = 1e-6;  // of the load: round-off leaves 1e-12
  const double carried = field_of(data, "pressure", "Pa").sum() * grid_of(data).cell_area();
  if (!(std::abs(carried / out.load - 1) <= edited))
    throw UsageError("add",
                     fmt::format("grid_errors solves the contact again: the pressure carries {:.6g} N, not "
                                 "contact_load, {:.6g} N; it was changed since",
                                 carried, out.load));
  out.gap = field_of(data, "gap", "m") - field_of(data, "displacement", "m");
  out.resolved = SlopeGrowth{a.number("contact_slope_growth", 0)}.resolved() != Resolved::no;
  return out;
}

void record_grid_errors(const Tool& tool, StressScene& scene, const LoadingContact& loading,
                        const StressSearch& search, const StressMaximum& maximum) {
  if (!loading.resolved) {
    tool.warn(
        "the grid does not resolve the surface (contact_slope_growth): the largest stress has no error");
    return;
  }
  const Grid& grid = scene.body.grid;
  const int threads = tool.thread_count();
  const auto influence = make_influence(grid, loading.modulus, threads);
  Contact contact;
  contact.pressure = scene.body.pressure;
  contact.load = loading.load;
  const CoarserContacts coarser =
      coarser_contacts(grid, loading.gap, *influence, contact,
                       {.load = loading.load, .limit_pressure = loading.limit, .threads = threads}, Bodies{});
  if (!coarser.unknown.empty()) {
    tool.warn("the error of the largest stress is not known: " + coarser.unknown);
    return;
  }
  auto on = [&](std::size_t level) {
    return maximum_below(scene, coarser.grid[level], coarser.contact[level].pressure, search, threads);
  };
  const StressMaximum error = maximum_error(scene.body, {maximum, on(0), on(1)}, search,
                                            contact.pressure.maxCoeff() >= loading.limit);
  scene.data.attributes.set(attribute_of(search.of) + "_error", error.value);
  scene.data.attributes.set("stress_max_depth_error", error.depth);
}

}  // namespace asperity::cli
