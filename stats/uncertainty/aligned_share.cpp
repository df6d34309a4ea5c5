#include "stats/uncertainty/aligned_share.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "stats/filter/form.hpp"
#include "stats/filter/missing.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/form_modes.hpp"

namespace asperity {
namespace {

constexpr int scanner_degree = 2;    // of tilt and bow, which are of no surface
constexpr Index least_points = 10;   // of a line, to tell a correlation
constexpr double no_height = 1e-20;  // of squares: round-off
constexpr double most_kept = 0.875;  // of 1 in (2): M/n Σ v of lags up to half a line is 0.75

double mean_square(const Field& z) {
  const ValidSum sum = sum_of_valid(z.square());
  return sum.count > 0 ? sum.sum / sum.count : 0;
}

// Where the points determine it.
Field above_scanner(const Field& lines) try {
  return remove_form(lines, scanner_degree);
} catch (const ParameterError&) {
  return remove_form(lines);
}

// Takes the means off the lines; their mean square about their mean, a line as often as it has points.
double take_means(Field& lines) {
  Field means = Field::Constant(lines.rows(), lines.cols(), NAN);
  for (Index j = 0; j < lines.rows(); ++j)
    if (const ValidSum line = sum_of_valid(lines.row(j)); line.count > 0)
      means.row(j) =
          lines.row(j).isNaN().select(NAN, Field::Constant(1, lines.cols(), line.sum / line.count));
  lines -= means;
  return mean_square(remove_form(means));
}

// (2), of lines that are rows.
double lost_by_modes(const Field& lines, const Grid& grid, int degree, int threads) {
  const Pairs pairs = Pairs::of(lines, grid, threads);
  const LagField acf = estimate_autocorrelation(
      lines, pairs, {.max_lag = {0, grid.shape.ny / 2}, .level = 0, .threads = threads});
  if (!(acf(0, 0) > 0)) return 0;
  const FormModes modes(Grid{{grid.shape.ny, 1}, 1, 1, false}, degree);
  Index reach = 0;
  while (reach < acf.max_q() && acf(0, reach) > 0) ++reach;
  double lines_with_points = 0;
  for (Index j = 0; j < lines.rows(); ++j) lines_with_points += lines.row(j).isNaN().all() ? 0 : 1;
  const double m = modes.count() * lines_with_points / pairs.points();
  double of_lags = 0, kept = 0;
  for (Index q = 0; q <= reach; ++q) {
    const double of_mode = (q == 0 ? 1 : 2) * pairs.pair_fraction(0, q) * modes(q, 0);
    if (!(pairs.pair_fraction(0, q) > 0)) continue;
    of_lags += m * of_mode * acf(0, q) / acf(0, 0);
    kept += m * of_mode * modes(q, 0);
  }
  return std::max(0.0, of_lags / (1 - std::min(kept, most_kept)));
}

}  // namespace

TakenByAlignment taken_by_alignment(const AlignedRows& aligned, const Grid& grid, const RowAlignment& how,
                                    int threads) {
  const bool x = how.along == Axis1D::x;
  Field lines = lines_of(aligned.heights, how.along);
  const bool jumps = how.method == RowAlignment::Method::jumps;
  const double of_means = jumps ? 0 : take_means(lines);
  lines = above_scanner(lines);
  const double left = mean_square(lines);
  const Grid turned{shape_of(lines), x ? grid.dy : grid.dx, x ? grid.dx : grid.dy};
  const double went = std::pow(aligned.removed, 2);
  double estimate = std::pow(aligned.taken, 2);
  if (!jumps) estimate = of_means + left * lost_by_modes(lines, turned, how.degree, threads);
  if (!jumps && (lines.cols() < least_points || left <= no_height * went)) estimate = INFINITY;
  const double taken = std::min(estimate, went);
  return {std::sqrt(taken), taken<estimate, taken> 0 ? std::sqrt(taken / (left + taken)) : 0};
}

}  // namespace asperity
