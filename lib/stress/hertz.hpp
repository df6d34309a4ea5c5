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
/// The load on the rectangle from the centre to (x, y), both in [-1, 1], is, with w² = max(0, 1 - x² - y²),
///     ⅓ [xyw + ½x(3-x²) atan2(y,w) + ½y(3-y²) atan2(x,w) - atan2(xy,w)].                              (2)
///
/// Accuracy  2e-14 of (1), 1e-15 of (2).
///
/// [1] M. T. Huber, Zur Theorie der Berührung fester elastischer Körper, Ann. Physik 319 (1904) 153-163.
#pragma once

#include "grid/field.hpp"
#include "stress/component.hpp"

namespace asperity {

/// (1) in Cartesian components at (x, y, z), z ≥ 0.
stress::Tensor hertz_stress(double x, double y, double z, double poisson);

/// The mean of √(1-r²) over each cell, from (2): a pressure that carries the contact's load exactly.
Field hertz_pressure(const Grid& grid);

}  // namespace asperity
