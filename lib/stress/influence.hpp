/// Stress below a uniformly loaded rectangle on the surface of an elastic half-space.
///
/// Under the pressure p = 1 on |x| ≤ a, |y| ≤ b the stress at (x, y, z) is a sum over four corners [1, 2],
///     2π σ = S[f] = f(x+a, y+b) - f(x-a, y+b) - f(x+a, y-b) + f(x-a, y-b),                        (1)
/// of the corner functions f(X, Y), with r² = X² + Y² + z²,
///     xx   -2νT + F(X,Y) - (1-2ν) A            xy   -z/r - (1-2ν) ln(r+z)
///     yy   -2νT + F(Y,X) - (1-2ν) (T-A)        xz   G(X,Y)                                        (2)
///     zz   -T - F(X,Y) - F(Y,X)                yz   G(Y,X)
///     T = atan2(XY, zr)                        F(X,Y) = zXY / (r(X²+z²))
///     A = atan2(XY(X²+Y²)/(r+z), X²r + zY²)    G(X,Y) = z²Y / (r(X²+z²))                          (3)
/// Written so, nothing cancels inside a corner: r-z never occurs, and T, A stay within their branches. At the
/// surface F = G = z/r = 0 and T = ±π/2, its mean 0 on an edge: σzz is -1 inside, -½ on an edge, -¼ at a corner.
///
/// Symbols   a, b  half sides [m]     z  depth, ≥ 0 [m]     ν  Poisson's number     σ  stress over pressure
/// Scope     everywhere but τxy at a corner itself, where it has a logarithmic singularity (ν < ½).
/// Accuracy  |error| ≤ 1e-15; relative to the largest component 1e-13 near the rectangle, growing as its
///           distance cubed, since (1) cancels: 1e-9 at a hundred half sides.
///
/// [1] A. E. H. Love, The stress produced in a semi-infinite solid by pressure on part of the boundary,
///     Phil. Trans. R. Soc. A 228 (1929) 377-420.
/// [2] S. Liu, Q. Wang, Studying contact stress fields caused by surface tractions with a discrete
///     convolution and fast Fourier transform algorithm, J. Tribology 124 (2002) 36-45.
#pragma once

#include "grid/field.hpp"
#include "stress/component.hpp"

namespace asperity {

/// (1): the stress at (x, y, z) under unit pressure on the rectangle |x| ≤ a, |y| ≤ b.
stress::Tensor rectangle_stress(double x, double y, double z, double a, double b, double poisson);

/// The stress at (x, y, z) ≠ 0 under a unit force at the origin along +z (Boussinesq), with V = 1/ρ, χ =
/// ln(ρ+z):
///     2π σxx = 2ν V_z - z V_xx - (1-2ν) χ_xx,   2π σxy = -z V_xy - (1-2ν) χ_xy,
///     2π σzz = V_z - z V_zz,                    2π σxz = -z V_xz;   yy and yz likewise.
stress::Tensor point_load_stress(double x, double y, double z, double poisson);

/// The stress at one point under a pressure constant in each cell: the sum over the cells, O(nx ny).
stress::Tensor stress_at(const Grid& grid, const Field& pressure, double x, double y, double z,
                         double poisson);

}  // namespace asperity
