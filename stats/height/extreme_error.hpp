/// Standard errors of the extremes of a field, whatever the distribution of its heights.
///
/// The highest of many independent summits strays by the scale of the tail that they make up. With X₁ > X₂ >
/// … the heights of the highest summits, 3 × 3 maxima at least two 1/e lengths apart along either axis,
///     a = 1/5 Σ_{k≤5} X_k - X_6,     a' = the same of ln X_k,                                          (1)
/// are that scale if the tail is exponential, as a Gaussian's nearly is, and if it is a power. The extreme
/// X = X₁ has the standard error, with that of the mean, from which heights are measured,
///     SE² = (0.9 X a')² + SE[z̄]².                                                                     (2)
/// Of 100 and 400 independent summits the standard deviation of X over the rms of X a' is 0.63 and 0.78
/// for Gaussian heights, 0.76 and 0.86 for exponential ones, 0.88 and 0.92 for lognormal ones of σ = 0.5,
/// 0.79 and 0.95 for Student's of five degrees: 0.9 is for heavy tails, and up to 1.4 times too much for
/// others.
/// The extreme has a 95 % interval of its expectation, the wider of
///     X - 1.89 a … X + 5.14 a     and     X e^(-1.89 a'') … X e^(5.14 a''),     a'' = min(a', 0.6),      (3)
/// with the quantiles of (E[X] - X)/a for exponential tails; 2.2 errors of the mean are added to the former
/// in the root of the squares, which is all that an edge of the distribution strays by. Below N_p = 100
/// patches there is none.
///
/// Symbols   X  extreme above the mean [m]      N_p  independent patches (effective_size.hpp)
/// Scope     the expectation over fields of this size.
/// Accuracy  on 24 textures of 80 fields at N_p ≥ 100 the intervals hold it in 90 to 100 %:
///           docs/accuracy/asperity-stats.md.
/// Cost      a pass of some ten comparisons a point, and sorting the 600 highest maxima.
///
/// I. Weissman, Estimation of parameters and large quantiles based on the k largest observations, J. Am.
/// Stat. Assoc. 73 (1978) 812-815, for (1).
#pragma once

#include <optional>

#include "core/field.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

struct ExtremeError {
  double error = 0;
  Interval interval = {};
};

/// Of the highest of heights above their mean, whose correlation falls to 1/e at these lags [samples]; none
/// where fewer than six summits are apart, or they are equal.
std::optional<ExtremeError> extreme_error(const Field& heights, const Grid& grid, double length_x,
                                          double length_y, double error_of_mean);

}  // namespace asperity
