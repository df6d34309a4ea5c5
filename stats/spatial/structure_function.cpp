#include "stats/spatial/structure_function.hpp"

#include <utility>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/lag_sums.hpp"

namespace asperity {
namespace {

// Sums of a field over rectangles.
class PartialSums {
 public:
  explicit PartialSums(const Field& f) : sums_(Field::Zero(f.rows() + 1, f.cols() + 1)) {
    for (Index i = 0; i < f.rows(); ++i) {
      double row = 0;
      for (Index j = 0; j < f.cols(); ++j) sums_(i + 1, j + 1) = sums_(i, j + 1) + (row += f(i, j));
    }
  }
  /// Over nx × ny points from (i, j) on.
  double operator()(Index i, Index j, Index nx, Index ny) const {
    return sums_(i + nx, j + ny) - sums_(i, j + ny) - sums_(i + nx, j) + sums_(i, j);
  }

 private:
  Field sums_;
};

// (1) over the pairs that are there. With u the squares, zero where a point is missing, and m 1 where it is there,
// Σ_first z² + Σ_second z² is the correlation of u with m and of m with u: a quarter of those of u + m less those of
// u - m, twice over.
LagField over_valid_pairs(const Field& d, const Pairs& pairs, Shape max_lag, int threads) {
  const Grid& grid = pairs.grid();
  const Field u = zero_filled(d).square(), m = validity(d);
  const double scale = u.sum() / pairs.points();
  if (!(scale > 0)) throw DataError("heights", "every value is the same");
  const Field both =
      (lag_sums(u / scale + m, grid, max_lag, threads) - lag_sums(u / scale - m, grid, max_lag, threads)) *
      (scale / 2);
  const LagField R =
      estimate_autocorrelation(d, pairs, {.max_lag = max_lag, .level = 0.0, .threads = threads});
  return LagField(Field::NullaryExpr(both.rows(), both.cols(), [&](Index p, Index column) {
    const Index q = column - max_lag.ny;  // where no pair is, R is not a number
    return both(p, column) / (pairs.share(p, q) * pairs.points()) - 2 * R(p, q);
  }));
}

}  // namespace

LagField structure_function(const Field& z, const Grid& grid, Shape max_lag, int threads) {
  const Field d = remove_form(z);
  if (const Pairs pairs = Pairs::of(d, grid, threads); !pairs.complete()) {
    AcfParameters{.max_lag = max_lag}.check(grid);
    return over_valid_pairs(d, pairs, max_lag, threads);
  }
  const LagField R =
      estimate_autocorrelation(d, grid, {.max_lag = max_lag, .level = 0.0, .threads = threads});
  if (grid.periodic) return LagField(2 * (R(0, 0) - R.half_plane()));

  const PartialSums squares(d.square());
  const auto [nx, ny] = grid.shape;
  Field out(max_lag.nx + 1, 2 * max_lag.ny + 1);
  for (Index p = 0; p <= max_lag.nx; ++p)
    for (Index q = -max_lag.ny; q <= max_lag.ny; ++q) {
      const Index right = std::max<Index>(q, 0), left = std::max<Index>(-q, 0), rows = nx - p,
                  columns = ny - right - left;
      const double both = squares(0, left, rows, columns) + squares(p, right, rows, columns);
      out(p, max_lag.ny + q) = both / static_cast<double>(rows * columns) - 2 * R(p, q);
    }
  return LagField(std::move(out));
}

}  // namespace asperity
