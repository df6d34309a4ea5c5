/// Mean and spread of a stationary sequence, such as of a parameter of neighbouring profiles, with their
/// standard errors from the sequence's own longest waves.
///
/// The mean v̄ of m values v_j, and by d(s²)/(2s) their spread s = √(mean (v_j - v̄)²), are means of
///     f_j = v_j - v̄   and   f_j = ((v_j - v̄)² - s²)/(2s),                                              (1)
/// waves of number zero, and the next waves have nearly their variance (stats/uncertainty/long_waves.hpp):
///     SE² = 1/K Σ_k c_k² / (1 - L)²,     c_k = 1/m Σ_j f_j u_k(j),     k = 1 … K,                       (2)
/// with the K longest waves u_k, one for three independent values, 2 at least and 16 at most. The spectrum
/// falls from wave number zero on, and s is fitted to the same values: with ν = K mean f²/Σ c_k² independent
/// ones,
///     L = K/(6ν),  and 0.6/√ν more for the spread,  0.4 at most.                                        (3)
/// Intervals of the mean use Student's t of K degrees of freedom. A spread of heavy tails is decided by few
/// values, and its error is low where it is low itself: with the independent ones among them
///     n = (Σ d²)²/Σ d⁴ · independent values/m,     d = v - v̄,                                          (4)
/// the spread has K n/(n + 3) degrees, 1 at least, and its inverse varies more evenly (Interval::of_inverse).
///
/// Symbols   v_j  values, in the order of their places; NaN where there is none     m  their number
/// Scope     any correlation and distribution, three independent values or more; heavy tails need more.
/// Accuracy  the error itself is known to 1/√(2K). (3) was fitted to profile parameters of eleven textures
///           (stats/profile/profile.hpp). On fields with few independent profiles (3 to 16 by an estimated
///           correlation; 64 × 64, 60 × 200, 128 × 128 points), 93 to 95 % of the 95 % intervals of means
///           hold the truth, over all textures and parameters. Of 200 fields of each of eleven textures, with
///           7 to 43 independent profiles (128 × 128 points) and 4 to 20 (64 × 64), 87 to 100 % of those of
///           spreads do.
/// Cost      50 operations a value.
#pragma once

#include "core/field.hpp"

namespace asperity {

struct SequenceMean {
  double count = 0;                             ///< m
  double mean = NAN, spread = NAN;              ///< NaN without a value
  double independent = 0;                       ///< of them
  double mean_error = NAN, spread_error = NAN;  ///< NaN if fewer than `least_independent`
  Index degrees = 0;                            ///< K
  double spread_degrees = 0;

  static constexpr double least_independent = 3;
};

/// `independent` is the share of independent values; a periodic sequence begins again behind its end.
SequenceMean sequence_mean(const Eigen::ArrayXd& values, double independent, bool periodic);

}  // namespace asperity
