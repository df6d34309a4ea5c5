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

namespace asperity {

// ---- values at lags ----

/// Functions of the lag, such as an autocorrelation R(p,q), on the half-plane 0 ≤ p ≤ P, |q| ≤ Q.
///
/// The half-plane holds the whole autocorrelation of a real field, because R(-p,-q) = R(p,q). For an oblique
/// lay R(p,-q) ≠ R(p,q).
///
/// Copies share their values.

class LagField {
 public:
  /// `half_plane` is (P+1) × (2Q+1), row p, column Q + q.
  explicit LagField(Field half_plane);
  /// value(p, q) at all lags up to max_lag.
  static LagField of(Shape max_lag, const auto& value) {
    return LagField(Field::NullaryExpr(max_lag.nx + 1, 2 * max_lag.ny + 1, [&](Index p, Index column) {
      return static_cast<double>(value(p, column - max_lag.ny));
    }));
  }

  Index max_p() const { return half_plane().rows() - 1; }
  Index max_q() const { return half_plane().cols() / 2; }
  Shape max_lag() const { return {max_p(), max_q()}; }
  /// The value at any lag, zero beyond P and Q.
  double operator()(Index p, Index q) const;
  /// The largest |p| and |q| with a value other than zero.
  Shape reach() const;
  /// The lags up to max_lag, or up to P and Q if these are less.
  LagField within(Shape max_lag) const;
  /// Row p, column Q + q.
  const Field& half_plane() const { return *values_; }

  Eigen::ArrayXd along_x() const { return half_plane().col(max_q()); }
  Eigen::ArrayXd along_y() const { return half_plane().row(0).tail(max_q() + 1).transpose(); }
  /// R(p,q)/R(0,0). Throws DataError("acf", …) if R(0,0) is not positive.
  LagField normalised() const;
  /// f(R) at all lags.
  template <class Function>
  LagField mapped(const Function& f) const {
    return LagField(half_plane().unaryExpr(f));
  }

 private:
  std::shared_ptr<const Field> values_;
};

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

// ---- sums over rectangles ----

/// Sums over rectangles of a field, each of four additions: a table of partial sums.
///
/// Accuracy  round-off ε Σ|f|.

class RectangleSums {
 public:
  explicit RectangleSums(const Field& f) : before_(Field::Zero(f.rows() + 1, f.cols() + 1)) {
    for (Index i = 0; i < f.rows(); ++i) {
      double row = 0;
      for (Index j = 0; j < f.cols(); ++j) before_(i + 1, j + 1) = before_(i, j + 1) + (row += f(i, j));
    }
  }
  /// Over `rows` × `columns` points from (i, j) on.
  double operator()(Index i, Index j, Index rows, Index columns) const {
    return before_(i + rows, j + columns) - before_(i, j + columns) - before_(i + rows, j) + before_(i, j);
  }

 private:
  Field before_;  // (i, j): over the points with smaller indices both
};

}  // namespace asperity
