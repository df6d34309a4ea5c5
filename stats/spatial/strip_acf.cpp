#include "stats/spatial/strip_acf.hpp"

#include <algorithm>
#include <cmath>

#include "stats/filter/missing.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {
namespace {

// n of a field without missing points.
Field complete_pairs(const Grid& grid, Shape max_lag) {
  const auto points = static_cast<double>(grid.shape.cells());
  return LagField::of(max_lag, [&](Index p, Index q) { return overlap(grid, p, q) * points; }).half_plane();
}

}  // namespace

StripAutocorrelation::StripAutocorrelation(const Grid& grid, Index rows, int threads)
    : grid_(grid),
      max_lag_{std::min(rows, grid.shape.nx) / 2, grid.shape.ny / 2},
      threads_(threads),
      sums_(Field::Zero(max_lag_.nx + 1, 2 * max_lag_.ny + 1)),
      counts_(sums_),
      complete_(sums_) {}

void StripAutocorrelation::add(const Field& strip) {
  const Grid open{shape_of(strip), grid_.dx, grid_.dy, false};
  const Shape lags{std::min(max_lag_.nx, strip.rows() - 1), max_lag_.ny};
  const bool missing = has_missing(strip);
  const Field complete = complete_pairs(open, lags);
  sums_.topRows(lags.nx + 1) += lag_sums(missing ? zero_filled(strip) : strip, open, lags, threads_);
  complete_.topRows(lags.nx + 1) += complete;
  counts_.topRows(lags.nx + 1) +=
      missing ? Field(lag_sums(validity(strip), open, lags, threads_).round()) : complete;
}

LagField StripAutocorrelation::estimate() const {
  return LagField((counts_ > 0.5).select(sums_ / counts_, NAN));
}

Pairs StripAutocorrelation::pairs() const {
  if ((counts_ == complete_).all()) return Pairs(grid_);
  const double cells = static_cast<double>(grid_.shape.cells());
  return Pairs(grid_, LagField::of(max_lag_, [&](Index p, Index q) {
                 const Index column = max_lag_.ny + q;
                 return counts_(p, column) / complete_(p, column) * overlap(grid_, p, q) * cells;
               }));
}

bool StripAutocorrelation::reaches_beyond(const LagField& correlation) const {
  const Index outside = correlation.max_p() + 1 - max_lag_.nx;
  return max_lag_.nx < grid_.shape.nx / 2 && outside > 0 &&
         (correlation.half_plane().bottomRows(outside).abs() > 0.1 * correlation(0, 0)).any();
}

}  // namespace asperity
