/// Point loads and rectangles in long double, by other formulas than the library's: Johnson's, integrated.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "stress/component.hpp"

namespace asperity::test {

/// Nodes and weights of n points on [-1, 1]: Newton's method on Legendre's recurrence.
inline std::vector<std::pair<double, double>> gauss_legendre(int n) {
  std::vector<std::pair<double, double>> rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int step = 0; step < 8; ++step) {
      double before = 1, p = x;
      for (int k = 2; k <= n; ++k) before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.emplace_back(x, 2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

using LongTensor = std::array<long double, 6>;

/// K. L. Johnson, Contact Mechanics, (3.18), (3.19) and (3.76): unit force at the origin. Off the axis.
inline LongTensor johnson(long double x, long double y, long double z, long double nu,
                          stress::Traction load) {
  const long double q = x * x + y * y, r = std::sqrt(q + z * z), r3 = r * r * r, r5 = r3 * r * r;
  const long double k = 1 - 2 * nu, s = r + z, pi2 = 2 * std::numbers::pi_v<long double>;
  if (load == stress::shear_y) {
    const LongTensor t = johnson(y, x, z, nu, stress::shear_x);
    return {t[1], t[0], t[2], t[3], t[5], t[4]};
  }
  LongTensor out;
  if (load == stress::shear_x) {
    const long double first = 1 / (r * s * s), second = 1 / (r3 * s * s), third = 2 / (r * r * s * s * s);
    out = {k * (x / r3 - 3 * x * first + x * x * x * (second + third)) - 3 * x * x * x / r5,
           k * (x / r3 - x * first + x * y * y * (second + third)) - 3 * x * y * y / r5,
           -3 * x * z * z / r5,
           k * (-y * first + x * x * y * (second + third)) - 3 * x * x * y / r5,
           -3 * x * x * z / r5,
           -3 * x * y * z / r5};
  } else {
    const long double side = q / (r * s);  // 1 - z/r
    out = {k / q * (side * (x * x - y * y) / q + z * y * y / r3) - 3 * z * x * x / r5,
           k / q * (side * (y * y - x * x) / q + z * x * x / r3) - 3 * z * y * y / r5,
           -3 * z * z * z / r5,
           k / q * (2 * side * x * y / q - x * y * z / r3) - 3 * x * y * z / r5,
           -3 * x * z * z / r5,
           -3 * y * z * z / r5};
  }
  for (long double& c : out) c /= pi2;
  return out;
}

/// johnson() over the rectangle |x| ≤ a, |y| ≤ b: panels of half a depth's half side at the most, 16 × 16
/// Gauss points each, which converge as (2 + √5)^-32 = 1e-20.
inline LongTensor integrated_rectangle(double x, double y, double z, double a, double b, double nu,
                                       stress::Traction load) {
  static const auto rule = gauss_legendre(16);
  const int nx = static_cast<int>(std::ceil(2 * a / z)), ny = static_cast<int>(std::ceil(2 * b / z));
  const long double hx = static_cast<long double>(a) / nx, hy = static_cast<long double>(b) / ny;
  LongTensor sum{};
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (auto [u, wu] : rule)
        for (auto [v, wv] : rule) {
          const long double px = hx * (2 * i + 1 + static_cast<long double>(u)) - a;
          const long double py = hy * (2 * j + 1 + static_cast<long double>(v)) - b;
          const LongTensor s = johnson(x - px, y - py, z, nu, load);
          for (auto c : stress::components)
            sum[c] += static_cast<long double>(wu) * static_cast<long double>(wv) * hx * hy * s[c];
        }
  return sum;
}

}  // namespace asperity::test
