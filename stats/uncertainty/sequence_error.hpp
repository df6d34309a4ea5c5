/// Mean and spread of a stationary sequence, such as of a parameter of neighbouring profiles, with their
/// standard errors from the sequence's own longest waves.
///
/// The mean v̄ of m values v_j, and by d(s²)/(2s) their spread s = √(mean (v_j - v̄)²), are means of
///     f_j = v_j - v̄   and   f_j = ((v_j - v̄)² - s²)/(2s),                                              (1)
/// waves of number zero, and their errors are those of stats/uncertainty/wave_spectra.hpp from the six
/// longest waves u_k of the sequence, of k half waves,
///     c_k = 1/m Σ_j f_j u_k(j),     ν_k = k².                                                            (2)
/// A spread of heavy tails is decided by few values, and its error is low where it is low itself: with the
/// independent ones among them
///     n = (Σ d²)²/Σ d⁴ · independent values/m,     d = v - v̄,                                          (3)
/// the degrees of freedom of the spread are lower by the factor n/(n + 3), 1 at least, and its inverse varies
/// more evenly (Interval::of_inverse).
///
/// Symbols   v_j  values, in the order of their places; NaN where there is none     m  their number
/// Scope     any correlation and distribution, three independent values or more; heavy tails need more.
/// Accuracy  docs/accuracy/asperity-stats.md: profile parameters (stats/profile/profile.hpp).
/// Cost      50 operations a value.
#pragma once

#include "core/field.hpp"
#include "stats/uncertainty/wave_spectra.hpp"

namespace asperity {

struct SequenceMean {
  double count = 0;                              ///< m
  double mean = NAN, spread = NAN;               ///< NaN without a value
  double independent = 0;                        ///< of them
  WaveError of_mean{NAN, 1}, of_spread{NAN, 1};  ///< NaN if fewer than `least_independent`

  static constexpr double least_independent = 3;
};

/// `independent` is the share of independent values; a periodic sequence begins again behind its end.
SequenceMean sequence_mean(const Eigen::ArrayXd& values, double independent, bool periodic);

}  // namespace asperity
