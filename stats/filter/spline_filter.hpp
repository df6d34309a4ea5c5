/// The linear spline filter of ISO 16610-62 (areal) and -22 (profile): a mean surface without end effects of
/// first order.
///
/// Along an axis of spacing Δ the mean line w of heights z is the discrete cubic smoothing spline
///     (1 + α⁴ Q) w = z,   α = 1 / (2 sin(πΔ/λ_c)),   Q = DᵀD,                                        (1)
/// of tension zero, D the second differences of neighbouring points: all n of them along a periodic axis, and
/// the n-2 within the line along a free one, whose ends are natural. A wave passes by
///     H(λ) = 1 / (1 + α⁴ 16 sin⁴(πΔ/λ)),   half of it at λ_c.                                        (2)
/// The areal filter is (1) along one axis, then along the other: (1 + α_x⁴ Q_x)(1 + α_y⁴ Q_y) w = z. An
/// oblique wave passes by the product of (2), so that the filter is not isotropic. A line stays as it is
/// along a free axis.
///
/// Where points are missing, they have no weight: with W = 1 on points that are there, otherwise 0,
///     ((1 + α_x⁴ Q_x)(1 + α_y⁴ Q_y) - 1 + W) w = W z.                                                (3)
/// Missing points stay missing.
///
/// Symbols   λ_c  cut-off [m]
/// Accuracy  (1) along a periodic axis round-off; along a free one 4ε α⁴ of the heights above their mean at
///           worst. (3) to a residual of 1e-12 by conjugate gradients.
/// Cost      one banded solve a line, 10 operations a point, 3 ms for 512²; periodic axes by FFT. (3) repeats
///           it, some hundred times if a hole is many cut-offs wide: 2 s if of 170 × 256 points, λ_c = 20 Δ.
///
/// ISO 16610-22:2015; ISO 16610-62:2023. M. Krystek, Measurement 18 (1996) 9-15.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// Throws ParameterError("cut-off") unless 2 Δ ≤ λ_c < ∞ for the spacing Δ of each axis of
/// several points.
Field spline_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads = 1);

}  // namespace asperity
