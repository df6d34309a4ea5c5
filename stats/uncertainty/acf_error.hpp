/// Standard errors of an estimated autocorrelation.
///
/// For a Gaussian field of variance σ² and correlation ρ with known mean, the unbiased estimate at lag h,
/// over n_h pairs, has exactly
///     Var[R(h)] = σ⁴/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h) ρ(k-h)],                                       (1)
/// w_h(k) the share of the pairs that have another one at distance k (Bartlett); and to first order
///     Var[R(h)/R(0)] = 1/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h)ρ(k-h) + 2ρ(h)²ρ(k)² - 4ρ(h)ρ(k)ρ(k+h)],     (2)
/// zero at h = 0. The errors of neighbouring lags are strongly correlated: an estimate that strays does so
/// over a whole stretch of lags. The biased estimate's error is share(h) times as large (stats/spatial/pairs.hpp).
/// With missing heights n_h counts the pairs that are there, and w_h(k) is taken as that of the complete field times
/// the share of the points that have a partner at k: exact at k = 0 and far too many to count elsewhere, it is an upper
/// bound where ρ ≥ 0.
///
/// Accuracy  (1) for a known ρ; the sample mean in place of the known one changes it by O(1/n²). From an
///           estimate use its significant_lags (stats/uncertainty/effective_size.hpp).
/// Cost      per lag the number of lags at which ρ is not zero; (3) one autocorrelation of ρ for all lags.
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/correlation_powers.hpp"

namespace asperity {

class AcfError {
 public:
  AcfError(const LagField& correlation, const Pairs& pairs);

  /// √(1)/σ², the relative standard error of R(p,q) as a share of R(0,0).
  double absolute(Index p, Index q) const;
  /// √(2), the standard error of ρ(p,q) = R(p,q)/R(0,0).
  double normalised(Index p, Index q) const;
  /// (2) at all lags up to these, with w_h(k) = w_0(k): ρ is tapered by √w_0, of which c = ρ*ρ holds all sums,
  ///     n_h Var[R(h)/R(0)] = c(0) (1 + 2ρ(h)²) - 4ρ(h) c(h) + c(2h).                               (3)
  LagField normalised(Shape max_lag) const;
  /// How the errors (2) of two lags of a field much longer than they are correlated, by c of (3) and Bartlett's
  /// covariance (stats/uncertainty/correlation_powers.hpp).
  Eigen::MatrixXd correlation(const std::vector<Shape>& lags) const;

 private:
  /// The weight of distance (k,l) among the pairs at lag (p,q).
  double weight(Index p, Index q, Index k, Index l) const;
  double pairs(Index p, Index q) const;
  LagField convolution(Shape max_lag) const;  ///< c, of ρ tapered

  LagField rho_;
  Pairs pairs_;
  std::vector<CorrelatedLag> support_;  ///< the whole plane's lags where ρ ≠ 0
};

}  // namespace asperity
