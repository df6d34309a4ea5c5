/// The stress inside an elastic half-space under the Hertz pressure of a circular contact, in closed form.
///
/// Under p = √(1-r²), r < 1, lengths in contact radii a and stresses in p0, Huber's field [1] is, with
///     s = r² + z² - 1,   u = (s + √(s²+4z²))/2,   w = z/√u,   α = atan(1/√u),   d = u/(u²+z²),
///     Q = (1+w+w²)/((1+w)(1+u)),
///     σzz = -w³ d,          σrz = -r z² √u / ((u²+z²)(1+u)),
///     σrr = (1-2ν)/3 Q - σzz + w [u(1-ν)/(1+u) + (1+ν) √u α - 2],                                     (1)
///     σθθ = -(1-2ν)/3 Q - w [2ν + u(1-ν)/(1+u) - (1+ν) √u α].
/// On the surface inside the contact w = √(1-r²) and d = 1/w².
///
/// Under the traction q = √(1-r²) along x the potentials of the point force, moved to complex depths [2],
/// give for a function f of (x, y, ζ) in its field
///     p * f = π/2 ∫ (1-t²) f(x, y, z+it) dt = 2π H[f],   H[f] = Im f‴ - Re f″  at ζ = z + i,
/// f″ and f‴ being integrals of f over ζ, twice and three times. With R² = r² + ζ², s = R + ζ (x, y, z as
/// factors stay real; F, A, B, C, the potential and its derivatives in r²/2, carry as index how often 1/R was
/// integrated)
///     F1 = ln s, F2 = ζF1 - R,   A1 = 1/(Rs), A2 = -1/s, A3 = -(ln s + ζ/s)/2,
///     B2 = 1/(Rs²), B3 = -1/(2s²), B4 = (1 + r²/3s²)/(4s), B5 = (ln s - 2r²/3s² - r⁴/12s⁴)/8,
///     C3 = 1/(Rs³), C4 = -1/(3s³), C5 = (1 + r²/2s²)/(12s²),
/// and with a = Im A3 - Re A2, b_n = Im B_n - Re B_{n-1}, c_n likewise,
///     σxx = 2(1+ν)xa + x[2ν(3b5 + x²c5) - z(3b4 + x²c4)],   σzz = -zx (Im A2 - Re A1),
///     σyy = 2νxa + x[2ν(b5 + y²c5) - z(b4 + y²c4)],         σxz = Im F2 - Re F1 - z(a + x²b3),        (2)
///     σxy = ya + y[2ν(b5 + x²c5) - z(b4 + x²c4)],           σyz = -zxy b3.
/// On the surface inside the contact they are -(4+ν)πx/8, -3νπx/8 (yy), -(2-ν)πy/8 (xy) and -√(1-r²) (xz)
/// [3].
///
/// The load on the rectangle from the centre to (x, y), both in [-1, 1], is, with w² = max(0, 1 - x² - y²),
///     ⅓ [xyw + ½x(3-x²) atan2(y,w) + ½y(3-y²) atan2(x,w) - atan2(xy,w)].                              (3)
///
/// Accuracy  2e-14 of (1), 1e-15 of (3); of (2) 1e-13 within four radii, growing as the depth.
///
/// [1] M. T. Huber, Zur Theorie der Berührung fester elastischer Körper, Ann. Physik 319 (1904) 153-163.
/// [2] G. M. Hamilton, Explicit equations for the stresses beneath a sliding spherical contact, Proc. Inst. Mech.
///     Engrs 197C (1983) 53-59, in real arithmetic.
/// [3] K. L. Johnson, Contact Mechanics, Cambridge 1985, section 7.1.
#pragma once

#include "core/field.hpp"
#include "stress/component.hpp"
#include "stress/load.hpp"

namespace asperity {

/// (1) in Cartesian components at (x, y, z), z ≥ 0, under the pressure; (2) under a traction.
stress::Tensor hertz_stress(double x, double y, double z, double poisson,
                            stress::Traction load = stress::normal);

/// Under the pressure and its friction.
stress::Tensor hertz_stress(double x, double y, double z, double poisson, const Friction& friction);

/// The mean of √(1-r²) over each cell, from (3): a pressure that carries the contact's load exactly.
Field hertz_pressure(const Grid& grid);

}  // namespace asperity
