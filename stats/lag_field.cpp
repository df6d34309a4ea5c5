#include "stats/lag_field.hpp"

#include <cmath>
#include <utility>

#include "grid/error.hpp"

namespace asperity {

LagField::LagField(Field half_plane) : values_(std::move(half_plane)) {
  if (values_.rows() < 1 || values_.cols() % 2 == 0)
    throw DataError("acf", "a half-plane of lags has at least one row and an odd number of columns");
}

double LagField::operator()(Index p, Index q) const {
  if (p < 0) return (*this)(-p, -q);
  return p <= max_p() && std::abs(q) <= max_q() ? values_(p, max_q() + q) : 0.0;
}

Eigen::ArrayXd LagField::along_x() const { return values_.col(max_q()); }

Eigen::ArrayXd LagField::along_y() const { return values_.row(0).tail(max_q() + 1).transpose(); }

LagField LagField::normalised() const {
  const double variance = (*this)(0, 0);
  if (!(variance > 0)) throw DataError("acf", "the variance R(0,0) is not positive");
  return LagField(values_ / variance);
}

}  // namespace asperity
