#include "stats/spatial/lag_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "core/large_field.hpp"

namespace asperity {

LagField::LagField(Field half_plane) : LagField(std::make_shared<const Field>(std::move(half_plane))) {}

LagField::LagField(std::shared_ptr<const Field> values) : LagField(values, Slabs(values->rows())) {}

LagField::LagField(Field own_rows, const Slabs& rows)
    : LagField(std::make_shared<const Field>(std::move(own_rows)), rows) {}

LagField::LagField(std::shared_ptr<const Field> values, const Slabs& rows)
    : rows_(rows), first_(rows.own().first), values_(std::move(values)) {
  if (rows_.rows() < 1 || values_->cols() % 2 == 0)
    throw DataError("acf", "a half-plane of lags needs at least one row and an odd number of columns");
}

double LagField::operator()(Index p, Index q) const {
  if (p < 0) return (*this)(-p, -q);
  if (p > max_p() || std::abs(q) > max_q()) return 0;
  const Index row = p - first_;
  if (row < 0 || row >= values_->rows()) throw std::logic_error("a lag that another rank has");
  return (*values_)(row, max_q() + q);
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
  return LagField(rows_of(values_->middleCols(max_q() - q, 2 * q + 1), rows_, Extent{0, p + 1}));
}

LagField LagField::normalised() const {
  const double variance = at_zero();
  if (!(variance > 0)) throw DataError("acf", "the variance R(0,0) is not positive");
  if (variance == 1) return *this;
  Field out = large_field(shape_of(*values_));
  out = *values_ / variance;
  return {std::move(out), rows_};
}

}  // namespace asperity
