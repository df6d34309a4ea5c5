#include "stats/uncertainty/size_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "stats/uncertainty/lag_waves.hpp"

namespace asperity {
namespace {

Eigen::Array3d sizes(const EffectiveSampleSize& size) {
  return {size.effective(2), size.effective(3), size.effective(4)};
}

// Where 95 % of `squares` lie, from the first on: the lags that noise makes significant, anywhere, hold 3 %.
Index reach_of(const Eigen::ArrayXd& squares) {
  const double most = 0.95 * squares.sum();
  double sum = squares(0);
  Index p = 0;
  while (sum < most && p + 1 < squares.size()) sum += squares(++p);
  return p;
}

// Twice as far as lags are significant, as of_estimate sums.
Shape lags_of_sums(const LagField& rho, const Pairs& pairs) {
  Eigen::ArrayXd along_x = Eigen::ArrayXd::Zero(rho.max_p() + 1),
                 along_y = Eigen::ArrayXd::Zero(rho.max_q() + 1);
  for (const auto& [p, q, value, weight] : significant(rho, pairs)) {
    const double square = weight * value * value;
    along_x(p) += square;
    along_y(std::abs(q)) += square;
  }
  return {std::min(rho.max_p(), 2 * reach_of(along_x) + 1), std::min(rho.max_q(), 2 * reach_of(along_y) + 1)};
}

}  // namespace

SizeErrors::SizeErrors(const Field& d, const LagField& estimate, const Pairs& pairs, const FormModes& form,
                       const FieldExtent& extent, const EffectiveSampleSize& size, int threads)
    : values_(sizes(size)) {
  const LagField rho = estimate.normalised();
  const AcfDeviations deviations =
      LagWaves(d, pairs.grid(), lags_of_sums(rho, pairs), extent, threads).of_ratio(rho);
  auto figures = [&](const LagField& of) { return sizes(EffectiveSampleSize::of_estimate(of, pairs, form)); };
  errors_ = values_ * deviations.relative_errors(rho, figures, threads);
  quantile_ = deviations.quantile(0.025);
}

Interval SizeErrors::interval(int k) const {
  const double value = values_(k - 2), half = quantile_ * errors_(k - 2);
  return Interval::of(value, std::max(std::min(1.0, value), value - half), value + half);
}

}  // namespace asperity
