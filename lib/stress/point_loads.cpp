// Compiled with finite-math-only arithmetic where that gives vectors, as stress/corner_tile.cpp.
#include "stress/point_loads.hpp"

#include <cmath>

namespace asperity {
namespace {

constexpr int lanes = static_cast<int>(lattice_side);
enum { xx, yy, zz, xy, xz, yz };

struct Sums {
  alignas(64) double of[6][lanes] = {};
};

// Boussinesq: a row of loads at one x.
inline void press(double x, const double* y, const double* force, double z, double k, Sums& sums) {
  for (int l = 0; l < lanes; ++l) {
    const double r2 = x * x + y[l] * y[l] + z * z, r = std::sqrt(r2), i = 1 / r, i3 = i * i * i,
                 s = 1 / (r + z), f = force[l], slope = k * i * s, bend = k * (2 * r + z) * i3 * s * s,
                 v = 3 * z * i3 * i * i, V = z * i3;
    const double nu2 = 1 - k;  // 2ν
    sums.of[xx][l] += f * (-nu2 * V - v * x * x + V - slope + x * x * bend);
    sums.of[yy][l] += f * (-nu2 * V - v * y[l] * y[l] + V - slope + y[l] * y[l] * bend);
    sums.of[zz][l] -= f * v * z * z;
    sums.of[xy][l] -= f * x * y[l] * (v - bend);
    sums.of[xz][l] -= f * v * x * z;
    sums.of[yz][l] -= f * v * y[l] * z;
  }
}

// Cerruti, along x.
inline void shear_x(double x, const double* y, const double* force, double z, double k, double weight,
                    Sums& sums) {
  for (int l = 0; l < lanes; ++l) {
    const double b = y[l], r2 = x * x + b * b + z * z, r = std::sqrt(r2), i = 1 / r, i3 = i * i * i,
                 s = 1 / (r + z), f = weight * force[l], C = i * s * s, B = (3 * r + z) * i3 * s * s * s,
                 D = -3 * x * i3 * i * i;
    sums.of[xx][l] += f * (D * x * x + k * x * (i3 - 3 * C + x * x * B));
    sums.of[yy][l] += f * (D * b * b + k * x * (i3 - C + b * b * B));
    sums.of[zz][l] += f * D * z * z;
    sums.of[xy][l] += f * (D * x * b + k * b * (x * x * B - C));
    sums.of[xz][l] += f * D * x * z;
    sums.of[yz][l] += f * D * b * z;
  }
}

// Along y.
inline void shear_y(double x, const double* y, const double* force, double z, double k, double weight,
                    Sums& sums) {
  for (int l = 0; l < lanes; ++l) {
    const double b = y[l], r2 = x * x + b * b + z * z, r = std::sqrt(r2), i = 1 / r, i3 = i * i * i,
                 s = 1 / (r + z), f = weight * force[l], C = i * s * s, B = (3 * r + z) * i3 * s * s * s,
                 D = -3 * b * i3 * i * i;
    sums.of[xx][l] += f * (D * x * x + k * b * (i3 - C + x * x * B));
    sums.of[yy][l] += f * (D * b * b + k * b * (i3 - 3 * C + b * b * B));
    sums.of[zz][l] += f * D * z * z;
    sums.of[xy][l] += f * (D * x * b + k * x * (b * b * B - C));
    sums.of[xz][l] += f * D * x * z;
    sums.of[yz][l] += f * D * b * z;
  }
}

}  // namespace

void add_point_loads(const double* x, const double* y, const double* force, double z, double poisson,
                     const double weights[3], double out[6]) {
  Sums sums;
  const double k = 1 - 2 * poisson;
  for (int m = 0; m < lanes; ++m) press(x[m], y, force + lanes * m, z, k, sums);
  if (weights[1] != 0)
    for (int m = 0; m < lanes; ++m) shear_x(x[m], y, force + lanes * m, z, k, weights[1], sums);
  if (weights[2] != 0)
    for (int m = 0; m < lanes; ++m) shear_y(x[m], y, force + lanes * m, z, k, weights[2], sums);
  for (int c = 0; c < 6; ++c)
    for (int l = 0; l < lanes; ++l) out[c] += sums.of[c][l];
}

}  // namespace asperity
