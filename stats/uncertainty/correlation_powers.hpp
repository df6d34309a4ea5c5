/// The convolutions of a correlation with itself, c = ρ*ρ and t = ρ*ρ*ρ, on the torus of a periodic field or on one
/// wide enough that nothing wraps.
///
/// They are the second and third powers of the spectrum; cumulants of quadratic forms of a Gaussian field, such as
/// its sample autocorrelation, are sums of their values.
///
/// Those are sums over the plane. A finite field has n - |p| pairs at lag p, and n - (|a| + |b| + |a+b|)/2 triples whose points
/// lie a and then b apart, so that with the covariance matrix C of its N = nx ny points the sum over its triples is
///     tr C³/N = Σ_a Σ_b ρ(a) ρ(b) ρ(a+b) (1 - Σ|p|/(2nx)) (1 - Σ|q|/(2ny)),                            (1)
/// Σ|p| and Σ|q| over the three lags, none longer than the field. Multiplied out, (1) is a sum of convolutions at lag zero of
/// ρ, |p|ρ, |q|ρ and |pq|ρ. The mean square of a Gaussian field has the third cumulant 8 σ⁶ tr C³/N³, its mean known.
///
/// Accuracy  round-off of the transforms.
/// Cost      one transform and two inverse ones of the torus, up to (6P + 2)(6Q + 2) points; (1) four of (3P + 1)(3Q + 1).
#pragma once

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

class CorrelationPowers {
 public:
  /// Of a periodic field the lags up to half a period count.
  CorrelationPowers(const LagField& all, const Grid& grid);

  double second(Index p, Index q) const { return at(second_, p, q); }
  double third(Index p, Index q) const { return at(third_, p, q); }

 private:
  static double at(const Field& table, Index p, Index q);

  Field second_, third_;
};

/// (1): of a ρ that is normalised, 1 for white noise and N where all heights are one.
double mean_of_triples(const LagField& rho, const Grid& grid);

}  // namespace asperity
