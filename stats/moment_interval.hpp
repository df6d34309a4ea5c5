/// Confidence intervals of the moments of a Gaussian field.
///
/// A symmetric interval of so many standard errors (stats/effective_size.hpp) is short where few patches are
/// independent: Sq is skewed to the right, and low, for the field's own mean takes the part S_1/N of Sq² away. With
/// ν_k = N/S_k independent heights in place of N, at the level 1 - 2a,
///     mean   z̄ ± t(d; a) SE[z̄] / √(1 - S_1/N),    d = min(ν_2 - 1, degrees of the S_k)               (1)
///     Sq     Sq' √(ν_2/χ²(ν_2; 1-a)) … Sq' √(ν_2/χ²(ν_2; a)),     Sq' = Sq/√(1 - S_1/N)            (2)
///     Sa     likewise, with ν = ½ (Sa/SE[Sa])²                                                    (3)
///     Ssk    Ssk ± u √(6 (n-2)/((n+1)(n+3))),                      n = ν_3                        (4)
///     Sku    Sku + 6/ν_2 ± u √(24 n (n-2)(n-3)/((n+1)²(n+3)(n+5))), n = ν_4                        (5)
/// where t, χ² and u are quantiles of Student's, the chi-squared and the normal distribution. (4) and (5) have the
/// variances that hold for n independent heights; 3 - 6/ν_2 is what Sku is on average.
///
/// Of heights that are not Gaussian, with the errors of stats/translation_error.hpp: Sq and Sa as in (2) with
/// ν = ½ (Sq/SE[Sq])², Ssk and Sku less their bias ± u SE, (1) with its own error.
///
/// Symbols   N  points      S_k  sums over the correlation
/// Scope     Gaussian heights, but for the last. Exact for independent ones, but for the normal quantile in (4), (5).
/// Accuracy  95 % intervals cover 93.2–97.2 % from N/S_2 = 150 on, with a known correlation or an estimated one; with
///           an estimate at 125 and an exponential correlation 91.7 (mean) to 97.5 % (Sku), at 41 and a triangular one
///           93.2 to 97.5 % (2000 fields a row, validation/statistics_coverage).
/// Cost      none.
///
/// E. B. Wilson, M. M. Hilferty, PNAS 17 (1931) 684-688, for χ² of 10⁴ degrees and more;
/// R. A. Fisher, The moments of the distribution for normal samples, Proc. R. Soc. A 130 (1930) 16-28.
#pragma once

#include "stats/effective_size.hpp"
#include "stats/moments.hpp"
#include "stats/translation_error.hpp"

namespace asperity {

struct Interval {
  double low = 0, high = 0;
};

/// In the unit of the field; NaN where there are too few independent heights for one.
struct MomentIntervals {
  Interval mean, sa, sq, ssk, sku;
};

/// At a level between 0 and 1; throws ParameterError("confidence", …) outside.
MomentIntervals confidence_intervals(const Moments& moments, const EffectiveSize& size, double level = 0.95);
/// Of heights that are not Gaussian.
MomentIntervals confidence_intervals(const Moments& moments, const TranslationErrors& errors,
                                     const EffectiveSize& size, double level = 0.95);

}  // namespace asperity
