#include "stats/lag_field.hpp"

#include <cmath>
#include <utility>

#include "grid/error.hpp"

namespace asperity {
namespace {

double overlap(Index lag, Index n, bool periodic) {
  if (periodic) return 1;
  return std::abs(lag) < n ? 1 - static_cast<double>(std::abs(lag)) / static_cast<double>(n) : 0;
}

double half_period_share(Index lag, Index n, bool periodic) {
  return periodic && 2 * std::abs(lag) == n ? 0.5 : 1;
}

}  // namespace

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

double overlap(const Grid& grid, Index p, Index q) {
  return overlap(p, grid.shape.nx, grid.periodic) * overlap(q, grid.shape.ny, grid.periodic);
}

void for_each_lag(const LagField& lags, const Grid& grid,
                  const std::function<void(Index, Index, double)>& visit) {
  const auto [nx, ny] = grid.shape;
  for (Index p = 0; p <= lags.max_p(); ++p)
    for (Index q = -lags.max_q(); q <= lags.max_q(); ++q)
      visit(p, q,
            (p > 0 ? 2 : 1) * overlap(grid, p, q) * half_period_share(p, nx, grid.periodic) *
                half_period_share(q, ny, grid.periodic));
}

}  // namespace asperity
