#include "stress/peak.hpp"

#include <algorithm>
#include <cmath>

#include "core/calibration.hpp"
#include "stress/layers.hpp"

namespace asperity {
namespace {

using calibration::stress::scan_ratio;

constexpr double wide_step = 0.15, narrow_step = 0.03;  // of the depth
constexpr double settled = 3e-10;                       // of the value: what a step would gain
constexpr int most_steps = 24;

using Vector = std::array<double, 3>;
using Symmetric = std::array<Vector, 3>;

// x of (damping - H) x = g in the free directions, 0 in the others; false where that matrix is not positive.
bool solve(const Symmetric& h, const Vector& g, const std::array<bool, 3>& held, double damping, Vector& x) {
  Symmetric l{};
  Vector y{};
  auto a = [&](std::size_t i, std::size_t j) {
    if (held[i] || held[j]) return i == j ? 1.0 : 0.0;
    return (i == j ? damping : 0.0) - h[i][j];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a(i, j);
      for (std::size_t k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
      if (i == j && !(sum > 0)) return false;
      l[i][j] = i == j ? std::sqrt(sum) : sum / l[j][j];
    }
    y[i] = held[i] ? 0 : g[i];
    for (std::size_t k = 0; k < i; ++k) y[i] -= l[i][k] * y[k];
    y[i] /= l[i][i];
  }
  for (std::size_t i = 3; i-- > 0;) {
    x[i] = y[i];
    for (std::size_t k = i + 1; k < 3; ++k) x[i] -= l[k][i] * x[k];
    x[i] /= l[i][i];
  }
  return true;
}

double largest(const Vector& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

}  // namespace

// f and its differences in units of `scale`.
struct PeakClimber::Model {
  double scale = 0;
  Vector slope{};
  Symmetric bend{};
};

PeakClimber::PeakClimber(const LoadedBody& body, Criterion of, double below, int threads)
    : body_(body),
      of_(of),
      below_(below),
      field_(std::max(0.5 * accurate_depth(body.grid), below)),
      shallowest_(0.1 * std::min(body.grid.dx, body.grid.dy)) {
  if (body.grid.periodic.any())
    points_ = std::make_unique<StressPoints>(body, threads);
  else
    tree_ = std::make_unique<CellTree>(body);
}

double PeakClimber::value(double x, double y, double z) const {
  return equivalent_stress(of_, tree_ ? tree_->at(x, y, z) : points_->at(x, y, z));
}

PeakClimber::Model PeakClimber::model(const StressPlace& at, double step) const {
  const double d = step * std::max(at.z, shallowest_);
  const auto& [shape, dx, dy, periodic] = body_.grid;
  const std::array<bool, 3> level{periodic.x && shape.nx == 1, periodic.y && shape.ny == 1, false};
  auto f = [&](double a, double b, double c) { return value(at.x + a * d, at.y + b * d, at.z + c * d); };
  Model out{d, {}, {}};
  std::array<double, 3> up{}, down{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (level[i]) {
      up[i] = down[i] = at.value;
      continue;
    }
    up[i] = f(i == 0, i == 1, i == 2);
    down[i] = f(i == 0 ? -1 : 0, i == 1 ? -1 : 0, i == 2 ? -1 : 0);
    out.slope[i] = 0.5 * (up[i] - down[i]);
    out.bend[i][i] = up[i] - 2 * at.value + down[i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (level[i] || level[j]) continue;
      auto both = [&](double s) {
        return f(i == 0 || j == 0 ? s : 0, i == 1 || j == 1 ? s : 0, i == 2 || j == 2 ? s : 0);
      };
      out.bend[i][j] = out.bend[j][i] =
          0.5 * (both(1) + both(-1) + 2 * at.value - up[i] - down[i] - up[j] - down[j]);
    }
  return out;
}

// Kept inside the cells' centres, where the domain is free, and below the depth from which the field counts.
StressPlace PeakClimber::moved(const StressPlace& from, const Vector& by) const {
  const Grid& g = body_.grid;
  auto inside = [](double place, bool periodic, double first, double last) {
    return periodic ? place : std::clamp(place, first, last);
  };
  StressPlace out{0, inside(from.x + by[0], g.periodic.x, g.x(0), g.x(g.shape.nx - 1)),
                  inside(from.y + by[1], g.periodic.y, g.y(0), g.y(g.shape.ny - 1)),
                  std::max(from.z + by[2], field_)};
  out.value = value(out.x, out.y, out.z);
  return out;
}

// Directions that lead out.
std::array<bool, 3> PeakClimber::held(const StressPlace& at, const Vector& slope) const {
  const Grid& g = body_.grid;
  auto at_end = [](double place, bool periodic, double first, double last, double up) {
    return !periodic && ((place <= first && up <= 0) || (place >= last && up >= 0));
  };
  return {at_end(at.x, g.periodic.x, g.x(0), g.x(g.shape.nx - 1), slope[0]),
          at_end(at.y, g.periodic.y, g.y(0), g.y(g.shape.ny - 1), slope[1]), at.z <= field_ && slope[2] <= 0};
}

StressPlace PeakClimber::field_peak(StressPlace from, double goal) const {
  StressPlace at = moved(from, {});
  double step = wide_step;
  for (int k = 0; k < most_steps; ++k) {
    const Model m = model(at, step);
    const std::array<bool, 3> out = held(at, m.slope);
    const double size = std::max(std::abs(m.bend[0][0]) + std::abs(m.bend[1][1]) + std::abs(m.bend[2][2]),
                                 1e-12 * std::abs(at.value));
    const double farthest_step = 0.4 / step;  // in units of the model's
    Vector s{};
    double damping = 1e-9 * size, gain = 0;
    StressPlace next = at;
    for (int tries = 0; tries < 12; ++tries, damping *= 8) {
      if (!solve(m.bend, m.slope, out, damping, s) || largest(s) > farthest_step) {
        damping = std::max(damping, 0.02 * size);
        continue;
      }
      gain = m.slope[0] * s[0] + m.slope[1] * s[1] + m.slope[2] * s[2];  // twice of it
      if (0.5 * gain <= settled * std::abs(at.value)) break;
      next = moved(at, {s[0] * m.scale, s[1] * m.scale, s[2] * m.scale});
      if (next.value > at.value) break;
      next = at;
      damping = std::max(damping, 0.02 * size);
    }
    const bool narrow = step <= narrow_step;
    if (at.value + 4 * gain + 0.01 * std::abs(at.value) < goal && k == 2) return at;
    if (!(next.value > at.value)) {
      if (narrow) break;
      step = narrow_step;
      continue;
    }
    if (0.5 * gain <= 1e-3 * std::abs(at.value)) step = narrow_step;
    at = next;
    if (narrow && 0.5 * gain <= settled * std::abs(at.value)) break;
  }
  return of_ == Criterion::von_mises ? at : creep(at);
}

StressPlace PeakClimber::creep(StressPlace at) const {
  for (double step = 0.05; step > 1e-6;) {
    StressPlace best = at;
    const double d = step * std::max(at.z, shallowest_);
    for (std::size_t i = 0; i < 3; ++i)
      for (double sign : {-1.0, 1.0}) {
        Vector by{};
        by[i] = sign * d;
        if (const StressPlace next = moved(at, by); next.value > best.value) best = next;
      }
    if (best.value - at.value <= 1e-9 * std::abs(at.value))
      step *= 0.4;
    else
      at = best;
  }
  return at;
}

StressPlace PeakClimber::climb(const StressPlace& from, double goal) const {
  auto higher = [](const StressPlace& a, const StressPlace& b) { return a.value < b.value ? b : a; };
  if (from.z < field_) {
    const StressPlace top = centres_peak(from);
    return scan_ratio * top.z < field_ ? top : higher(top, field_peak(top, std::max(goal, top.value)));
  }
  const StressPlace top = field_peak(from, goal);
  return top.z > field_ || field_ <= below_ ? top : higher(top, centres_peak(top));
}

}  // namespace asperity
