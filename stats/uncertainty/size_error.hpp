/// Standard errors of the effective sample sizes N/S_k of a field whose correlation is estimated.
///
/// S_k is a figure of the estimated ρ (stats/uncertainty/effective_size.hpp), with its choice of lags. By the
/// modes m of the deviation of ρ at all lags together (stats/uncertainty/acf_deviations.hpp), N_k = N/S_k
/// has the standard error SE,
///     (SE/N_k)² = Σ_m [½ ln N_k(ρ+m) - ½ ln N_k(ρ-m)]².                                              (1)
/// Intervals are N_k ± t SE with Student's t, 1 at least: where N_k is too large by chance, its relative
/// error is too small, the absolute one hardly.
///
/// N_1 has no error: what ρ has at long lags is lost in noise. Of self-affine fields N_1 is low by 13 % at
/// N_2 = 300 and by 40 % at 38, of lays by a factor of 2.6 to 3; N_2 of lays is high by 13 to 27 %.
///
/// Symbols   N  points      S_k  sums of ρᵏ      N_1, N_2  estimates
/// Scope     k = 2, 3, 4; any distribution of the heights; for k = 2 no lay.
/// Accuracy  docs/accuracy/asperity-stats.md
/// Cost      the waves over lags up to twice those that hold 95 % of Σ ρ², and two estimates of S_k from them
///           for each wave: a third of what the rest of the height parameters costs.
#pragma once

#include <Eigen/Core>

#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/interval.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

class SizeErrors {
 public:
  /// Of heights less their mean, NaN where missing, their estimated correlation and the size from it.
  SizeErrors(const Field& d, const LagField& estimate, const Pairs& pairs, const FormModes& form,
             const FieldExtent& extent, const EffectiveSampleSize& size, int threads = 1);

  /// Of size.effective(k), 2 ≤ k ≤ 4; not finite where S_k may be zero.
  double operator()(int k) const { return errors_(k - 2); }
  Interval interval(int k) const;

 private:
  Eigen::Array3d values_, errors_;
  double quantile_;
};

}  // namespace asperity
