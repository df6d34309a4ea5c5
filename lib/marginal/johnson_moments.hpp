/// Moments of Johnson's distributions.
///
/// The closed forms of S_U and S_L stand in marginal/johnson.hpp (3). Any other expectation is an integral
/// over the normal density φ, taken by the trapezoidal rule after a substitution that follows the ascent of
/// g:
///     E[f(z)] = ∫ f(g(y)) φ(y) dy ≈ h Σᵢ f(g(yᵢ)) φ(yᵢ) ω cosh sᵢ,   yᵢ = η + ω sinh sᵢ,   sᵢ = i h,     (1)
/// with η = γ, ω = δ for S_B of δ < 1, which rises within |y - γ| ~ δ, and η = 0, ω = 1 otherwise.
/// The rule converges exponentially in 1/h: the poles of S_B at y = γ ± iπδ stay π/2 from the real axis of s
/// as δ → 0.
///
/// Accuracy  a few ε of max(1, |moment|): h = 1/16 and |yᵢ - η| ≤ 22, at the most 256 nodes.
/// Cost      1 to 2.5 µs.
///
/// L. N. Trefethen, J. A. C. Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56 (2014)
/// 385-458.
#pragma once

#include "marginal/height_moments.hpp"
#include "marginal/johnson.hpp"

namespace asperity {

/// Of z = g(y), by (1) for every family.
HeightMoments johnson_moments(const Johnson& johnson);

/// Of S_U with a = 1, b = 0 and the upper sign, by the closed forms.
HeightMoments unbounded_moments(double gamma, double delta);
/// Of S_L so, at 1/δ² = v.
HeightMoments lognormal_moments(double v);

}  // namespace asperity
