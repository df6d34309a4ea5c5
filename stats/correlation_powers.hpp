/// The convolutions of a correlation with itself, c = ρ*ρ and t = ρ*ρ*ρ, on the torus of a periodic field or on one
/// wide enough that nothing wraps.
///
/// They are the second and third powers of the spectrum; cumulants of quadratic forms of a Gaussian field, such as
/// its sample autocorrelation, are sums of their values.
///
/// Accuracy  round-off of the transforms.
/// Cost      one transform and two inverse ones of the torus, up to (6P + 2)(6Q + 2) points.
#pragma once

#include "grid/field.hpp"
#include "stats/lag_field.hpp"

namespace asperity {

class CorrelationPowers {
 public:
  CorrelationPowers(const LagField& rho, const Grid& grid);

  double second(Index p, Index q) const { return at(second_, p, q); }
  double third(Index p, Index q) const { return at(third_, p, q); }

 private:
  static double at(const Field& table, Index p, Index q);

  Field second_, third_;
};

}  // namespace asperity
