#include "stats/sample/ensemble.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"

namespace asperity {

void Ensemble::add(const Eigen::ArrayXd& values) {
  if (mean_.size() == 0) count_ = mean_ = squares_ = Eigen::ArrayXd::Zero(values.size());
  if (values.size() != mean_.size())
    throw DataError("ensemble", std::to_string(values.size()) +
                                    " quantities, but the first realisation has " +
                                    std::to_string(mean_.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values(i))) continue;
    const double deviation = values(i) - mean_(i);
    mean_(i) += deviation / ++count_(i);
    squares_(i) += deviation * (values(i) - mean_(i));
  }
}

Eigen::ArrayXd Ensemble::mean() const { return (count_ > 0).select(mean_, NAN); }

Eigen::ArrayXd Ensemble::spread() const { return (count_ > 1).select((squares_ / (count_ - 1)).sqrt(), NAN); }

}  // namespace asperity
