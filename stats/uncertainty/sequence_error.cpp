#include "stats/uncertainty/sequence_error.hpp"

#include <algorithm>
#include <cmath>

#include "stats/uncertainty/long_waves.hpp"

namespace asperity {
namespace {

// Of the mean of f, which is zero at missing places.
WaveError error_of(const Eigen::ArrayXd& f, double count, bool periodic) {
  const Index waves = std::min<Index>(AxisWaves::most, f.size() - 1);
  const Eigen::MatrixXd u = axis_waves(f.size(), periodic, waves).rightCols(waves);
  const Eigen::ArrayXd nu = Eigen::ArrayXd::NullaryExpr(
      waves, [periodic](Index k) { return std::pow(static_cast<double>(half_waves(k + 1, periodic)), 2); });
  return WaveSpectra({nu}).error((u.transpose() * f.matrix() / count).array().square());
}

}  // namespace

SequenceMean sequence_mean(const Eigen::ArrayXd& values, double independent, bool periodic) {
  SequenceMean out;
  const auto missing = values.isNaN();
  out.count = static_cast<double>(values.size() - missing.count());
  if (out.count == 0) return out;
  out.mean = missing.select(0, values).sum() / out.count;
  const Eigen::ArrayXd deviation = missing.select(0, values - out.mean), square = deviation.square();
  out.spread = std::sqrt(square.sum() / out.count);
  out.independent = independent * out.count;
  if (!(out.independent >= SequenceMean::least_independent)) return out;
  out.of_mean = error_of(deviation, out.count, periodic);
  if (!(out.spread > 0)) return out;
  const double deciding = independent * std::pow(square.sum(), 2) / square.square().sum();
  out.of_spread =
      error_of(missing.select(0, (square - out.spread * out.spread) / (2 * out.spread)), out.count, periodic);
  out.of_spread.degrees = std::max(1.0, out.of_spread.degrees * deciding / (deciding + 3));
  return out;
}

}  // namespace asperity
