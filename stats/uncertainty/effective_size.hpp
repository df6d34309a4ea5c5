/// The effective number of independent heights of a correlated surface, and the standard errors from it.
///
/// Let f be any function of the height x = (z - mean)/σ of a Gaussian field of correlation ρ. By the Hermite
/// series f = Σ c_k He_k(x)/k! and Mehler's formula E[He_k(x) He_k(y)] = k! ρᵏ its mean over N points has
///     Var[1/N Σ f] = 1/N Σ_{k≥1} (c_k²/k!) S_k,                                                    (1)
///     S_k = Σ_{p,q} (1 - |p|/nx)(1 - |q|/ny) ρ(p,q)ᵏ,                                             (2)
/// N/S_k is the effective number of points of the k-th Hermite component, N for white noise, and to first
/// order in 1/N
///     Var[z̄]  = σ² S_1/N          Var[Sq²] = 2σ⁴ S_2/N          Var[Sq] = σ² S_2/(2N)               (3)
///     Var[Ssk] = 6 S_3/N           Var[Sku] = 24 S_4/N                                               (4)
///     Var[Sa]  = σ²/N Σ_m (2/π) ((2m-3)!!)²/(2m)! S_{2m}                                            (5)
/// with the field's own mean and rms height allowed for. The form that heights are measured from takes the
/// share w of the variance, S_1/N for the mean (stats/uncertainty/form_modes.hpp): E[Sq²] is lower by the
/// factor 1 - w, and ρ becomes (ρ - w B)/(1 - w), B = 1 for the mean, which (ρ + b B)/(1 + b) with
/// b = w/(1 - w) undoes. w is limited to ½, and so is what (6) subtracts from 1.
///
/// At long lags an estimated ρ is mostly noise, of standard error √(S_2/N), whose sum would be as large as
/// S_2 itself. Lags are therefore admitted in the order of |ρ| as long as the next exceeds three standard
/// errors,
///      √(S_2/pairs)
/// with S_2 of those admitted, lags of one |ρ| together; 0.3 % of the noise passes. S_k, k ≥ 3, are summed
/// over these. S_1 and S_2 depend more on the tail and are summed over the K lags within twice the admitted
/// reach (h such that h or h/2 is admitted), with what the form of M modes took put back and the noise S_2/N
/// of each square subtracted:
///     w = M/N Σ v B ρ / (1 - M/N Σ v B²),     S_1 = Σ v (ρ + w B),                                    (6)
///     S_2 = Σ v [(ρ + b B)/(1 + b)]² / (1 + K/N),     v the weights of (2).                           (7)
/// The lags beyond lower S_1 and w by about the fraction 15 S_2/N and S_2 by 10 S_2/N, measured values
/// between those for triangular (0, 7) and exponential (35, 17) correlations, which are added. ln S_2 then
/// has a variance of 5 to 16 S_2/N, as a standard error with `degrees` = N/(8 S_2) degrees of freedom. Errors
/// of N/S_k are those of stats/uncertainty/size_error.hpp.
///
/// Noise of single points, as of an instrument, raises N_eff = N/S_2 and tells nothing of long waves. Without
/// it there are
///     N_p = N/(1 + (S_2 - 1)/ρ_0²)                                                                  (8)
/// independent patches. ρ_0, from 0.1 to 1, is the correlated part of the variance: at lag zero, the line
/// through the two nearest lags, along x or y, whichever is larger.
///
/// Symbols   N  points      S_k  sums (2), S_k ≥ 1 where ρ ≥ 0      σ  rms height [m]
/// Scope     Gaussian heights; Var[z̄] holds for all. Heights of larger kurtosis have a larger Var[Sq].
/// Accuracy  first order in S_2/N. 95 % intervals (stats/uncertainty/moment_interval.hpp) of 300 fields of 48
///           × 48 points of known triangular correlation cover 94 to 98 % at N/S_2 = 16, 87 % or more (least:
///           Sku) at 5.2, and 5 % (Sku) at 3. An estimated N/S_2 does not fall below about 10, however long
///           the correlation. With an estimated correlation, intervals of Sq and Sa cover 86 % at a true
///           N/S_2 of 16 (median estimate 20), 73 % at 5 (11) and 55 % at 2 (9). An S_k that is negative by
///           noise is set to zero.
/// Cost      that of the S_k; two passes over the lags of an estimate.
/// Memory    32 bytes for each of the K lags of (7), 4 times those admitted: of many patches a few per cent
///           of all.
///
/// F. G. Mehler, J. reine angew. Math. 66 (1866) 161-176.
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "core/field.hpp"
#include "stats/sample/moments.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/form_modes.hpp"

