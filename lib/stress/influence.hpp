/// Stress below a uniformly loaded rectangle on the surface of an elastic half-space.
///
/// Under p = 1 or the traction q_x = 1 on |x| ≤ a, |y| ≤ b the stress is a sum over four corners [1, 2],
///     2π σ = S[f] = f(x+a, y+b) - f(x-a, y+b) - f(x+a, y-b) + f(x-a, y-b),                        (1)
/// of the corner functions f(X, Y), with r² = X² + Y² + z²,
///          pressure                              traction along x
///     xx   -2νT + F(X,Y) - (1-2ν) A              2 L(X,Y) + W(Y) - G(X,Y)
///     yy   -2νT + F(Y,X) - (1-2ν) (T-A)          2ν L(X,Y) - W(Y)
///     zz   -T - F(X,Y) - F(Y,X)                  G(X,Y)                                            (2)
///     xy   -z/r - (1-2ν) ln(r+z)                 L(Y,X) - W(X)
///     xz   G(X,Y)                                F(X,Y) - T
///     yz   G(Y,X)                                -z/r
///     T = atan2(XY, zr)                          F(X,Y) = zXY / (r(X²+z²))
///     A = atan2(XY(X²+Y²)/(r+z), X²r + zY²)      G(X,Y) = z²Y / (r(X²+z²))                          (3)
///     L(X,Y) = asinh(Y/√(X²+z²))                 W(Y) = Y (2νr + z) / (r(r+z)).
/// A traction along y is that along x with x and y exchanged. Written so, nothing cancels inside a corner:
/// r-z never occurs, and T, A stay within their branches. At the surface F = G = z/r = 0 and T = ±π/2, its
/// mean 0 on an edge: σzz of a pressure, and σxz of a traction, is -1 inside, -½ on an edge, -¼ at a corner.
///
/// At the surface the step of the load makes some components grow as the logarithm of the distance to it: σxx
/// and σyy of a traction at the edges across it, σxy at those along it, σxy of a pressure at a corner. On the
/// line itself half a side over π stands for the distance 0: neighbouring rectangles of one load and size
/// still cancel there, and the stress of a smooth load cut into cells stays finite and right to order 2.
///
/// Symbols   a, b  half sides [m]     z  depth, ≥ 0 [m]     ν  Poisson's number     σ  stress over pressure
/// Accuracy  |error| ≤ 2e-15; relative to the largest component 1e-13 near the rectangle, growing as its
///           distance cubed, since (1) cancels: 1e-9 at a hundred half sides.
///
/// [1] A. E. H. Love, The stress produced in a semi-infinite solid by pressure on part of the boundary,
///     Phil. Trans. R. Soc. A 228 (1929) 377-420.
/// [2] S. Liu, Q. Wang, Studying contact stress fields caused by surface tractions with a discrete
///     convolution and fast Fourier transform algorithm, J. Tribology 124 (2002) 36-45.
#pragma once

#include <cmath>
#include <type_traits>

#include "core/field.hpp"
#include "stress/component.hpp"

namespace asperity {

/// (1): the stress at (x, y, z) under a unit load on the rectangle |x| ≤ a, |y| ≤ b.
stress::Tensor rectangle_stress(double x, double y, double z, double a, double b, double poisson,
                                stress::Traction load = stress::normal);

/// The stress at (x, y, z) ≠ 0 under a unit force at the origin, with ρ² = x² + y² + z². Along +z
/// (Boussinesq), with V = 1/ρ, χ = ln(ρ+z):
///     2π σxx = 2ν V_z - z V_xx - (1-2ν) χ_xx,   2π σxy = -z V_xy - (1-2ν) χ_xy,
///     2π σzz = V_z - z V_zz,                    2π σxz = -z V_xz;   yy and yz likewise.
/// Along +x (Cerruti), with C = 1/(ρ(ρ+z)²), B = (3ρ+z)/(ρ³(ρ+z)³):
///     2π σxx = -3x³/ρ⁵  + (1-2ν) x (1/ρ³ - 3C + x² B),   2π σxy = -3x²y/ρ⁵ + (1-2ν) y (x² B - C),
///     2π σyy = -3xy²/ρ⁵ + (1-2ν) x (1/ρ³ - C + y² B),    2π σiz = -3 x i z/ρ⁵,  i = x, y, z.
stress::Tensor point_load_stress(double x, double y, double z, double poisson,
                                 stress::Traction load = stress::normal);

/// The same at any distance without loss of digits: from five half sides on, where (1) begins to cancel, the
/// point load is integrated over the rectangle by Gauss's rule of 8 × 8 points, of 4 × 4 from fifty on.
/// Relative error of the largest component 4e-13.
stress::Tensor uniform_load_stress(double x, double y, double z, double a, double b, double poisson,
                                   stress::Traction load = stress::normal);

namespace stress {

/// Below one mode of a periodic load, or below each of an array of modes: (3), (4) of
/// stress/layer_influence.hpp. The wave numbers may be negative; of a single mode both zero are the mean
/// load.
template <class Real>
struct Waves {
  Real qx, qy;
  double z, nu;
  Real q = wave_number(qx, qy), e = decayed(-z * q);

  /// S of component c under traction t.
  Real operator()(Traction t, Component c) const {
    if constexpr (std::is_same_v<Real, double>)
      if (q == 0) return mean(t, c);
    if (t == normal) return pressed(c);
    return t == shear_x ? sheared(qx, qy, c) : sheared(qy, qx, exchanged(c));
  }

 private:
  static double wave_number(double x, double y) { return std::hypot(x, y); }
  static Eigen::ArrayXd wave_number(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
    return (x.square() + y.square()).sqrt();
  }
  static double decayed(double exponent) { return std::exp(exponent); }
  static Eigen::ArrayXd decayed(const Eigen::ArrayXd& exponent) { return exponent.exp(); }

  double mean(Traction t, Component c) const {
    if (t == shear_x) return c == xz ? -1 : 0;
    if (t == shear_y) return c == yz ? -1 : 0;
    if (c == zz) return -1;
    return c == xx || c == yy ? -nu / (1 - nu) : 0;
  }

  Real pressed(Component c) const {
    const Real bend = ((1 - 2 * nu) / q - z) / q;
    if (c == xx) return -(2 * nu + qx * qx * bend) * e;
    if (c == yy) return -(2 * nu + qy * qy * bend) * e;
    if (c == zz) return -(1 + q * z) * e;
    if (c == xy) return qx * qy * bend * e;
    if (c == xz) return -qx * z * e;
    return -qy * z * e;
  }

  // By a traction along the axis of `along`.
  Real sheared(const Real& along, const Real& across, Component c) const {
    const Real k = z + 2 * nu / q, w = e / q;
    if (c == xx) return -along * (2 + 2 * nu - k * along * along / q) * w;
    if (c == yy) return -along * (2 * nu - k * across * across / q) * w;
    if (c == zz) return -along * q * z * w;
    if (c == xy) return -across * (1 - k * along * along / q) * w;
    if (c == xz) return -(q - z * along * along) * w;
    return -along * across * z * w;
  }
};

using Wave = Waves<double>;

}  // namespace stress
}  // namespace asperity
