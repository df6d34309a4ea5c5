#include "stats/spatial/acf_length.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/words.hpp"
#include "math/linear_algebra.hpp"

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

constexpr Shape neighbours[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

struct Contour {
  std::vector<Eigen::Vector2d> points;  // [m]
  bool open = false;                    // the lobe reaches the longest lags, or lags at which ρ is not known
};

Contour contour_of_lobe(const LagField& rho, const Grid& grid, double level) {
  Contour out;
  const Index P = rho.max_p(), Q = rho.max_q();
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> seen =
      Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>::Zero(2 * P + 1, 2 * Q + 1);
  std::vector<Shape> pending{{0, 0}};
  seen(P, Q) = true;
  while (!pending.empty()) {
    const auto [p, q] = pending.back();
    pending.pop_back();
    for (const auto& [dp, dq] : neighbours) {
      const double value = rho(p + dp, q + dq);
      if (std::abs(p + dp) > P || std::abs(q + dq) > Q || std::isnan(value)) {
        out.open = true;
      } else if (value > level) {
        if (!std::exchange(seen(P + p + dp, Q + q + dq), true)) pending.push_back({p + dp, q + dq});
      } else {
        const double step = crossing_between(rho(p, q), value, level).lag;
        out.points.emplace_back((static_cast<double>(p) + step * static_cast<double>(dp)) * grid.dx,
                                (static_cast<double>(q) + step * static_cast<double>(dq)) * grid.dy);
      }
    }
  }
  return out;
}

double axis_angle(double angle) {
  const double turns = std::round(angle / std::numbers::pi), axis = angle - turns * std::numbers::pi;
  return axis > -std::numbers::pi / 2 ? axis : axis + std::numbers::pi;
}

Reach reach(const Eigen::Vector2d& point) {
  return {point.norm(), axis_angle(std::atan2(point.y(), point.x()))};
}

// [A B; B C] of (5) on points in units of `scale`.
Eigen::Matrix2d fitted_form(const std::vector<Eigen::Vector2d>& points, double scale) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& point : points) {
    const double x = point.x() / scale, y = point.y() / scale;
    const Eigen::Vector3d row(x * x, 2 * x * y, y * y);
    normal += row * row.transpose();
    right += row;
  }
  const Eigen::Vector3d form = solve(normal, right);
  return (Eigen::Matrix2d() << form[0], form[1], form[1], form[2]).finished();
}

// None if the form is no ellipse.
std::optional<LobeEllipse> ellipse_of(const Eigen::Matrix2d& form, double scale) {
  const double middle = 0.5 * form.trace(), spread = std::hypot(0.5 * (form(0, 0) - form(1, 1)), form(0, 1));
  if (!(middle - spread > 0)) return std::nullopt;
  const double across = 0.5 * std::atan2(2 * form(0, 1), form(0, 0) - form(1, 1));
  return LobeEllipse{{scale / std::sqrt(middle - spread), axis_angle(across + std::numbers::pi / 2)},
                     scale / std::sqrt(middle + spread)};
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

CentralLobe central_lobe(const LagField& rho, const Grid& grid, double level) {
  if (!(level > 0 && level < 1))
    throw ParameterError("sal-level", "'" + shortest(level) + "' is not a number between 0 and 1");
  const Contour contour = contour_of_lobe(rho, grid, level);
  CentralLobe out;
  if (contour.points.empty()) return out;
  auto nearer = [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); };
  const auto [nearest, farthest] = std::ranges::minmax_element(contour.points, nearer);
  const double edge =
      std::min(static_cast<double>(rho.max_p()) * grid.dx, static_cast<double>(rho.max_q()) * grid.dy);
  if (!contour.open || nearest->norm() <= edge) out.r_min = reach(*nearest);
  const double scale = nearest->norm();
  const Eigen::Matrix2d form = fitted_form(contour.points, scale);
  out.anisotropy = Eigen::Vector2d(form(1, 1) - form(0, 0), -2 * form(0, 1)) / form.trace();
  if (contour.open) return out;
  out.r_max = reach(*farthest);
  out.ellipse = ellipse_of(form, scale);
  return out;
}

}  // namespace asperity
