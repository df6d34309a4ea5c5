#include "stats/hybrid/derivative_error.hpp"

#include "core/error.hpp"
#include "stats/uncertainty/effective_size.hpp"

namespace asperity {
namespace {

template <class Value>
LagField lag_field(Index P, Index Q, Value value) {
  return LagField(
      Field::NullaryExpr(P + 1, 2 * Q + 1, [&](Index p, Index column) { return value(p, column - Q); }));
}

// The same with zeros beyond its lags.
LagField padded(const LagField& R, Index by) {
  return lag_field(R.max_p() + by, R.max_q() + by, [&](Index p, Index q) { return R(p, q); });
}

// (1), as far as R reaches.
LagField difference(const LagField& R, bool x) {
  const Index P = R.max_p() - (x ? 1 : 0), Q = R.max_q() - (x ? 0 : 1), dp = x ? 1 : 0, dq = 1 - dp;
  if (P < 0 || Q < 0) throw DataError("acf", "errors of derivatives need two lags in x and y");
  return lag_field(P, Q,
                   [&](Index p, Index q) { return 2 * R(p, q) - R(p + dp, q + dq) - R(p - dp, q - dq); });
}

constexpr double round_off = 1e-13;  // of R(0,0), that a second difference of R may hold

double relative_error(const LagField& counted, const Pairs& pairs) {
  return counted(0, 0) > 0 ? std::sqrt(2 / EffectiveSampleSize(counted, pairs).effective(2)) : NAN;
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

DerivativeErrors errors(const LagField& R, const DifferencePairs& pairs, bool estimated) {
  const LagField dx = difference(R, true), dy = difference(R, false);
  // The lags of a difference that count; none where the field does not change that way.
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

// Not numbers where one of the points is missing, as the last one is that has no neighbour.
Field differences(const Field& z, const Grid& grid, bool x) {
  const Index n = x ? z.rows() : z.cols();
  return Field::NullaryExpr(z.rows(), z.cols(), [&](Index i, Index j) -> double {
    const Index next = (x ? i : j) + 1;
    if (next == n && !grid.periodic.both()) return NAN;
    return (x ? z(next % n, j) : z(i, next % n)) - z(i, j);
  });
}

}  // namespace

DifferencePairs::DifferencePairs(const Pairs& of_heights, const Field& z, int threads)
    : DifferencePairs(of_heights) {
  if (of_heights.complete()) return;
  const Grid& grid = of_heights.grid();
  const Field along_x = differences(z, grid, true), along_y = differences(z, grid, false);
  dx = Pairs::of(along_x, grid, threads);
  dy = Pairs::of(along_y, grid, threads);
  dxx = Pairs::of(differences(along_x, grid, true), grid, threads);
  dyy = Pairs::of(differences(along_y, grid, false), grid, threads);
}

DerivativeErrors derivative_errors(const LagField& correlation, const DifferencePairs& pairs,
                                   bool estimated) {
  const LagField rho = correlation.normalised();
  return errors(estimated ? rho : padded(rho, 4), pairs, estimated);  // two for (1) twice, two that it takes
}

}  // namespace asperity
