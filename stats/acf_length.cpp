#include "stats/acf_length.hpp"

#include <cmath>

namespace asperity {
namespace {

// Where between above > level ≥ below, per (1), and how steep.
Crossing interpolate(double above, double below, double level) {
  if (below <= 0) return {(above - level) / (above - below), below - above};
  const double decay = std::log(above / below);
  return {std::log(above / level) / decay, -level * decay};
}

}  // namespace

std::optional<Crossing> first_crossing(const Eigen::ArrayXd& profile, double level) {
  for (Index p = 0; p + 1 < profile.size(); ++p) {
    if (profile(p + 1) > level) continue;
    const Crossing within = interpolate(profile(p), profile(p + 1), level);
    return Crossing{static_cast<double>(p) + within.lag, within.slope};
  }
  return std::nullopt;
}

}  // namespace asperity
