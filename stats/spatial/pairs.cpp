#include "stats/spatial/pairs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "stats/filter/missing.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {
namespace {

// A lag of half a period is its own mirror image.
double times_met(Index lag, Index n, bool periodic) { return periodic && 2 * std::abs(lag) == n ? 0.5 : 1; }

// The same lag within half a period.
Index folded(Index lag, Index n) {
  const Index within = (lag % n + n) % n;
  return 2 * within > n ? within - n : within;
}

}  // namespace

Pairs::Pairs(const Grid& grid, LagField counts)
    : grid_(grid), points_(counts(0, 0)), counts_(std::make_shared<const LagField>(std::move(counts))) {}

Pairs Pairs::of(const Field& z, const Grid& grid, int threads) {
  if (!has_missing(z)) return Pairs(grid);
  const RowSource measured = [&z](Index i, double* row) {
    for (Index j = 0; j < z.cols(); ++j) row[j] = std::isnan(z(i, j)) ? 0 : 1;
  };
  Field counts = lag_sums_of_rows(measured, grid, longest_lags(grid), threads);
  counts = counts.round();
  return {grid, LagField(std::move(counts))};
}

double Pairs::pair_fraction(Index p, Index q) const {
  if (complete()) return overlap(grid_, p, q);
  if (grid_.periodic.both()) p = folded(p, grid_.shape.nx), q = folded(q, grid_.shape.ny);
  return (*counts_)(p, q) / points_;
}

std::array<double, 2> Pairs::sides() const {
  const auto nx = static_cast<double>(grid_.shape.nx), ny = static_cast<double>(grid_.shape.ny);
  if (complete()) return {nx, ny};
  // Σ 1, Σ |p|, Σ |q|.
  auto sums = [this](const Pairs& pairs) {
    Eigen::Array3d out = Eigen::Array3d::Zero();
    for_each_lag(*counts_, pairs, [&](Index p, Index q, double weight) {
      out += weight * Eigen::Array3d(1, static_cast<double>(std::abs(p)), static_cast<double>(std::abs(q)));
    });
    return out;
  };
  const Eigen::Array3d own = sums(*this), all = sums(Pairs(grid_));
  auto side = [&](Index axis, double n) {
    return all(axis) > 0 ? std::max(1.0, n * (own(axis) / own(0)) / (all(axis) / all(0))) : n;
  };
  return {side(1, nx), side(2, ny)};
}

double Pairs::weight(Index p, Index q) const {
  const auto [nx, ny] = grid_.shape;
  return (p > 0 ? 2 : 1) * pair_fraction(p, q) * times_met(p, nx, grid_.periodic.both()) *
         times_met(q, ny, grid_.periodic.both());
}

double Pairs::density(Index p, Index q) const {
  if (complete()) return 1;
  const double most = overlap(grid_, p, q);
  return most > 0 ? pair_fraction(p, q) / most : 0;
}

double overlap(const Grid& grid, Index p, Index q) {
  auto part = [](Index lag, Index n) {
    return std::max(0.0, 1 - static_cast<double>(std::abs(lag)) / static_cast<double>(n));
  };
  return grid.periodic.both() ? 1 : part(p, grid.shape.nx) * part(q, grid.shape.ny);
}

Shape longest_lags(const Grid& grid) {
  const auto [nx, ny] = grid.shape;
  return grid.periodic.both() ? Shape{nx / 2, ny / 2} : Shape{nx - 1, ny - 1};
}

LagField tapered(const LagField& rho, const Pairs& pairs) {
  const LagField inside = rho.within(longest_lags(pairs.grid()));
  return LagField::of(inside.max_lag(),
                      [&](Index p, Index q) { return inside(p, q) * std::sqrt(pairs.pair_fraction(p, q)); });
}

void for_each_lag(const LagField& lags, const Pairs& pairs,
                  const std::function<void(Index, Index, double)>& visit) {
  const Shape longest = longest_lags(pairs.grid());
  const Index P = std::min(lags.max_p(), longest.nx), Q = std::min(lags.max_q(), longest.ny);
  for (Index p = 0; p <= P; ++p)
    for (Index q = -Q; q <= Q; ++q)
      if (const double weight = pairs.weight(p, q); weight > 0) visit(p, q, weight);
}

// ---- values at lags ----

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
