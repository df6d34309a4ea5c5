#include "stress/load.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/poisson.hpp"
#include "stress/influence.hpp"

namespace asperity {
namespace {

// Of the largest pressure: squares of its stresses, also deep below it, are numbers that doubles hold.
constexpr double least_pressure = 1e-100, greatest_pressure = 1e100;

// The lattice of (2): tests/stress/section.cpp, against finer and wider ones.
constexpr int bound_steps = 100;
constexpr double bound_width = 4, bound_rise = 1.01;

double norm(const stress::Tensor& s) {
  double sum = 0;
  for (stress::Component c : stress::components) sum += (c < stress::xy ? 1 : 2) * s[c] * s[c];
  return std::sqrt(sum);
}

// The largest norm at depth 1 under a unit force.
double largest_norm(double poisson, stress::Traction load) {
  double top = 0;
  for (int i = 0; i <= bound_steps; ++i)
    for (int j = 0; j <= bound_steps; ++j)
      top = std::max(top, norm(point_load_stress(bound_width * i / bound_steps, bound_width * j / bound_steps,
                                                 1, poisson, load)));
  return bound_rise * top;
}

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

double LoadedBody::largest() const {
  const double none = -std::numeric_limits<double>::infinity();
  return asperity::largest(*ranks, pressure.size() > 0 ? pressure.maxCoeff() : none);
}

double LoadedBody::least() const {
  const double none = -std::numeric_limits<double>::infinity();
  return -asperity::largest(*ranks, pressure.size() > 0 ? -pressure.minCoeff() : none);
}

LoadedBody LoadedBody::on_the_first() const {
  const Extent wanted{0, ranks->rank() == 0 ? grid.shape.nx : 0};
  return {grid, rows_of(pressure, rows(), wanted), poisson, friction};
}

void LoadedBody::check() const {
  friction.check();
  check_poisson(poisson);
  const Shape own{rows().own().count, grid.shape.ny};
  if (shape_of(pressure) != own) throw DataError("pressure", "its shape is not that of the grid");
  if (grid.shape.cells() == 0) throw DataError("pressure", "it has no cells");
  if (!(grid.dx > 0 && grid.dy > 0 && grid.size_x() <= farthest && grid.size_y() <= farthest))
    throw DataError("pressure", fmt::format("its cells have invalid sides, {} m x {} m", grid.dx, grid.dy));
  if (asperity::largest(*ranks, pressure.isFinite().all() ? 0 : 1) > 0)
    throw DataError("pressure", "holds a value that is not a finite number");
  const double largest = std::max(this->largest(), -least());
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

double stress_bound(const LoadedBody& body) {
  const Eigen::ArrayXd of_rows = body.pressure.abs().rowwise().sum();
  const auto all = gathered(*body.ranks, std::vector<double>(of_rows.begin(), of_rows.end()));
  const double pressed = std::accumulate(all.begin(), all.end(), 0.0);
  if (body.grid.periodic.any()) return std::numeric_limits<double>::infinity();
  const double friction = body.friction.coefficient,
               sliding = friction > 0 ? friction * largest_norm(body.poisson, stress::shear_x) : 0;
  return std::sqrt(1.5) * (largest_norm(body.poisson, stress::normal) + sliding) * pressed *
         body.grid.cell_area();
}

}  // namespace asperity
