#include "stats/sample/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"
#include "stats/filter/missing.hpp"

namespace asperity {

void Ensemble::add(const Eigen::ArrayXd& values, double weight) {
  if (mean_.size() == 0) count_ = weights_ = mean_ = squares_ = Eigen::ArrayXd::Zero(values.size());
  if (values.size() != mean_.size())
    throw DataError("ensemble", std::to_string(values.size()) +
                                    " quantities, but the first realisation has " +
                                    std::to_string(mean_.size()));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values(i))) continue;
    const double deviation = values(i) - mean_(i);
    ++count_(i);
    weights_(i) += weight;
    mean_(i) += weight * deviation / weights_(i);
    squares_(i) += weight * deviation * (values(i) - mean_(i));
  }
}

Eigen::ArrayXd Ensemble::mean() const { return (count_ > 0).select(mean_, NAN); }

Eigen::ArrayXd Ensemble::spread() const {
  return (count_ > 1).select((squares_ / (count_ - 1) * (count_ / weights_)).sqrt(), NAN);
}

double AreaWeights::of(double area, bool enough) {
  if (maps_++ == 0) first_ = area;
  enough_ &= enough;
  const double weight = area / first_;
  sum_ += weight;
  least_ = maps_ == 1 ? weight : std::min(least_, weight);
  most_ = std::max(most_, weight);
  return weight;
}

double measured_area(const Field& heights, const Grid& grid) {
  return sum_of_valid(heights).count * grid.cell_area();
}

bool same_spacing(const Grid& one, const Grid& other) {
  constexpr double printed = 1e-6;
  return std::abs(one.dx / other.dx - 1) <= printed && std::abs(one.dy / other.dy - 1) <= printed;
}

}  // namespace asperity
