#include "stats/spatial/acf_length.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// (2).
double interpolated(double from, double to, double fraction) {
  if (to > from) return interpolated(to, from, 1 - fraction);
  if (to <= 0) return from + fraction * (to - from);
  return std::max(from * std::pow(to / from, fraction), from + fraction * (to / 2 - from));
}

// ρ at the whole lag `along` and the broken one `across`.
double between_lags(const LagField& rho, bool x, Index along, double across) {
  const double whole = std::floor(across), fraction = across - whole;
  auto at = [&](Index other) { return x ? rho(along, other) : rho(other, along); };
  const double lower = at(static_cast<Index>(whole));
  return fraction == 0 ? lower : interpolated(lower, at(static_cast<Index>(whole) + 1), fraction);
}

}  // namespace

Crossing crossing_between(double above, double below, double level) {
  const double end = below > 0 ? below / 2 : below, decay = std::log(above / below);
  const Crossing straight{(above - level) / (above - end), end - above};
  if (below <= 0) return straight;
  const Crossing exponential{std::log(above / level) / decay, -level * decay};
  return exponential.lag >= straight.lag ? exponential : straight;
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

Shape nearest_lag(const Grid& grid, double angle, double length) {
  const double along_x = std::cos(angle) / grid.dx, along_y = std::sin(angle) / grid.dy;
  const Shape lag{std::lround(length * along_x), std::lround(length * along_y)};
  if (lag != Shape{0, 0}) return lag;
  return std::abs(along_x) >= std::abs(along_y) ? Shape{1, 0} : Shape{0, 1};
}

}  // namespace asperity
