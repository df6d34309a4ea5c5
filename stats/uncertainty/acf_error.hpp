/// Standard errors of an estimated autocorrelation, and the algebra of the correlation that they rest on.
///
/// For a Gaussian field of variance σ² and correlation ρ with known mean, the unbiased estimate at lag h,
/// over n_h pairs, has exactly
///     Var[R(h)] = σ⁴/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h) ρ(k-h)],                                       (1)
/// w_h(k) the part of the pairs that have another one at distance k (Bartlett); and to first order
///     Var[R(h)/R(0)] = 1/n_h Σ_k w_h(k) [ρ(k)² + ρ(k+h)ρ(k-h) + 2ρ(h)²ρ(k)² - 4ρ(h)ρ(k)ρ(k+h)],     (2)
/// zero at h = 0. The errors of neighbouring lags are strongly correlated: an estimate that strays does so
/// over a whole stretch of lags. The biased estimate's error is n_h/N as large (stats/spatial/pairs.hpp).
/// With missing heights n_h counts the pairs that are there, and w_h(k) is that of the complete field times the part of
/// the points that have a partner at k: exact at k = 0 and far too many to count elsewhere, an upper bound where ρ ≥ 0.
///
/// Where the field is much longer than ρ, all sums are values of c = ρ*ρ and t = ρ*ρ*ρ. The errors e(h) of R(h)/R(0) over N
/// points have the covariance C/N, and the third cumulant 8 K/N²,
///     C(h,g) = c(h-g) + c(h+g) - 2ρ(g)c(h) - 2ρ(h)c(g) + 2ρ(h)ρ(g)c(0),                            (3)
///     K(h) = (3t(h) + t(3h))/4 - (3/2)ρ(h)(t(0) + t(2h)) + 3ρ(h)²t(h) - ρ(h)³t(0).                  (4)
/// Of a ρ that is tapered (stats/spatial/pairs.hpp) the sums over the plane are those over the pairs and triples of the field.
/// It has n - (|a| + |b| + |a+b|)/2 triples whose points lie a and then b apart, so that with the covariance matrix C of
/// its N = nx ny points
///     tr C³/N = Σ_a Σ_b ρ(a) ρ(b) ρ(a+b) (1 - Σ|p|/(2nx)) (1 - Σ|q|/(2ny)),                         (5)
/// Σ|p| and Σ|q| over the three lags, none longer than the field: a sum of convolutions at lag zero of ρ, |p|ρ, |q|ρ and
/// |pq|ρ. The mean square of a Gaussian field has the third cumulant 8 σ⁶ tr C³/N³, its mean known.
///
/// Accuracy  (1) for a known ρ; the sample mean in place of the known one changes it by O(1/n²). From an
///           estimate use its significant_lags (stats/uncertainty/effective_size.hpp). The rest to round-off.
/// Cost      (1), (2) a lag as many terms as there are lags where ρ is not zero; (3) for all lags one autocorrelation of ρ; t
///           and c together three transforms of up to (6P + 2)(6Q + 2) points; (5) four of (3P + 1)(3Q + 1).
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <functional>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

/// A lag, and ρ there.
struct CorrelatedLag {
  Shape lag;
  double rho;
};

/// C of (3), of any c.
using Convolution = std::function<double(Index, Index)>;
double bartlett_covariance(const Convolution& c, const CorrelatedLag& h, const CorrelatedLag& g);
/// The errors' correlation, C with a diagonal of 1.
Eigen::MatrixXd bartlett_correlation(const Convolution& c, const std::vector<CorrelatedLag>& lags);

/// c and t on the torus of a periodic field, or on one so wide that nothing wraps.
class CorrelationPowers {
 public:
  /// Of a periodic field the lags up to half a period count.
  CorrelationPowers(const LagField& all, const Grid& grid);

  double second(Index p, Index q) const { return at(second_, p, q); }  ///< c
  double third(Index p, Index q) const { return at(third_, p, q); }    ///< t
  /// K of (4).
  double third_cumulant(const CorrelatedLag& h) const;

 private:
  static double at(const Field& table, Index p, Index q);

  Field second_, third_;
};

/// (5): of a ρ that is normalised, 1 for white noise and N where all heights are one.
double mean_of_triples(const LagField& rho, const Grid& grid);

class AcfError {
 public:
  AcfError(const LagField& correlation, const Pairs& pairs);

  /// √(1)/σ², the standard error of R(p,q) relative to R(0,0).
  double absolute(Index p, Index q) const;
  /// √(2), the standard error of ρ(p,q) = R(p,q)/R(0,0).
  double normalised(Index p, Index q) const;
  /// (2) at all lags up to these, with w_h(k) = w_0(k): √(C(h,h)/n_h) of a ρ that is tapered by √w_0.
  LagField normalised(Shape max_lag) const;
  /// How the errors of lags are correlated, by (3) of the same ρ.
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
