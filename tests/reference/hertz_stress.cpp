#include "reference/hertz_stress.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace asperity {
namespace {

// (3) of the header.
double load_within(double x, double y) {
  x = std::clamp(x, -1.0, 1.0), y = std::clamp(y, -1.0, 1.0);
  const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y));
  return (x * y * w + 0.5 * x * (3 - x * x) * std::atan2(y, w) + 0.5 * y * (3 - y * y) * std::atan2(x, w) -
          std::atan2(x * y, w)) /
         3;
}

// (1) of the header.
stress::Tensor pressed(double x, double y, double z, double nu) {
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

using Complex = std::complex<double>;

double H(const Complex& twice, const Complex& thrice) { return thrice.imag() - twice.real(); }

// (2) of the header. What has R below it is multiplied by z, which is 0 where R is.
stress::Tensor sheared(double x, double y, double z, double nu) {
  const double r2 = x * x + y * y;
  const Complex zeta{z, 1}, R = std::sqrt(Complex{r2 + z * z - 1, 2 * z}), s = R + zeta, s2 = s * s;
  const Complex over_R = z == 0 ? 0 : 1.0 / R, F1 = std::log(s), F2 = zeta * F1 - R;
  const Complex A2 = -1.0 / s, A3 = -0.5 * (F1 + zeta / s), B3 = -0.5 / s2,
                B4 = (1.0 + r2 / 3 / s2) / (4.0 * s), B5 = (F1 - r2 / s2 * (2.0 / 3 + r2 / 12 / s2)) / 8.0,
                C3 = over_R / (s * s2), C4 = -1.0 / (3.0 * s * s2), C5 = (1.0 + 0.5 * r2 / s2) / (12.0 * s2);
  const double a = H(A2, A3), b3 = H(over_R / s2, B3), b4 = H(B3, B4), b5 = H(B4, B5), c4 = H(C3, C4),
               c5 = H(C4, C5);
  auto third = [&](double times, double square) {
    return 2 * nu * (times * b5 + square * c5) - z * (times * b4 + square * c4);
  };
  return {x * (2 * (1 + nu) * a + third(3, x * x)),
          x * (2 * nu * a + third(1, y * y)),
          -z * x * H(over_R / s, A2),
          y * (a + third(1, x * x)),
          H(F1, F2) - z * (a + x * x * b3),
          -z * x * y * b3};
}

}  // namespace

stress::Tensor hertz_stress(double x, double y, double z, double nu, stress::Traction load) {
  if (load == stress::normal) return pressed(x, y, z, nu);
  if (load == stress::shear_x) return sheared(x, y, z, nu);
  return stress::exchanged(sheared(y, x, z, nu));
}

stress::Tensor hertz_stress(double x, double y, double z, double nu, const Friction& friction) {
  const auto weights = friction.weights();
  stress::Tensor sum{};
  for (stress::Traction t : stress::tractions) {
    const stress::Tensor s = weights[t] == 0 ? stress::Tensor{} : hertz_stress(x, y, z, nu, t);
    for (stress::Component c : stress::components) sum[c] += weights[t] * s[c];
  }
  return sum;
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
