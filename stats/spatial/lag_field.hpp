/// Functions of the lag, such as an autocorrelation R(p,q), on the half-plane 0 ≤ p ≤ P, |q| ≤ Q.
///
/// It holds all of a real field's autocorrelation, R(-p,-q) = R(p,q); R(p,-q) ≠ R(p,q) where the lay is
/// oblique.
#pragma once

#include "core/field.hpp"

namespace asperity {

class LagField {
 public:
  /// `half_plane` is (P+1) × (2Q+1), row p, column Q + q.
  explicit LagField(Field half_plane);
  /// value(p, q) at all lags up to these.
  static LagField of(Shape max_lag, const auto& value) {
    return LagField(Field::NullaryExpr(max_lag.nx + 1, 2 * max_lag.ny + 1, [&](Index p, Index column) {
      return static_cast<double>(value(p, column - max_lag.ny));
    }));
  }

  Index max_p() const { return values_.rows() - 1; }
  Index max_q() const { return values_.cols() / 2; }
  Shape max_lag() const { return {max_p(), max_q()}; }
  /// The value at any lag, zero beyond P and Q.
  double operator()(Index p, Index q) const;
  /// The farthest |p| and |q| of lags that are not zero.
  Shape reach() const;
  /// The lags up to these, or as far as there are any.
  LagField within(Shape max_lag) const;
  /// Row p, column Q + q.
  const Field& half_plane() const { return values_; }

  Eigen::ArrayXd along_x() const { return values_.col(max_q()); }
  Eigen::ArrayXd along_y() const { return values_.row(0).tail(max_q() + 1).transpose(); }
  /// R(p,q)/R(0,0). Throws DataError("acf", …) when R(0,0) is not positive.
  LagField normalised() const;

 private:
  Field values_;
};

}  // namespace asperity
