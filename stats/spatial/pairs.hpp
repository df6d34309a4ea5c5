/// The number of pairs of points of a field at each lag.
///
/// A field of nx × ny points has (nx - |p|)(ny - |q|) pairs at lag (p,q), or nx ny if it is periodic. If
/// heights are missing, a pair counts if both of its points are measured,
///     n(p,q) = Σ m(i,j) m(i+p, j+q),   m = 1 where there is a height, 0 elsewhere,                    (1)
/// and sums over pairs become sums over lags with these weights.
///
/// Accuracy  exact: (1) is summed by the transform (transform/lag_sums.hpp) and rounded to whole numbers,
///           with an error below 0.1 before rounding for fields of 10¹² points.
/// Cost      none for a complete field; else one pass over the field and one autocorrelation at all its lags.
#pragma once

#include <array>
#include <functional>
#include <memory>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

class Pairs {
 public:
  /// Of a field without missing points.
  Pairs(const Grid& grid) : grid_(grid), points_(static_cast<double>(grid.shape.cells())) {}
  /// With n as counted or estimated at some lags, and 0 at others.
  Pairs(const Grid& grid, LagField counts);
  /// Of a field whose missing points are NaN.
  static Pairs of(const Field& z, const Grid& grid, int threads = 1);

  const Grid& grid() const { return grid_; }
  bool complete() const { return !counts_; }  ///< nothing is missing
  double points() const { return points_; }   ///< not missing
  /// The sides of a complete field whose pairs are as far apart as these, in points; about those of the grid.
  std::array<double, 2> sides() const;
  /// n(p,q)/n(0,0); for a complete field its overlap with itself at the lag.
  double pair_fraction(Index p, Index q) const;
  /// What for_each_lag weighs a lag of the half-plane with.
  double weight(Index p, Index q) const;
  /// n(p,q) / (n(0,0) overlap(p,q)): 1 if pairs end only at the edges of the field.
  double density(Index p, Index q) const;

 private:
  Grid grid_;
  double points_;
  std::shared_ptr<const LagField> counts_ = {};
};

/// The share of a complete field's points that have a partner at a lag: (1 - |p|/nx)(1 - |q|/ny), 1 if
/// periodic.
double overlap(const Grid& grid, Index p, Index q);

/// The longest lags at which a field has pairs; half the field if periodic.
Shape longest_lags(const Grid& grid);

/// ρ √(n(p,q)/n(0,0)) at the lags of the field. Sums of its products are weighted by the field's pairs:
/// exactly for two factors of one lag, as in Σ w ρ²; for Σ Σ ρ ρ ρ over closed triples of lags to first order
/// in the ratio of lag to field, at most a tenth too large, along a side of constant height.
LagField tapered(const LagField& rho, const Pairs& pairs);

/// Calls visit(p, q, weight) for the lags of the half-plane that have pairs. Σ weight f(p,q) is the average
/// over the field's points of Σ f over all their partners: the weight is pair_fraction(p,q), doubled for the
/// lags (-p,-q), and halved at half a period, where p and -p coincide.
void for_each_lag(const LagField& lags, const Pairs& pairs,
                  const std::function<void(Index, Index, double)>& visit);

}  // namespace asperity
