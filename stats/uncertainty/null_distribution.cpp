#include "stats/uncertainty/null_distribution.hpp"

#include <algorithm>

#include "math/linear_algebra.hpp"
#include "math/noise.hpp"

namespace asperity {

NullDistribution::NullDistribution(const Eigen::MatrixXd& covariance, std::size_t beside,
                                   const Statistic& statistic) {
  const Eigen::MatrixXd root = covariance_root(covariance);
  std::vector<double> normals(static_cast<std::size_t>(root.cols()) + beside);
  WhiteNoise noise(1);
  drawn_.reserve(draws);
  for (int draw = 0; draw < draws; ++draw) {
    noise.row(draw, normals);
    const Eigen::VectorXd g = root * Eigen::Map<const Eigen::VectorXd>(normals.data(), root.cols());
    drawn_.push_back(statistic(g, std::span(normals).last(beside)));
  }
  std::ranges::sort(drawn_);
}

NullDistribution NullDistribution::of_largest(const Eigen::MatrixXd& correlation) {
  return {correlation, 0, [](const Eigen::VectorXd& g, auto) { return g.maxCoeff(); }};
}

NullDistribution NullDistribution::of_largest_magnitude(const Eigen::MatrixXd& correlation) {
  return {correlation, 0, [](const Eigen::VectorXd& g, auto) { return g.cwiseAbs().maxCoeff(); }};
}

double NullDistribution::exceedance(double value) const {
  const auto above = drawn_.end() - std::ranges::lower_bound(drawn_, value);
  return static_cast<double>(above + 1) / (draws + 1);
}

double NullDistribution::quantile(double tail) const {
  return drawn_[static_cast<std::size_t>((1 - tail) * (draws - 1))];
}

}  // namespace asperity
