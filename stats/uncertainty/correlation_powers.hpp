/// The algebra of a correlation: its convolutions with itself, and the cumulants of estimates that are sums of these.
///
/// With c = ρ*ρ and t = ρ*ρ*ρ of a Gaussian field of N points, the errors e(h) of R(h)/R(0) have the covariance (Bartlett)
/// and the third cumulant
///     (1/N)  C(h,g),   C = c(h-g) + c(h+g) - 2ρ(g)c(h) - 2ρ(h)c(g) + 2ρ(h)ρ(g)c(0),                  (1)
///     (8/N²) K(h),     K = (3t(h) + t(3h))/4 - (3/2)ρ(h)(t(0) + t(2h)) + 3ρ(h)²t(h) - ρ(h)³t(0).      (2)
/// Those are sums over the plane; of a ρ that is tapered (stats/spatial/pairs.hpp) they are sums over the pairs and triples of
/// a field. A field has n - (|a| + |b| + |a+b|)/2 triples whose points lie a and then b apart, so that with the covariance
/// matrix C of its N = nx ny points
///     tr C³/N = Σ_a Σ_b ρ(a) ρ(b) ρ(a+b) (1 - Σ|p|/(2nx)) (1 - Σ|q|/(2ny)),                            (3)
/// Σ|p| and Σ|q| over the three lags, none longer than the field. Multiplied out, (3) is a sum of convolutions at lag zero of
/// ρ, |p|ρ, |q|ρ and |pq|ρ. The mean square of a Gaussian field has the third cumulant 8 σ⁶ tr C³/N³, its mean known.
///
/// Accuracy  round-off of the transforms.
/// Cost      one transform and two inverse ones of the torus, up to (6P + 2)(6Q + 2) points; (3) four of (3P + 1)(3Q + 1).
///
/// M. S. Bartlett, J. Roy. Statist. Soc. Suppl. 8 (1946) 27-41.
#pragma once

#include <functional>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

/// A lag, and ρ there.
struct CorrelatedLag {
  Shape lag;
  double rho;
};

/// C of (1), of any c.
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
  /// K of (2).
  double third_cumulant(const CorrelatedLag& h) const;

 private:
  static double at(const Field& table, Index p, Index q);

  Field second_, third_;
};

/// (3): of a ρ that is normalised, 1 for white noise and N where all heights are one.
double mean_of_triples(const LagField& rho, const Grid& grid);

}  // namespace asperity
