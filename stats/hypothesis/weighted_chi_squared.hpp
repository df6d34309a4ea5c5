/// The distribution of a weighted sum of squares of independent Gaussians, Q = Σ λ_j g_j², λ_j ≥ 0.
///
/// A quadratic form gᵀ W g of a Gaussian vector of covariance V has the distribution of Q with the
/// eigenvalues of W^{1/2} V W^{1/2} as weights. With the cumulant function K(s) = -½ Σ ln(1 - 2λ_j s), s <
/// s_1 = 1/(2 max λ),
///     P(Q > x) = 1/(2πi) ∫ exp(K(s) - x s) ds/s                                                     (1)
/// over any path from -i∞ to i∞ that crosses the real axis between the pole 0 and the branch point s_1 and
/// bends to the right. The path used is a parabola through the saddle point s_0,
///     s(u) = s_0 + i u + a u²,   K'(s_0) = x + 1/s_0,   a = max(f'''/(6 f''), 0.1/s_1),              (2)
/// f = K - x s - ln s, the path of steepest descent near s_0. The trapezoidal rule converges geometrically on
/// it. Its step is a sixth of the distance from u = 0 to the nearest singularity, or 1/1.5 of the width
/// 1/√f'' of the peak if that is less: errors of exp(-12π) and exp(-4.5π²) relative to the largest value.
///
/// Accuracy  a relative error of 1e-10, even for tiny probabilities.
/// Cost      about 50 nodes × weights; more for x far below the mean.
///
/// S. O. Rice, SIAM J. Sci. Stat. Comput. 1 (1980) 438-448; L. N. Trefethen, J. A. C. Weideman, SIAM Rev. 56
/// (2014) 385-458.
#pragma once

#include <Eigen/Core>

namespace asperity {

/// P(Q > x). Weights ≤ 0 are left out; without weights Q is 0.
double weighted_chi_squared_exceedance(const Eigen::ArrayXd& weights, double x);

}  // namespace asperity
