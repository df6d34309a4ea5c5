#include "tools/stress/grid_errors.hpp"

#include <cmath>

#include "core/error.hpp"
#include "stress/maximum_error.hpp"
#include "tools/stress/maximum.hpp"

namespace asperity::cli {

RecordedContact loading_contact(const Dataset& data, int threads) {
  RecordedContact out = recorded_contact(data, threads);
  const bool told = out.unknown.empty() || out.growth.resolved() == Resolved::no;
  if (!told) throw UsageError("add", "grid_errors solves the contact again: " + out.unknown);
  return out;
}

StressMaximum maximum_error(const LoadedBody& body, DepthResolution resolution,
                            const CoarserContacts& coarser, const StressSearch& search,
                            const StressMaximum& maximum, bool at_limit_pressure, int threads) {
  auto on = [&](std::size_t level) {
    const LoadedBody below{coarser.grid[level], coarser.contact[level].pressure, body.poisson, body.friction};
    return maximum_stress(StressSolver(below, threads, resolution), search);
  };
  return maximum_error(body, {maximum, on(0), on(1)}, search, at_limit_pressure);
}

void record(Attributes& a, Criterion of, const StressMaximum& error) {
  if (std::isnan(error.value)) return;
  a.set(attribute_of(of) + "_error", error.value);
  a.set("stress_max_depth_error", error.depth);
}

void record_grid_errors(const Tool& tool, StressScene& scene, const RecordedContact& loading,
                        const StressSearch& search, const StressMaximum& maximum) {
  const CoarserContacts coarser = coarser_contacts(loading);
  if (!coarser.unknown.empty()) {
    tool.warn("the error of the largest stress is not known: " + coarser.unknown);
    return;
  }
  record(scene.data.attributes, search.of,
         maximum_error(scene.body, scene.resolution, coarser, search, maximum, loading.at_limit(),
                       tool.thread_count()));
}

}  // namespace asperity::cli
