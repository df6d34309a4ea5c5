/// The algebra of a correlation: power sums, self-convolutions, and the covariance of the errors of its
/// estimates.
///
/// For a correlation ρ over N = nx ny points, a share v of which has a partner at a lag,
///     S_k = Σ_{p,q} v(p,q) ρ(p,q)ᵏ,     v = (1 - |p|/nx)(1 - |q|/ny), 1 on a periodic grid,          (1)
/// without missing heights (stats/spatial/pairs.hpp). With the tapered ρ√v, sums over the plane are sums over
/// the pairs of the field. With
///     c = ρ*ρ                                                                                        (2)
/// the errors e(h) of R(h)/R(0) have the covariance C/N (Bartlett),
///     C(h,g) = c(h-g) + c(h+g) - 2ρ(g)c(h) - 2ρ(h)c(g) + 2ρ(h)ρ(g)c(0).                              (3)
///
/// Accuracy  round-off: for c, ε log2(P) Σρ² with the P points of the transform.
/// Cost      (1) at most 512 multiplications per lag, fewer if ρᵏ vanishes; c one autocorrelation of ρ.
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

 private:
  LagField rho_;
  Pairs pairs_;
};

/// C of (3), for any c.
double bartlett_covariance(const LagField& c, const CorrelatedLag& h, const CorrelatedLag& g);
/// C, normalised to a diagonal of 1.
Eigen::MatrixXd bartlett_correlation(const LagField& c, const std::vector<CorrelatedLag>& lags);

}  // namespace asperity
