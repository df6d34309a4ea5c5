#include "stress/hertz.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// ∫ √(c²-y²) dy from 0 to y, c² = 1-x², constant beyond the edge.
double integral_to(double y, double x) {
  const double c2 = std::max(0.0, 1 - x * x), c = std::sqrt(c2);
  if (c == 0) return 0;
  const double t = std::clamp(y, -c, c);
  return 0.5 * (t * std::sqrt(std::max(0.0, c2 - t * t)) + c2 * std::asin(std::clamp(t / c, -1.0, 1.0)));
}

// ∫ over a ≤ x ≤ b, within the contact, of a function with root singularities at x = ±1: x = sin t, midpoints.
template <class Function>
double integrate(double a, double b, Function f) {
  constexpr int points = 64;
  const double from = std::asin(std::clamp(a, -1.0, 1.0)), to = std::asin(std::clamp(b, -1.0, 1.0));
  const double h = (to - from) / points;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double t = from + (k + 0.5) * h;
    sum += f(std::sin(t)) * std::cos(t);
  }
  return sum * h;
}

}  // namespace

stress::Tensor hertz_stress(double x, double y, double z, double nu) {
  const double r = std::hypot(x, y), s = r * r + z * z - 1, root = std::hypot(s, 2 * z);
  const double u = s > 0 ? 0.5 * (s + root) : z == 0 ? 0 : 2 * z * z / (root - s), sqrt_u = std::sqrt(u);
  const bool inside = z == 0 && s < 0;
  const double w = inside ? std::sqrt(-s) : z == 0 ? 0 : z / sqrt_u;
  const double d = inside ? 1 / (w * w) : u == 0 ? 0 : u / (u * u + z * z);
  const double Q = (1 + w + w * w) / ((1 + w) * (1 + u)), alpha = std::atan2(1, sqrt_u), k = (1 - 2 * nu) / 3;
  const double szz = -w * w * w * d, srz = z == 0 ? 0 : -r * z * z * sqrt_u / ((u * u + z * z) * (1 + u));
  const double mixed = u * (1 - nu) / (1 + u), turned = (1 + nu) * sqrt_u * alpha;
  const double srr = k * Q - szz + w * (mixed + turned - 2), stt = -k * Q - w * (2 * nu + mixed - turned);
  const double cosine = r > 0 ? x / r : 1, sine = r > 0 ? y / r : 0;
  return {srr * cosine * cosine + stt * sine * sine,
          srr * sine * sine + stt * cosine * cosine,
          szz,
          (srr - stt) * cosine * sine,
          srz * cosine,
          srz * sine};
}

Field hertz_pressure(const Grid& grid) {
  const double hx = grid.dx / 2, hy = grid.dy / 2;
  return sample(grid, [&](double x, double y) {
    auto strip = [&](double at) { return integral_to(y + hy, at) - integral_to(y - hy, at); };
    return integrate(x - hx, x + hx, strip) / grid.cell_area();
  });
}

}  // namespace asperity
