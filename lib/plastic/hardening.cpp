#include "plastic/hardening.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/error.hpp"

namespace asperity {

Hardening Hardening::swift(double strength, double offset, double exponent) {
  return {strength * std::pow(offset, exponent), 0, strength, offset, exponent};
}

void Hardening::check() const {
  auto require = [](bool holds, const char* name, const std::string& words) {
    if (!holds) throw ParameterError(name, words);
  };
  if (strength != 0) {
    require(strength > 0 && std::isfinite(strength), "hardening",
            fmt::format("Swift's strength B, {} Pa, is not above 0", strength));
    require(offset > 0 && std::isfinite(offset), "hardening",
            fmt::format("Swift's offset C, {}, is not above 0", offset));
    require(exponent > 0 && exponent <= 1, "hardening",
            fmt::format("Swift's exponent n, {}, is not above 0 and at most 1", exponent));
  }
  require(yield > 0, "yield", fmt::format("{} Pa is not above 0", yield));
  require(modulus >= 0 && std::isfinite(modulus), "hardening",
          fmt::format("the modulus H, {} Pa, is not 0 or more", modulus));
}

double Hardening::flow_stress(double strain) const {
  return strength > 0 ? strength * std::pow(offset + strain, exponent) : yield + modulus * strain;
}

double Hardening::flow(double trial, double strain, double shear_modulus) const {
  constexpr int most_steps = 50;
  constexpr double round_off = 1e-14;
  const double beyond = trial - flow_stress(strain), stiff = 3 * shear_modulus;
  if (!(beyond > 0)) return 0;
  if (strength == 0) return beyond / (stiff + modulus);
  double gamma = 0;  // where f(γ) = q - 3μγ - σ_f ≥ 0 is convex, steps stay below the root
  for (int step = 0; step < most_steps; ++step) {
    const double stress = flow_stress(strain + gamma), slope = exponent * stress / (offset + strain + gamma),
                 change = (trial - stiff * gamma - stress) / (stiff + slope);
    gamma += change;
    if (std::abs(change) <= round_off * gamma) break;
  }
  return gamma;
}

}  // namespace asperity
