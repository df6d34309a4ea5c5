/// The algebra of a correlation: power sums, self-convolutions, and the covariance of the errors of its
/// estimates.
///
/// For a correlation ρ over N = nx ny points, a share v of which has a partner at a lag,
///     S_k = Σ_{p,q} v(p,q) ρ(p,q)ᵏ,     v = (1 - |p|/nx)(1 - |q|/ny), 1 on a periodic grid,          (1)
/// without missing heights (stats/spatial/pairs.hpp). With the tapered ρ√v, sums over the plane are sums over
/// the pairs and triples of the field. With
///     c = ρ*ρ,     t = ρ*ρ*ρ                                                                         (2)
/// the errors e(h) of R(h)/R(0) have the covariance C/N (Bartlett), and the third cumulant 8 K/N²,
///     C(h,g) = c(h-g) + c(h+g) - 2ρ(g)c(h) - 2ρ(h)c(g) + 2ρ(h)ρ(g)c(0),                              (3)
///     K(h) = (3t(h) + t(3h))/4 - (3/2)ρ(h)(t(0) + t(2h)) + 3ρ(h)²t(h) - ρ(h)³t(0).                   (4)
/// A field has n - (|a| + |b| + |a+b|)/2 triples of points at the successive distances a and b, so that its
/// covariance matrix C has
///     tr C³/N = Σ_a Σ_b ρ(a) ρ(b) ρ(a+b) (1 - Σ|p|/(2nx)) (1 - Σ|q|/(2ny)),                          (5)
/// Σ|p| and Σ|q| over the three lags, none longer than the field: convolutions at lag zero of ρ, |p|ρ, |q|ρ
/// and |pq|ρ. The mean square of a Gaussian field of known mean has the third cumulant 8 σ⁶ tr C³/N³.
///
/// Accuracy  round-off: for c and t, ε log2(P) Σρ² with the P points of the transform.
/// Cost      (1) at most 512 multiplications per lag, fewer if ρᵏ vanishes; c one autocorrelation of ρ; t
///           two transforms of (6P + 2)(6Q + 2) points; (5) four of (3P + 1)(3Q + 1).
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

/// A lag, and ρ there.
struct CorrelatedLag {
  Shape lag;
  double rho;
};

/// The sums (1) from one lag after the other.
class PowerSums {
 public:
  static constexpr int powers = 512;
  using Sums = std::array<double, powers + 1>;

  /// `weight` as for_each_lag gives it.
  void add(double weight, double rho) {
    double power = weight;
    for (std::size_t k = 1; k < sums_.size() && std::abs(power) > 1e-18; ++k) sums_[k] += power *= rho;
  }
  /// S_k, 1 ≤ k ≤ powers; a sum that is negative by noise is set to zero.
  Sums sums() const;

 private:
  Sums sums_ = {};
};

class CorrelationAlgebra {
 public:
  /// The correlation need not be normalised. Throws DataError("acf", …) if R(0,0) is not positive.
  CorrelationAlgebra(const LagField& correlation, const Pairs& pairs);

  const LagField& rho() const { return rho_; }
  PowerSums::Sums power_sums() const;
  /// c of the tapered ρ at the lags up to max_lag, over the period or over the plane.
  LagField convolution(Shape max_lag, bool periodic) const;
  /// K at each lag, for the tapered ρ.
  Eigen::ArrayXd third_cumulants(const std::vector<CorrelatedLag>& lags) const;
  /// (5) for a complete field: 1 for white noise, N² if all heights are equal.
  double mean_of_triples() const;

 private:
  LagField rho_;
  Pairs pairs_;
};

/// C of (3), for any c.
double bartlett_covariance(const LagField& c, const CorrelatedLag& h, const CorrelatedLag& g);
/// C, normalised to a diagonal of 1.
Eigen::MatrixXd bartlett_correlation(const LagField& c, const std::vector<CorrelatedLag>& lags);

}  // namespace asperity
