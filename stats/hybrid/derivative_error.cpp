#include "stats/hybrid/derivative_error.hpp"

#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// (1), as far as R reaches.
LagField difference(const LagField& R, bool x) {
  const Index P = R.max_p() - (x ? 1 : 0), Q = R.max_q() - (x ? 0 : 1), dp = x ? 1 : 0, dq = 1 - dp;
  if (P < 0 || Q < 0) throw DataError("acf", "errors of derivatives need two lags in x and y");
  return LagField::of({P, Q},
                      [&](Index p, Index q) { return 2 * R(p, q) - R(p + dp, q + dq) - R(p - dp, q - dq); });
}

constexpr double round_off = 1e-13;  // of R(0,0), that a second difference of R may hold

double relative_error(const LagField& counted, const Pairs& pairs) {
  return counted(0, 0) > 0 ? std::sqrt(2 / EffectiveSampleSize(counted, pairs).effective(2)) : unknown;
}

double squared(double relative, double value) { return value > 0 ? std::pow(relative * value, 2) : 0; }

// Σ w D² over the plane, wherever one of the lags around counts.
double cross_sum(const LagField& R, const LagField& x, const LagField& y, const Pairs& pairs) {
  auto counts = [&](Index p, Index q) { return x(p, q) != 0 || y(p, q) != 0; };
  double sum = 0;
  for (Index p = 1 - R.max_p(); p < R.max_p(); ++p)
    for (Index q = 1 - R.max_q(); q < R.max_q(); ++q) {
      if (!counts(p, q) && !counts(p - 1, q) && !counts(p, q + 1) && !counts(p - 1, q + 1)) continue;
      const double D = R(p, q) + R(p - 1, q + 1) - R(p - 1, q) - R(p, q + 1);
      sum += pairs.pair_fraction(p, q) * D * D;
    }
  return sum;
}

// Not numbers where one of the points is missing, as the last one is that has no neighbour.
Field differences_along_x(const Field& z, bool periodic) {
  const Index last = z.rows() - 1;
  Field out = Field::Constant(z.rows(), z.cols(), unknown);
  out.topRows(last) = z.bottomRows(last) - z.topRows(last);
  if (periodic) out.row(last) = z.row(0) - z.row(last);
  return out;
}

Field differences_along_y(const Field& z, bool periodic) {
  return differences_along_x(z.transpose(), periodic).transpose();
}

}  // namespace

DerivativeErrors derivative_errors(const LagField& correlation, const DifferencePairs& pairs,
                                   bool estimated) {
  const LagField rho = correlation.normalised();
  // Two for (1) twice, two that it takes.
  const LagField R = estimated ? rho : LagField::of({rho.max_p() + 4, rho.max_q() + 4}, rho);
  const LagField dx = difference(R, true), dy = difference(R, false);
  // The lags of a difference's correlation that its errors rest on; none where the field does not change that way.
  auto counted = [&](const LagField& D, const Pairs& p) {
    if (!(D(0, 0) > round_off * R(0, 0))) return LagField(Field::Zero(1, 1));
    return estimated ? significant_lags(D, p) : D.normalised();
  };
  const LagField x = counted(dx, pairs.dx), y = counted(dy, pairs.dy);
  DerivativeErrors out{.m20 = relative_error(x, pairs.dx),
                       .m02 = relative_error(y, pairs.dy),
                       .m40 = relative_error(counted(difference(dx, true), pairs.dxx), pairs.dxx),
                       .m04 = relative_error(counted(difference(dy, false), pairs.dyy), pairs.dyy)};
  const Grid& grid = pairs.heights.grid();
  const double m20 = x(0, 0) > 0 ? dx(0, 0) / (grid.dx * grid.dx) : 0,
               m02 = y(0, 0) > 0 ? dy(0, 0) / (grid.dy * grid.dy) : 0;
  const double cross =
      4 / pairs.heights.points() * cross_sum(R, x, y, pairs.heights) / std::pow(grid.dx * grid.dy, 2);
  out.square_slope = std::sqrt(squared(out.m20, m20) + squared(out.m02, m02) + cross) / (m20 + m02);
  return out;
}

DifferencePairs::DifferencePairs(const Pairs& of_heights, const Field& z, int threads)
    : DifferencePairs(of_heights.grid()) {
  if (of_heights.complete()) return;
  const Grid& grid = of_heights.grid();
  const bool closed = grid.periodic;
  const Field along_x = differences_along_x(z, closed), along_y = differences_along_y(z, closed);
  heights = of_heights;
  dx = Pairs::of(along_x, grid, threads);
  dy = Pairs::of(along_y, grid, threads);
  dxx = Pairs::of(differences_along_x(along_x, closed), grid, threads);
  dyy = Pairs::of(differences_along_y(along_y, closed), grid, threads);
}

}  // namespace asperity
