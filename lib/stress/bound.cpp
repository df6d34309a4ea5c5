#include "stress/bound.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/calibration.hpp"
#include "stress/influence.hpp"

namespace asperity {
namespace {

double norm(const stress::Tensor& s) {
  double sum = 0;
  for (stress::Component c : stress::components) sum += (c < stress::xy ? 1 : 2) * s[c] * s[c];
  return std::sqrt(sum);
}

// The largest norm at depth 1 under a unit force.
double largest_norm(double poisson, stress::Traction load) {
  using namespace calibration::stress;
  double top = 0;
  for (int i = 0; i <= bound_steps; ++i)
    for (int j = 0; j <= bound_steps; ++j)
      top = std::max(top, norm(point_load_stress(bound_width * i / bound_steps, bound_width * j / bound_steps,
                                                 1, poisson, load)));
  return bound_margin * top;
}

}  // namespace

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
