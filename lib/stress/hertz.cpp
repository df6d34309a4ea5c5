#include "stress/hertz.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

// (2) of the header.
double load_within(double x, double y) {
  x = std::clamp(x, -1.0, 1.0), y = std::clamp(y, -1.0, 1.0);
  const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  return (x * y * w + 0.5 * x * (3 - x * x) * std::atan2(y, w) + 0.5 * y * (3 - y * y) * std::atan2(x, w) -
          std::atan2(x * y, w)) /
         3;
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
    const double load = load_within(x + hx, y + hy) - load_within(x - hx, y + hy) -
                        load_within(x + hx, y - hy) + load_within(x - hx, y - hy);
    return load / grid.cell_area();
  });
}

}  // namespace asperity
