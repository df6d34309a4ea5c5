#include "stats/uncertainty/sequence_error.hpp"

#include <algorithm>
#include <cmath>

#include "stats/uncertainty/long_waves.hpp"

namespace asperity {
namespace {

// K, even where cosines and sines belong together.
Index waves_of(double independent, bool periodic) {
  const auto k = static_cast<Index>(std::clamp(0.3 * independent, 2.0, 16.0));
  return periodic ? k + k % 2 : k;
}

// (2) of the mean of f, which is zero at missing places; `fitted` times 1/√ν is lost besides.
double error_of(const Eigen::ArrayXd& f, double count, const Eigen::MatrixXd& waves, double fitted) {
  const auto k = static_cast<double>(waves.cols());
  const double variance = (waves.transpose() * f.matrix() / count).squaredNorm() / k;
  if (!(variance > 0)) return variance;
  const double independent = std::max(1.0, f.square().sum() / count / variance),
               loss = k / (6 * independent) + fitted / std::sqrt(independent);
  return std::sqrt(variance) / (1 - std::min(0.4, loss));
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
  out.degrees = waves_of(out.independent, periodic);
  const Eigen::MatrixXd waves = axis_waves(values.size(), periodic, out.degrees).rightCols(out.degrees);
  out.mean_error = error_of(deviation, out.count, waves, 0);
  if (!(out.spread > 0)) return out;
  const double deciding = independent * std::pow(square.sum(), 2) / square.square().sum();
  out.spread_degrees = std::max(1.0, static_cast<double>(out.degrees) * deciding / (deciding + 3));
  const Eigen::ArrayXd of_spread = missing.select(0, (square - out.spread * out.spread) / (2 * out.spread));
  out.spread_error = error_of(of_spread, out.count, waves, 0.6);
  return out;
}

}  // namespace asperity
