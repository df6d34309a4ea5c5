#include "stats/spatial/acf_lobe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/words.hpp"
#include "math/linear_algebra.hpp"
#include "stats/spatial/acf_length.hpp"

namespace asperity {
namespace {

struct Lag {
  Index p, q;
};
constexpr Lag neighbours[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

struct Contour {
  std::vector<Eigen::Vector2d> points;  // [m]
  bool open = false;                    // the lobe reaches the longest lags, or lags at which ρ is not known
};

// The whole plane's lags, each once.
class Visited {
 public:
  explicit Visited(const LagField& rho)
      : columns_(2 * rho.max_q() + 1),
        origin_(rho.max_p() * columns_ + rho.max_q()),
        seen_(static_cast<std::size_t>((2 * rho.max_p() + 1) * columns_)) {}
  bool first_visit(Lag lag) {
    const auto index = static_cast<std::size_t>(origin_ + lag.p * columns_ + lag.q);
    const bool first = !seen_[index];
    seen_[index] = true;
    return first;
  }

 private:
  Index columns_, origin_;
  std::vector<bool> seen_;
};

Contour contour_of_lobe(const LagField& rho, const Grid& grid, double level) {
  Contour out;
  Visited visited(rho);
  std::vector<Lag> pending{{0, 0}};
  visited.first_visit({0, 0});
  while (!pending.empty()) {
    const Lag at = pending.back();
    pending.pop_back();
    for (const auto& [dp, dq] : neighbours) {
      const Lag next{at.p + dp, at.q + dq};
      const bool beyond = std::abs(next.p) > rho.max_p() || std::abs(next.q) > rho.max_q();
      if (const double value = rho(next.p, next.q); beyond || std::isnan(value)) {
        out.open = true;
      } else if (value > level) {
        if (visited.first_visit(next)) pending.push_back(next);
      } else {
        const double step = crossing_between(rho(at.p, at.q), value, level).lag;
        out.points.emplace_back((static_cast<double>(at.p) + step * static_cast<double>(dp)) * grid.dx,
                                (static_cast<double>(at.q) + step * static_cast<double>(dq)) * grid.dy);
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

// (3) on points in units of `scale`.
std::optional<LobeEllipse> fitted_ellipse(const std::vector<Eigen::Vector2d>& points, double scale) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Eigen::Vector2d& point : points) {
    const double x = point.x() / scale, y = point.y() / scale;
    const Eigen::Vector3d row(x * x, 2 * x * y, y * y);
    normal += row * row.transpose();
    right += row;
  }
  const Eigen::Vector3d form = solve(normal, right);
  const double middle = 0.5 * (form[0] + form[2]), spread = std::hypot(0.5 * (form[0] - form[2]), form[1]);
  if (!(middle - spread > 0)) return std::nullopt;
  const double across = 0.5 * std::atan2(2 * form[1], form[0] - form[2]);
  return LobeEllipse{{scale / std::sqrt(middle - spread), axis_angle(across + std::numbers::pi / 2)},
                     scale / std::sqrt(middle + spread)};
}

}  // namespace

CentralLobe central_lobe(const LagField& rho, const Grid& grid, double level) {
  if (!(level > 0 && level < 1))
    throw ParameterError("acf-level", "value " + shortest(level) + " is outside 0 to 1");
  const Contour contour = contour_of_lobe(rho, grid, level);
  CentralLobe out;
  if (contour.points.empty()) return out;
  auto nearer = [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); };
  const auto [nearest, farthest] = std::ranges::minmax_element(contour.points, nearer);
  const double edge =
      std::min(static_cast<double>(rho.max_p()) * grid.dx, static_cast<double>(rho.max_q()) * grid.dy);
  if (!contour.open || nearest->norm() <= edge) out.r_min = reach(*nearest);
  if (contour.open) return out;
  out.r_max = reach(*farthest);
  out.ellipse = fitted_ellipse(contour.points, nearest->norm());
  return out;
}

}  // namespace asperity
