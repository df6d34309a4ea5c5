#include "surface/running_moments.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace asperity {

void RunningMoments::add(const Eigen::Ref<const Field>& rows) {
  const auto m = static_cast<double>(rows.cols());
  Eigen::ArrayXd row;  // of one alignment, on which the order of a sum by vector instructions depends
  for (Index i = 0; i < rows.rows(); ++i) {
    row = rows.row(i);
    const double mean = row.mean(), step = mean - mean_;
    squares_ += (row - mean).square().sum() + step * step * count_ * m / (count_ + m);
    mean_ += step * m / (count_ + m);
    count_ += m;
    low_ = std::min(low_, row.minCoeff());
    high_ = std::max(high_, row.maxCoeff());
  }
}

void RunningMoments::rescale(const Rescaling& map) {
  mean_ = map(mean_);
  squares_ *= map.factor * map.factor;
  low_ = map(low_);
  high_ = map(high_);
}

double RunningMoments::rms() const { return std::sqrt(squares_ / count_); }

Rescaling exact_rms(const RunningMoments& moments, double rms) {
  if (!(moments.high() > moments.low()))
    throw ParameterError("exact-rq", "all heights are equal and cannot be scaled");
  if (!(moments.rms() * moments.rms() >= std::numeric_limits<double>::min() && std::isfinite(moments.rms())))
    throw ParameterError("exact-rq", "the squares of the heights leave the range of a double");
  return {moments.mean(), rms / moments.rms()};
}

}  // namespace asperity
