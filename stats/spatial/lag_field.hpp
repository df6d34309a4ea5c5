/// Functions of the lag, such as an autocorrelation R(p,q), on the half-plane 0 ≤ p ≤ P, |q| ≤ Q.
///
/// The half-plane holds the whole autocorrelation of a real field, because R(-p,-q) = R(p,q). For an oblique
/// lay R(p,-q) ≠ R(p,q).
///
/// Copies share their values.
#pragma once

#include <memory>

#include "core/field.hpp"

namespace asperity {

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

}  // namespace asperity
