/// Functions of the lag, such as an autocorrelation R(p,q), on the half-plane 0 ≤ p ≤ P, |q| ≤ Q.
///
/// A real field's autocorrelation is even under point reflection, R(-p,-q) = R(p,q), so that the half-plane
/// holds all of it. It need not be even in p and q separately: R(p,-q) ≠ R(p,q) where the lay is oblique.
///
/// A field of nx × ny points holds (nx - |p|)(ny - |q|) pairs at lag (p,q), or nx ny when it is periodic;
/// sums over pairs become sums over lags with these weights.
#pragma once

#include <functional>

#include "grid/field.hpp"

namespace asperity {

class LagField {
 public:
  /// `half_plane` is (P+1) × (2Q+1), row p, column Q + q.
  explicit LagField(Field half_plane);

  Index max_p() const { return values_.rows() - 1; }
  Index max_q() const { return values_.cols() / 2; }
  /// The value at any lag, zero beyond P and Q.
  double operator()(Index p, Index q) const;
  /// Row p, column Q + q.
  const Field& half_plane() const { return values_; }

  Eigen::ArrayXd along_x() const;  ///< R(p,0), p = 0…P
  Eigen::ArrayXd along_y() const;  ///< R(0,q), q = 0…Q
  /// R(p,q)/R(0,0). Throws DataError("acf", …) when R(0,0) is not positive.
  LagField normalised() const;

 private:
  Field values_;
};

/// The share of a field's points that have a partner at lag (p,q): (1 - |p|/nx)(1 - |q|/ny), 1 when periodic.
double overlap(const Grid& grid, Index p, Index q);

/// Calls visit(p, q, weight) for the half-plane's lags such that Σ weight f(p,q) is the average over the
/// field's points of Σ f over all their partners: overlap, doubled for the lags (-p,-q), and halved at lags
/// of half a period, where p and -p are one.
void for_each_lag(const LagField& lags, const Grid& grid,
                  const std::function<void(Index, Index, double)>& visit);

}  // namespace asperity
