/// Standard errors of an estimated autocorrelation.
///
/// For a Gaussian field of variance σ² and correlation ρ with known mean, the unbiased estimate at lag h,
/// over n_h pairs, has exactly
///     Var[R(h)] = σ⁴/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h) ρ(k-h)],                                       (1)
/// w_h(k) the share of the pairs that have another one at distance k (Bartlett); and to first order
///     Var[R(h)/R(0)] = 1/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h)ρ(k-h) + 2ρ(h)²ρ(k)² - 4ρ(h)ρ(k)ρ(k+h)],     (2)
/// zero at h = 0. Errors of neighbouring lags are strongly correlated: an estimate is too high or too low
/// over many lags in a row. The error of the biased estimate is smaller by the factor n_h/N. With missing
/// heights n_h counts the pairs of measured points, and w_h(k) is that of the complete field times the share
/// of points that have a partner at k: exact at k = 0, an upper bound if ρ ≥ 0. If the field is much longer
/// than ρ, the sums are values of c = ρ*ρ (stats/uncertainty/correlation_algebra.hpp).
///
/// Accuracy  (1) is exact for a known ρ; the sample mean changes it by O(1/n²). Of an estimate use the
///           significant_lags (stats/uncertainty/effective_size.hpp).
/// Cost      (1), (2) a term for each lag with ρ ≠ 0; for all lags one autocorrelation of ρ.
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/correlation_algebra.hpp"

namespace asperity {

class AcfError {
 public:
  AcfError(const LagField& correlation, const Pairs& pairs);

  /// √(1)/σ², the standard error of R(p,q) relative to R(0,0).
  double absolute(Index p, Index q) const;
  /// √(2), the standard error of ρ(p,q) = R(p,q)/R(0,0).
  double normalised(Index p, Index q) const;
  /// (2) at all lags up to max_lag, with w_h(k) = w_0(k): √(C(h,h)/n_h) of ρ tapered by √w_0.
  LagField normalised(Shape max_lag) const;
  /// The correlation of the errors of lags, by Bartlett's covariance of the same ρ.
  Eigen::MatrixXd correlation(const std::vector<Shape>& lags) const;

 private:
  /// The weight of distance (k,l) among the pairs at lag (p,q).
  double weight(Index p, Index q, Index k, Index l) const;
  double pairs(Index p, Index q) const;

  CorrelationAlgebra algebra_;
  Pairs pairs_;
  std::vector<CorrelatedLag> support_;  ///< the lags of the whole plane with ρ ≠ 0
};

}  // namespace asperity
