/// The tests of stats/hypothesis/gaussianity.hpp for heights that stand on steps of an instrument.
///
/// Heights rounded to steps s (stats/height/height_steps.hpp) tell F_N between the steps only, where it is
/// that of the heights themselves. At those edges x, in units of Sq from the mean,
///     Kolmogorov–Smirnov  √N max |F_N - Φ|                                                            (1)
///     Anderson–Darling    N Σ w (F_N - Φ)²/(Φ(1-Φ)),   w half of what Φ grows by around x              (2)
///     Pearson's χ²        Σ (c - N p)²/(N p) over classes of whole steps                               (3)
/// and Jarque–Bera by moments without what rounding adds to them (Sheppard). The null distributions are those
/// of the process D at the same edges. With ε = s²/(12 Sq²), rounding adds to D's covariance, by the fitted
/// mean and Sq, φφᵀ ε + (xφ)(xφ)ᵀ (ε + ε²/5), and to Jarque–Bera's S_3 and S_4 (1+ε)³ - 1 and (1+ε)⁴ - 1.
///
/// Symbols   s  step     Φ, φ  the Gaussian's distribution and density     N  points
/// Scope     Steps up to 1.25 Sq; the errors of rounding are independent, of variance s²/12.
/// Accuracy  Of fields of 100 × 100 points, white and exponential of 3 samples, by an estimated correlation,
///           1 to 6 % of 150 each at steps of Sq/3 and Sq, and 3 to 12 % of 60 each at Sq/20 and Sq/5 have a
///           p-value below 5 % by any one of the tests.
/// Cost      as of heights without steps.
///
/// W. F. Sheppard, Proc. Lond. Math. Soc. 29 (1898) 353-380; V. Choulakian, R. A. Lockhart, M. A. Stephens,
/// Can. J. Stat. 22 (1994) 125-137.
#pragma once

#include <array>
#include <vector>

#include "stats/height/height_steps.hpp"
#include "stats/hypothesis/gaussianity.hpp"

namespace asperity {

/// Moments of the heights before they were rounded. Sq is NaN where steps are coarser than the Scope.
Moments before_rounding(const Moments& rounded, double step);
/// ρ of the heights before, of an estimate that has lost R(0,0) to their rounding.
LagField before_rounding(const LagField& rho, const Moments& rounded, double step);

/// `heights` are runs of equal ones, `moments` theirs; `size` is of the heights before. Steps beyond the
/// Scope have no p-values, and say why.
std::array<GoodnessOfFit, 4> gaussianity_of_steps(const std::vector<HeightRun>& heights,
                                                  const Moments& moments, const HeightSteps& steps,
                                                  const EffectiveSampleSize& size);

}  // namespace asperity
