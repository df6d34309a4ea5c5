#include "stats/spatial/lag_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/memory.hpp"

namespace asperity {

LagField::LagField(Field half_plane) : values_(std::make_shared<const Field>(std::move(half_plane))) {
  if (values_->rows() < 1 || values_->cols() % 2 == 0)
    throw DataError("acf", "a half-plane of lags needs at least one row and an odd number of columns");
}

double LagField::operator()(Index p, Index q) const {
  if (p < 0) return (*this)(-p, -q);
  return p > max_p() || std::abs(q) > max_q() ? 0 : (*values_)(p, max_q() + q);
}

Shape LagField::reach() const {
  Shape out{0, 0};
  for (Index p = 0; p < values_->rows(); ++p)
    for (Index column = 0; column < values_->cols(); ++column)
      if ((*values_)(p, column) != 0) out = {p, std::max(out.ny, std::abs(column - max_q()))};
  return out;
}

LagField LagField::within(Shape max_lag) const {
  const Index p = std::min(max_lag.nx, max_p()), q = std::min(max_lag.ny, max_q());
  return LagField(values_->block(0, max_q() - q, p + 1, 2 * q + 1));
}

LagField LagField::normalised() const {
  const double variance = (*this)(0, 0);
  if (!(variance > 0)) throw DataError("acf", "the variance R(0,0) is not positive");
  if (variance == 1) return *this;
  Field out = large_field(shape_of(*values_));
  out = *values_ / variance;
  return LagField(std::move(out));
}

}  // namespace asperity
