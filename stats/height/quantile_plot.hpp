/// Quantiles of the heights against those of a Gaussian: the data of a Q–Q plot.
///
/// At the shares p_i = (i - ½)/n, i = 1 … n (Hazen), the height c_i below which that share of the surface lies stands
/// beside x_i = Φ⁻¹(p_i). Gaussian heights lie on the line
///     c = z̄ + Sq x                                                                                  (1)
/// but for chance. By Bahadur, c strays as the share of heights below it does (stats/height/material_ratio.hpp), an
/// indicator whose Hermite coefficients are He_{k-1}(x) φ(x). About the field's own mean,
///     Var[c] = Sq²/N Σ_{k≥2} He_{k-1}(x)²/k! S_k,                                                   (2)
/// and from the line (1), which the field's own mean and Sq have been put into, without the term k = 2,
///     Var[c - (1)] = Sq²/N Σ_{k≥3} He_{k-1}(x)²/k! S_k.                                             (3)
///
/// Symbols   c  heights      Φ  the Gaussian distribution      S_k  sums over the correlation      N  points
/// Accuracy  the quantiles are exact; (2), (3) to first order in 1/N, for Gaussian heights with N/S_k patches beyond
///           the quantile. Errors of neighbouring quantiles are correlated.
/// Cost      a sort of the heights, N log N; 512 terms a quantile.
///
/// M. B. Wilk, R. Gnanadesikan, Probability plotting methods for the analysis of data, Biometrika 55 (1968) 1-17;
/// A. Hazen, Trans. Am. Soc. Civ. Eng. 77 (1914) 1539-1640.
#pragma once

#include <vector>

#include "stats/height/material_ratio.hpp"
#include "stats/height/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {

/// Heights in the unit of the field.
struct QuantilePoint {
  double share = 0;         ///< p
  double normal = 0;        ///< x
  double height = 0;        ///< c
  double height_error = 0;  ///< √(2)
  double gaussian = 0;      ///< (1)
  double misfit_error = 0;  ///< √(3): of height - gaussian
};

/// At n shares; throws ParameterError("points", …) below 1.
std::vector<QuantilePoint> quantile_plot(const MaterialRatioCurve& curve, const Moments& moments,
                                         const EffectiveSampleSize& size, int points);

}  // namespace asperity
