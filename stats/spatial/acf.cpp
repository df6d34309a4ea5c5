#include "stats/spatial/acf.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/pairs.hpp"
#include "transform/lag_sums.hpp"

namespace asperity {
namespace {

void divide_by_pairs(Field& sums, const Pairs& pairs, Shape max_lag, int threads) {
  parallel_ranges(sums.rows(), threads, [&](Index begin, Index end, int) {
    for (Index p = begin; p < end; ++p)
      for (Index q = -max_lag.ny; q <= max_lag.ny; ++q) {
        const double fraction = pairs.pair_fraction(p, q);
        sums(p, max_lag.ny + q) = fraction > 0 ? sums(p, max_lag.ny + q) / fraction : NAN;
      }
  });
}

// Heights above their level, zero where one is missing.
RowSource above(const Field& z, const Mean& level, bool complete) {
  return [&z, level, complete](Index i, double* row) {
    Eigen::Map<Eigen::Array<double, 1, Eigen::Dynamic>> out(row, z.cols());
    out = (z.row(i) - level.base) - level.above;
    if (!complete) out = out.isNaN().select(0.0, out);
  };
}

// (5) over the pairs that are there. With u the squares and m 1, both zero where a point is missing, the sums
// of squares are the correlations of u with m and of m with u: a quarter of those of u + m less those of u -
// m, twice over.
LagField over_valid_pairs(const Field& d, const Pairs& pairs, const LagField& R, int threads) {
  const Grid& grid = pairs.grid();
  const Shape max_lag = R.max_lag();
  const Field u = zero_filled(d).square(), m = validity(d);
  const double scale = u.sum() / pairs.points();
  if (!(scale > 0)) throw DataError("heights", "every value is the same");
  const LagField both(
      (lag_sums(u / scale + m, grid, max_lag, threads) - lag_sums(u / scale - m, grid, max_lag, threads)) *
      (scale / 2));
  // Where no pair is, R is not a number.
  return LagField::of(max_lag, [&](Index p, Index q) {
    if (p == 0 && q == 0) return 0.0;
    return both(p, q) / (pairs.pair_fraction(p, q) * pairs.points()) - 2 * R(p, q);
  });
}

}  // namespace

void AcfParameters::check(const Grid& grid) const {
  const Shape most = longest_lags(grid);
  auto within = [](Index lag, Index bound) { return lag >= 0 && lag <= bound; };
  if (within(max_lag.nx, most.nx) && within(max_lag.ny, most.ny)) return;
  auto text = [](Shape s) { return std::to_string(s.nx) + "x" + std::to_string(s.ny); };
  throw ParameterError("max-lag",
                       "'" + text(max_lag) + "' is outside 0x0 to " + text(most) +
                           (grid.periodic.both() ? ", half the period" : ", the longest lags of the field"));
}

LagField estimate_autocorrelation(const Field& z, const Pairs& pairs, const AcfParameters& parameters) {
  const Grid& grid = pairs.grid();
  parameters.check(grid);
  const Mean level = parameters.level ? Mean{.base = *parameters.level} : mean_above_base(z);
  Field sums =
      lag_sums_of_rows(above(z, level, pairs.complete()), grid, parameters.max_lag, parameters.threads);
  sums /= pairs.points();
  const bool divided = grid.periodic.both() && pairs.complete();
  if (!divided && !parameters.biased) divide_by_pairs(sums, pairs, parameters.max_lag, parameters.threads);
  return LagField(std::move(sums));
}

LagField estimate_autocorrelation(const Field& z, const Grid& grid, const AcfParameters& parameters) {
  return estimate_autocorrelation(z, Pairs::of(z, grid, parameters.threads), parameters);
}

LagField structure_function(const Field& z, const Grid& grid, Shape max_lag, int threads) {
  const Field d = remove_form(z);
  const Pairs pairs = Pairs::of(d, grid, threads);
  const LagField R =
      estimate_autocorrelation(d, pairs, {.max_lag = max_lag, .level = 0.0, .threads = threads});
  if (!pairs.complete()) return over_valid_pairs(d, pairs, R, threads);
  if (grid.periodic.both()) return LagField(2 * (R(0, 0) - R.half_plane()));

  const Index nx = grid.shape.nx, ny = grid.shape.ny;
  const RectangleSums squares(d.square());
  return LagField::of(max_lag, [&](Index p, Index q) {
    if (p == 0 && q == 0) return 0.0;
    const Index right = std::max<Index>(q, 0), left = std::max<Index>(-q, 0);
    const Index rows = nx - p, columns = ny - right - left;
    const double both = squares(0, left, rows, columns) + squares(p, right, rows, columns);
    return both / static_cast<double>(rows * columns) - 2 * R(p, q);
  });
}

}  // namespace asperity
