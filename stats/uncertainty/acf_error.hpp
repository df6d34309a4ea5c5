/// Standard errors of the autocorrelation of a Gaussian field of known correlation.
///
/// For variance σ² and correlation ρ the estimate at lag h, over n_h pairs, has to first order
///     Var[R(h)/R(0)] = 1/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h)ρ(k-h) + 2ρ(h)²ρ(k)² - 4ρ(h)ρ(k)ρ(k+h)],     (1)
/// w_h(k) the share of the pairs that have another one at distance k (Bartlett); zero at h = 0. Errors of
/// neighbouring lags are strongly correlated: an estimate is too high or too low over many lags in a row.
/// With missing heights n_h counts the pairs of measured points, and w_h(k) is that of the complete field
/// times the share of points that have a partner at k: exact at k = 0, an upper bound if ρ ≥ 0. If the field
/// is much longer than ρ, the sums are values of c = ρ*ρ (stats/uncertainty/correlation_algebra.hpp).
///
/// Where ρ is only estimated, see stats/uncertainty/lag_waves.hpp.
///
/// Cost      (1) a term for each lag with ρ ≠ 0.
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/correlation_algebra.hpp"

namespace asperity {

class AcfError {
 public:
  AcfError(const LagField& correlation, const Pairs& pairs);

  /// √(1).
  double normalised(Index p, Index q) const;
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
