#include "stats/sample/ensemble.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "core/error.hpp"

namespace asperity {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Ensemble::add(const Eigen::ArrayXd& values) {
  if (quantities() == 0) count_ = mean_ = squares_ = Eigen::ArrayXd::Zero(values.size());
  if (values.size() != quantities())
    throw DataError("ensemble", std::to_string(values.size()) +
                                    " quantities where the first realisation has " +
                                    std::to_string(quantities()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values(i))) continue;
    const double deviation = values(i) - mean_(i);
    mean_(i) += deviation / ++count_(i);
    squares_(i) += deviation * (values(i) - mean_(i));
  }
}

Eigen::ArrayXd Ensemble::mean() const { return (count_ > 0).select(mean_, unknown); }

Eigen::ArrayXd Ensemble::spread() const {
  return (count_ > 1).select((squares_ / (count_ - 1)).sqrt(), unknown);
}

}  // namespace asperity
