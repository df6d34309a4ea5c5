#include "stress/load.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/poisson.hpp"

namespace asperity {
namespace {

// Of the largest pressure: squares of its stresses, also deep below it, are numbers that doubles hold.
constexpr double least_pressure = 1e-100, greatest_pressure = 1e100;

}  // namespace

void Friction::check() const {
  if (!(coefficient >= 0 && std::isfinite(coefficient)))
    throw ParameterError("friction", fmt::format("{} is not 0 or more", coefficient));
  if (!(std::abs(angle) <= 2 * std::numbers::pi * (1 + 1e-12)))
    throw ParameterError("friction-angle", fmt::format("{} rad must lie within -360 ... 360 degrees", angle));
}

LoadWeights Friction::weights() const {
  auto part = [&](double cosine) { return std::abs(cosine) <= 1e-12 ? 0 : coefficient * cosine; };
  return {1, part(std::cos(angle)), part(std::sin(angle))};
}

stress::Tractions acting(const LoadWeights& weights) {
  stress::Tractions set;
  for (stress::Traction t : stress::tractions) set[t] = weights[t] != 0;
  return set;
}

void LoadedBody::check() const {
  friction.check();
  check_poisson(poisson);
  if (shape_of(pressure) != grid.shape) throw DataError("pressure", "its shape is not that of the grid");
  if (pressure.size() == 0) throw DataError("pressure", "it has no cells");
  if (!(grid.dx > 0 && grid.dy > 0 && grid.size_x() <= farthest && grid.size_y() <= farthest))
    throw DataError("pressure", fmt::format("its cells have invalid sides, {} m x {} m", grid.dx, grid.dy));
  if (!pressure.isFinite().all()) throw DataError("pressure", "holds a value that is not a finite number");
  const double largest = pressure.abs().maxCoeff();
  if (largest != 0 && !(largest >= least_pressure && largest <= greatest_pressure))
    throw DataError("pressure", fmt::format("{} Pa is its largest value: must lie in {:g} ... {:g} Pa",
                                            largest, least_pressure, greatest_pressure));
  if (!(friction.coefficient * largest <= greatest_pressure))
    throw ParameterError("friction", fmt::format("{} of {} Pa is a traction above {:g} Pa",
                                                 friction.coefficient, largest, greatest_pressure));
}

void check_depth(double z) {
  if (!(z >= 0 && z <= farthest))
    throw ParameterError("depth", fmt::format("{} m is not a depth, 0 ... {:g} m", z, farthest));
}

}  // namespace asperity
