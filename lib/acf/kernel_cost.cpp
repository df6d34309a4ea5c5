#include "acf/kernel_cost.hpp"

#include <algorithm>
#include <cmath>

#include "core/calibration.hpp"
#include "core/words.hpp"

namespace asperity {
namespace {

double area(Shape lags) { return static_cast<double>(lags.nx) * static_cast<double>(lags.ny); }

std::string megabytes(double bytes) {
  return (bytes < 1e7 ? number(bytes / 1e6) : std::to_string(std::llround(bytes / 1e6))) + "MB";
}

}  // namespace

Shape first_lags(const KernelRequest& request) {
  if (request.lags != Shape{}) return request.lags;
  if (request.target.known) return *request.target.known;
  if (!request.target.reach)
    throw ParameterError("lags", "are required: the reach of this target is not known");
  return request.target.reach(std::min(calibration::acf::cut_over_error * request.acf_tolerance, 0.5));
}

KernelCost kernel_cost(Shape lags) { return {1500 * area(lags), 160 * area(lags)}; }
KernelCost wider_kernel_cost(Shape lags, Index torus) {
  const double points = static_cast<double>(torus * torus) * area(lags);
  return {250 * points, 40 * points};
}

KernelCost periodic_kernel_cost(Shape torus) { return {150 * area(torus), 16 * area(torus)}; }

void check_memory(KernelCost cost, double memory, Shape torus) {
  if (cost.memory > memory)
    throw ParameterError("memory", megabytes(memory) + ": a kernel of the period, " + text(torus) +
                                       " points, takes some " + megabytes(cost.memory));
}

void check_memory(const KernelRequest& request, Shape lags, KernelCost cost) {
  if (cost.memory <= request.memory) return;
  throw ParameterError("memory", megabytes(request.memory) + ": a kernel of " + text(lags) +
                                     " lags needs some " + megabytes(cost.memory) +
                                     "; shorter lengths, wider samples, fewer lags or a "
                                     "larger `acf-tolerance` need less");
}

}  // namespace asperity
