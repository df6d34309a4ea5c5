#include "contact/bodies.hpp"

#include <cmath>

#include <fmt/format.h>

#include "grid/error.hpp"

namespace asperity {

void Bodies::check() const {
  for (double r : radius)
    if (!(r > 0)) throw ParameterError("radius", fmt::format("{} m is not above 0", r));
  for (double e : young)
    if (!(e > 0)) throw ParameterError("young", fmt::format("{} Pa is not above 0", e));
  if (std::isinf(young[0]) && std::isinf(young[1])) throw ParameterError("young", "both bodies are rigid");
  for (double nu : poisson)
    if (!(nu > -1 && nu <= 0.5)) throw ParameterError("poisson", fmt::format("{} is not in (-1, 0.5]", nu));
}

double Bodies::composite_modulus() const {
  return 1 / ((1 - poisson[0] * poisson[0]) / young[0] + (1 - poisson[1] * poisson[1]) / young[1]);
}

double Bodies::composite_curvature() const { return 1 / radius[0] + 1 / radius[1]; }

Field undeformed_gap(const Grid& grid, const Bodies& bodies) {
  const double half = bodies.composite_curvature() / 2;
  return sample(grid, [half](double x, double y) { return half * (x * x + y * y); });
}

}  // namespace asperity
