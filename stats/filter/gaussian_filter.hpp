/// The areal Gaussian filter of ISO 16610-61, which separates long waves from short ones.
///
/// The mean surface of the heights is their average under the weight
///     s(x,y) = exp(-π (x² + y²) / (α λ_c)²) / (α λ_c)²,   α = √(ln 2 / π) = 0.4697,                  (1)
/// which passes the amplitude of a wave of wavelength λ by
///     H(λ) = exp(-π (α λ_c / λ)²) = 2^{-(λ_c/λ)²},                                                   (2)
/// half of it at the cut-off λ_c. Heights minus the mean surface are the short waves. Along a periodic axis
/// weights run across the seam. Near another edge, and near missing points, they are divided by the sum of
/// those that fall on points (regression of order zero, ISO 16610-28): a constant stays a constant, and
/// results within λ_c of an edge are less exact. Missing points stay missing.
///
/// Symbols   λ_c  cut-off wavelength [m]: λ_s of the S-filter, λ_c of the L-filter
/// Accuracy  Along a periodic axis (2) to round-off. Along another (1) is a sum over samples, which passes a
///           wave's aliases too, with the amplitude 2^{-(λ_c/Δ)² (1 - Δ/λ)²},
///           and is cut where it is below 1e-16.
/// Cost      one pruned transform there and back, padded by 1.65 λ_c; with missing heights two.
///
/// ISO 16610-61:2015; ISO 16610-28:2016.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// Throws ParameterError("cut-off") unless 2 Δ ≤ λ_c < ∞ for the spacing Δ of each axis of
/// several points.
void check_cutoff(const Grid& grid, double cutoff);

/// Throws ParameterError("cut-off") unless 2 Δ ≤ λ_c < ∞ for the spacing Δ of each axis of
/// several points.
Field gaussian_mean_surface(const Field& z, const Grid& grid, double cutoff, int threads = 1);

}  // namespace asperity
