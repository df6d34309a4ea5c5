#include "stress/friction.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity {

void Friction::check() const {
  if (!(coefficient >= 0 && std::isfinite(coefficient)))
    throw ParameterError("friction", fmt::format("{} is not 0 or more", coefficient));
  if (!(std::abs(angle) <= 2 * std::numbers::pi * (1 + 1e-12)))
    throw ParameterError("friction-angle", fmt::format("{} rad must lie within -360 ... 360 degrees", angle));
}

std::array<double, 3> Friction::weights() const {
  auto part = [&](double cosine) { return std::abs(cosine) <= 1e-12 ? 0 : coefficient * cosine; };
  return {1, part(std::cos(angle)), part(std::sin(angle))};
}

stress::Tractions acting(const std::array<double, 3>& weights) {
  stress::Tractions set;
  for (stress::Traction t : stress::tractions) set[t] = weights[t] != 0;
  return set;
}

}  // namespace asperity
