/// How many independent heights a surface of correlated ones is worth, and the standard errors that follow.
///
/// The mean over N points of any function f of the height x = (z - mean)/σ has, for a Gaussian field of
/// correlation ρ, by the Hermite series f = Σ c_k He_k(x)/k! and Mehler's formula E[He_k(x) He_k(y)] = k! ρᵏ,
///     Var[1/N Σ f] = 1/N Σ_{k≥1} (c_k²/k!) S_k,                                                    (1)
///     S_k = Σ_{p,q} (1 - |p|/nx)(1 - |q|/ny) ρ(p,q)ᵏ      (weights 1 on a periodic grid),            (2)
/// the weights being the number of pairs at a lag over the number of points, missing heights left out of both
/// (stats/pairs.hpp).
/// N/S_k is the effective number of points of the k-th Hermite component, N for white noise, and
///     Var[z̄]  = σ² S_1/N          Var[Sq²] = 2σ⁴ S_2/N          Var[Sq] = σ² S_2/(2N)               (3)
///     Var[Ssk] = 6 S_3/N           Var[Sku] = 24 S_4/N                                               (4)
///     Var[Sa]  = σ²/N Σ_m (2/π) ((2m-3)!!)²/(2m)! S_{2m}                                            (5)
/// to first order in 1/N; the mean and the rms height that the field itself supplies are thereby accounted
/// for in (3)–(5). The field's own mean also lowers E[Sq²] by the factor 1 - S_1/N.
///
/// An estimated ρ is mostly noise far out, of standard error √(S_2/N) (stats/acf_error.hpp); summed, that
/// noise would be as large as S_2 itself. Therefore lags are admitted in the order of |ρ| for as long as the
/// next exceeds three standard errors, √(S_2/pairs) with S_2 of those admitted. Of the noise 0.3 % passes; of
/// an exponential tail below the level t is lost the part t²(1 + 2 ln 1/t) of S_2, 3 % for t = 0.07. S_1
/// weighs the tail more: it is summed over twice the admitted reach (h where h/2 is admitted), where the tail
/// has sunk to t², and the field's mean, which lowers each of the K lags by S_1/N, is put back:
/// S_1 = Σ/(1 - K/N).
///
/// Symbols   N  points      S_k  sums (2), S_k ≥ 1 where ρ ≥ 0      σ  rms height [m]
/// Scope     Gaussian heights; Var[z̄] holds for any. Heights of larger kurtosis have a larger Var[Sq].
/// Accuracy  The 95 % intervals cover 92–99 % with a known ρ, down to N_eff = N/S_2 = 40; with an estimated one
///           94–97 % from N_eff = 600 on, but for Sa and Sq 92 % at 150 and 84 % at 40 (1600 fields of
///           128 × 128 a row, validation/statistics_coverage). An S_k that noise makes negative, which no
///           correlation has, counts as zero.
/// Cost      at most 512 multiplications a lag, fewer where ρᵏ vanishes; two passes over an estimate's lags.
///
/// F. G. Mehler, J. reine angew. Math. 66 (1866) 161-176.
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <array>
#include <functional>

#include "grid/field.hpp"
#include "stats/lag_field.hpp"
#include "stats/moments.hpp"
#include "stats/pairs.hpp"

namespace asperity {

class EffectiveSize {
 public:
  static constexpr int powers = 512;

  /// The sums (2) of a known correlation, normalised or not.
  EffectiveSize(const LagField& correlation, const Pairs& pairs);
  /// The sums of an estimated one, as said above.
  static EffectiveSize of_estimate(const LagField& estimate, const Pairs& pairs);

  double points() const { return points_; }                               ///< N
  double sum(int k) const { return sums_[static_cast<std::size_t>(k)]; }  ///< S_k, 1 ≤ k ≤ powers
  double effective(int k) const { return points_ / sum(k); }              ///< N/S_k; infinite when S_k = 0
  /// (1) for weights w(k) = c_k²/k!, k ≥ 1, that add up to `total`. The weights beyond `powers` are taken
  /// with the last sum, which is larger than theirs.
  double variance_of_mean(const std::function<double(int)>& weight, double total) const;

 private:
  double points_;
  std::array<double, powers + 1> sums_{};
};

/// The lags of an estimate that stand out of its noise, the others zero; normalised.
LagField significant_lags(const LagField& estimate, const Pairs& pairs);

/// Standard errors (3)–(5), in the unit of the field.
struct MomentErrors {
  double mean = 0, sa = 0, sq = 0, ssk = 0, sku = 0;
};
MomentErrors standard_errors(const Moments& moments, const EffectiveSize& size);

}  // namespace asperity
