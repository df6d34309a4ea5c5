/// Standard errors of the moments of heights that are not Gaussian.
///
/// Of a translation z = m + σ g(y) of a Gaussian field y of correlation ρ, g of mean 0, variance 1, skewness s and
/// kurtosis k, each moment is to first order in 1/N its own value and the mean over the field of
///     mean   g                                     Sq     (g² - 1)/2                                      (1)
///     Ssk    g³ - s - 3g - (3/2) s (g² - 1)        Sku    g⁴ - k - 4 s g - 2 k (g² - 1)
///     Sa     |g| - E|g| - g E[sign g]
/// in units of σ where it has one: the field's own mean and rms height are thereby allowed for. The variance of the mean
/// of f(y) over N points is (1) of stats/effective_size.hpp,
///     Var = 1/N Σ_{k≥1} E[f h_k]² S_k,    S_k the sums over ρᵏ,                                           (2)
/// h_k the orthonormal Hermite polynomials. Of g = y these are the errors of a Gaussian field.
///
/// Scope     translations. g is known of a drawn surface; of a measured one it is Johnson's of its Ssk and Sku.
/// Cost      some 0.1 ms.
///
/// M. Grigoriu, J. Eng. Mech. 110 (1984) 610-620.
#pragma once

#include <optional>

#include "marginal/correlation_map.hpp"
#include "marginal/translation.hpp"
#include "stats/effective_size.hpp"
#include "stats/lag_field.hpp"

namespace asperity {

/// The correlation of y below that of the heights, normalised.
LagField underlying_correlation(const LagField& heights, const CorrelationMap& map);

/// Johnson's translation of the skewness and kurtosis of heights that are not Gaussian by more than four of a Gaussian
/// field's standard errors; none where they may be. Moments beyond what the system covers are taken at its bounds.
std::optional<Translation> evident_translation(const Moments& moments, const MomentErrors& gaussian);

/// (1), in the unit of the field; `size` holds the sums over the correlation of y.
MomentErrors standard_errors(const Moments& moments, const Translation& g, const EffectiveSize& size);

}  // namespace asperity
