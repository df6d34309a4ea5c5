/// How many pairs of points a field holds at each lag.
///
/// A field of nx × ny points holds (nx - |p|)(ny - |q|) pairs at lag (p,q), or nx ny when it is periodic.
/// Where heights are missing a pair counts when both of its points are there,
///     n(p,q) = Σ m(i,j) m(i+p, j+q),   m = 1 where there is a height, 0 elsewhere,                    (1)
/// and sums over pairs become sums over lags with these weights.
///
/// Accuracy  exact: (1) is summed by the transform (transform/lag_sums.hpp) and rounded to whole numbers,
///           from which it is below 0.1 away for fields of 10¹² points.
/// Cost      of a complete field none; else one pass over the field and one autocorrelation at all its lags.
#pragma once

#include <functional>
#include <memory>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

class Pairs {
 public:
  /// Of a field without missing points.
  Pairs(const Grid& grid) : grid_(grid), points_(static_cast<double>(grid.shape.cells())) {}
  /// With n as it is counted, or estimated, at some lags; at others no pairs are known.
  Pairs(const Grid& grid, LagField counts);
  /// Of a field whose missing points are NaN.
  static Pairs of(const Field& z, const Grid& grid, int threads = 1);

  const Grid& grid() const { return grid_; }
  bool complete() const { return !counts_; }  ///< nothing is missing
  double points() const { return points_; }   ///< that are there
  /// n(p,q)/n(0,0); of a complete field its overlap with itself at the lag.
  double pair_fraction(Index p, Index q) const;
  /// n(p,q) over n(0,0) overlap(p,q), what it were if only the field's edges ended pairs.
  double density(Index p, Index q) const;

 private:
  Grid grid_;
  double points_;
  std::shared_ptr<const LagField> counts_ = {};
};

/// The part of a complete field's points that have a partner at a lag: (1 - |p|/nx)(1 - |q|/ny), 1 when
/// periodic.
double overlap(const Grid& grid, Index p, Index q);

/// The longest lags at which a field has pairs; half of it when periodic.
Shape longest_lags(const Grid& grid);

/// ρ √(n(p,q)/n(0,0)) at the lags that the field has. Sums of products of it are weighted by the field's
/// pairs: exactly where two factors are of one lag, as in Σ w ρ²; in Σ Σ ρ ρ ρ over triples of lags that end
/// where they began to first order in lag over length, a tenth too large at the most along a side that is all
/// one height.
LagField tapered(const LagField& rho, const Pairs& pairs);

/// Calls visit(p, q, weight) for those of the half-plane's lags that have pairs, such that Σ weight f(p,q) is
/// the average over the field's points of Σ f over all their partners: pair_fraction(p,q), doubled for the
/// lags (-p,-q), halved at half a period, where p and -p are one.
void for_each_lag(const LagField& lags, const Pairs& pairs,
                  const std::function<void(Index, Index, double)>& visit);

}  // namespace asperity
