// Models and waves of a period, by sums as they are written.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "acf/band_limited.hpp"
#include "support.hpp"

namespace asperity::test {

inline constexpr double turn = 2 * std::numbers::pi;

inline EllipticTarget self_affine(double hurst, double rolloff) {
  EllipticTarget out;
  out.model = Model::self_affine;
  out.hurst = hurst;
  out.length_x = out.length_y = length_for_rolloff(out, rolloff);
  return out;
}

// Σ R(p,q) cos(2π(jp/N + kq/M)) over the torus; `lags` even under point reflection.
inline double power_at(const std::function<double(Index, Index)>& lags, Shape period, Index j, Index k) {
  double sum = 0;
  for (Index p = 0; p < period.nx; ++p)
    for (Index q = 0; q < period.ny; ++q)
      sum += lags(p, q) *
             std::cos(turn * (static_cast<double>(j * p % period.nx) / static_cast<double>(period.nx) +
                              static_cast<double>(k * q % period.ny) / static_cast<double>(period.ny)));
  return sum;
}

// A half plane of lags up to half a period, anywhere on the torus.
inline auto on_torus(const Field& half_plane, Shape period) {
  return [&half_plane, period](Index p, Index q) {
    const Index middle = half_plane.cols() / 2;
    const bool turned = 2 * p > period.nx;
    const Index row = turned ? period.nx - p : p, column = turned ? -q : q;
    const Index wrapped = ((column % period.ny) + period.ny) % period.ny;
    return half_plane(row, middle + (2 * wrapped > period.ny ? wrapped - period.ny : wrapped));
  };
}

inline double wave_number(Shape period, Index a, Index b) {
  const Index j = 2 * a > period.nx ? a - period.nx : a, k = 2 * b > period.ny ? b - period.ny : b;
  return turn * std::hypot(static_cast<double>(j) / static_cast<double>(period.nx),
                           static_cast<double>(k) / static_cast<double>(period.ny));
}

// The transform of the kernel over the torus; its square is every wave's power.
inline double amplitude(const Field& kernel, Index j, Index k) {
  double real = 0, imaginary = 0;
  for (Index p = 0; p < kernel.rows(); ++p)
    for (Index q = 0; q < kernel.cols(); ++q) {
      const double phase =
          turn * (static_cast<double>(j * p % kernel.rows()) / static_cast<double>(kernel.rows()) +
                  static_cast<double>(k * q % kernel.cols()) / static_cast<double>(kernel.cols()));
      real += kernel(p, q) * std::cos(phase), imaginary += kernel(p, q) * std::sin(phase);
    }
  return std::hypot(real, imaginary);
}

}  // namespace asperity::test
