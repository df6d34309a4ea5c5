/// The distribution of a statistic of correlated Gaussians, simulated: of a test, its distribution under the null
/// hypothesis.
///
/// Of g = A n, A Aᵀ the covariance and n independent, in so many draws with a fixed seed.
///
/// Accuracy  of a probability p √(p(1-p)/8192), 0.0024 for p = 0.05.
/// Cost      an eigenvalue problem, and one product a draw.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace asperity {

class NullDistribution {
 public:
  static constexpr int draws = 8192;
  /// Of g, and of independent Gaussians beside them.
  using Statistic = std::function<double(const Eigen::VectorXd&, std::span<const double>)>;

  NullDistribution() = default;
  NullDistribution(const Eigen::MatrixXd& covariance, std::size_t beside, const Statistic& statistic);
  /// Of max g.
  static NullDistribution of_largest(const Eigen::MatrixXd& correlation);
  /// Of max |g|.
  static NullDistribution of_largest_magnitude(const Eigen::MatrixXd& correlation);

  /// P(statistic ≥ value), from 1/(draws + 1) to 1.
  double exceedance(double value) const;
  /// What is exceeded with the probability of a tail.
  double quantile(double tail) const;

 private:
  std::vector<double> drawn_;  ///< ascending
};

}  // namespace asperity