namespace asperity {

/// A lag of a normalised ρ, and its weight as for_each_lag gives it.
struct WeightedLag {
  Index p = 0, q = 0;
  double rho = 0, weight = 0;
};

class EffectiveSampleSize {
 public:
  static constexpr int powers = 512;  ///< of ρ, that are summed

  /// The sums (2) of a known correlation, normalised or not.
  EffectiveSampleSize(const LagField& correlation, const Pairs& pairs, const FormModes& form = {});
  /// The sums (6), (7) of one estimated from heights above this form.
  static EffectiveSampleSize of_estimate(const LagField& estimate, const Pairs& pairs,
                                         const FormModes& form = {});

  double points() const { return points_; }                               ///< N
  double sum(int k) const { return sums_[static_cast<std::size_t>(k)]; }  ///< S_k, 1 ≤ k ≤ powers
  double effective(int k) const { return points_ / sum(k); }              ///< N/S_k; infinite if S_k = 0
  double mean_power(int k) const { return sum(k) / points_; }  ///< S_k/N, the mean of ρᵏ over all pairs
  double taken_by_form() const { return taken_; }              ///< w
  const FormModes& form() const { return form_; }
  /// (ρ + b B)/(1 + b) of an estimate, without what the form took.
  LagField freed(const LagField& rho) const;
  double freed(const WeightedLag& lag) const;
  double degrees() const { return degrees_; }  ///< of freedom of the errors; infinite for a known correlation
  double patches() const { return points_ / (1 + (sum(2) - 1) / (correlated_ * correlated_)); }  ///< (8)
  /// Least N/S_2 for which errors are given: 5, or 10 for an estimate. Up to twice of it they are rough.
  double least_effective() const { return std::isinf(degrees_) ? 5 : 10; }
  /// Whether the form left enough to tell what it took: form_modes.hpp.
  bool form_leaves_enough() const { return form_leaves_enough_; }
  bool gives_errors() const { return effective(2) >= least_effective() && form_leaves_enough_; }
  /// (1) for weights w(k) = c_k²/k!, k ≥ 1, that add up to `total`; beyond `powers` with the last sum.
  double variance_of_mean(const std::function<double(int)>& weight, double total) const;

 private:
  EffectiveSampleSize(const Pairs& pairs, const FormModes& form, double taken)
      : points_(pairs.points()), form_(form), taken_(std::min(taken, 0.5)) {}

  double points_, degrees_ = std::numeric_limits<double>::infinity();
  FormModes form_;
  double correlated_ = 1;  // ρ_0
  std::array<double, powers + 1> sums_ = {};
  double taken_;
  bool form_leaves_enough_ = true;
};

/// The lags of a normalised estimate that exceed its noise, in order.
std::vector<WeightedLag> significant(const LagField& rho, const Pairs& pairs);
/// The normalised estimate, zero at lags that do not exceed its noise.
LagField significant_lags(const LagField& estimate, const Pairs& pairs);

/// Standard errors (3)–(5), in the unit of the field.
struct MomentErrors {
  double mean = 0, sa = 0, sq = 0, ssk = 0, sku = 0;
};
MomentErrors standard_errors(const Moments& moments, const EffectiveSampleSize& size);

}  // namespace asperity
