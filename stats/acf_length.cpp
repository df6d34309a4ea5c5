#include "stats/acf_length.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// ρ at the whole lag `along` and the broken one `across`.
double between_lags(const LagField& rho, bool x, Index along, double across) {
  const double whole = std::floor(across), fraction = across - whole;
  auto at = [&](Index other) { return x ? rho(along, other) : rho(other, along); };
  const double lower = at(static_cast<Index>(whole));
  if (fraction == 0) return lower;
  const double upper = at(static_cast<Index>(whole) + 1);
  if (lower > 0 && upper > 0) return lower * std::pow(upper / lower, fraction);
  return lower + fraction * (upper - lower);
}

}  // namespace

Crossing crossing_between(double above, double below, double level) {
  const Crossing linear{(above - level) / (above - below), below - above};
  if (below <= 0) return linear;
  const double decay = std::log(above / below), share = std::min(1.0, std::pow(2 * below / level, 2));
  const Crossing exponential{std::log(above / level) / decay, -level * decay};
  return {std::lerp(linear.lag, exponential.lag, share), std::lerp(linear.slope, exponential.slope, share)};
}

std::optional<Crossing> first_crossing(const Eigen::ArrayXd& profile, double level) {
  for (Index p = 0; p + 1 < profile.size(); ++p) {
    if (std::isnan(profile(p + 1))) return std::nullopt;
    if (profile(p + 1) > level) continue;
    const Crossing within = crossing_between(profile(p), profile(p + 1), level);
    return Crossing{static_cast<double>(p) + within.lag, within.slope};
  }
  return std::nullopt;
}

std::optional<Crossing> first_crossing(const LagField& rho, const Grid& grid, double angle, double level) {
  const double across_x = std::cos(angle) / grid.dx, across_y = std::sin(angle) / grid.dy;  // lags per metre
  const bool x = std::abs(across_x) >= std::abs(across_y);
  const double lean = x ? across_y / across_x : across_x / across_y,
               lags_per_metre = std::hypot(across_x, across_y);
  const Index last = x ? rho.max_p() : rho.max_q(), side = x ? rho.max_q() : rho.max_p();
  const auto reach =
      static_cast<Index>(std::min(static_cast<double>(last), static_cast<double>(side) / std::abs(lean)));
  const Eigen::ArrayXd profile = Eigen::ArrayXd::NullaryExpr(
      reach + 1, [&](Index lag) { return between_lags(rho, x, lag, lean * static_cast<double>(lag)); });
  const auto crossing = first_crossing(profile, level);
  if (!crossing) return std::nullopt;
  const double step = std::hypot(1, lean) / lags_per_metre;
  return Crossing{crossing->lag * step, crossing->slope / step};
}

}  // namespace asperity
