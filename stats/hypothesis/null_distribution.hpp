/// Simulated distributions of test statistics for correlated heights: statistics of g = A n, with A Aᵀ the
/// covariance and n independent Gaussians, in 8192 draws with a fixed seed.
///
/// Such a g is the deviation of the empirical distribution of a Gaussian field from the Gaussian fitted to
/// it. Let F_N(x) be the share of the N heights with (z - z̄)/Sq ≤ x. By the Hermite series of the indicator,
/// whose terms k = 1 and 2 drop out for the fitted mean and rms height,
///     D(x) = √N (F_N(x) - Φ(x)) = -Σ_{k≥3} √S_k h_{k-1}(x)/√k g_k + O(N^{-1/2}),                     (1)
/// h_k the Hermite functions (math/hermite.hpp), S_k the sums over the correlation
/// (stats/uncertainty/effective_size.hpp), g_k the sample means of He_k(z)/√k! divided by √(S_k/N):
/// uncorrelated, of variance 1 (Mehler), and independent Gaussians in the limit of many independent patches
/// (Breuer and Major). D is then a Gaussian process with the covariance
///     C(x,y) = S_∞ [Φ(x)(1 - Φ(y)) - φ(x)φ(y)(1 + xy/2)] + Σ_{k≥3} (S_k - S_∞) h_{k-1}(x) h_{k-1}(y)/k,  (2)
/// x ≤ y. S_k falls to S_∞, which is 1 unless distant heights are equal, so that the sum is short and smooth.
/// The bracket is the covariance for independent heights and holds all the roughness of D: over short
/// distances D is a Brownian motion of variance S_∞ dΦ, whose maximum between two points is known exactly.
///
/// Accuracy  (2) is exact for the k ≤ 512 that are summed, with S_512 for S_∞. A probability p has the
///           standard error √(p(1-p)/8192).
/// Cost      512 n² for (2) at n points; an eigenvalue problem and 8192 products of n², 24 n ns per draw for
///           sup |D|.
///
/// J. Durbin, Distribution theory for tests based on the sample distribution function, SIAM (1973), for
/// independent heights; P. Breuer, P. Major, J. Multivar. Anal. 13 (1983) 425-441.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "stats/uncertainty/effective_size.hpp"

namespace asperity {

class NullDistribution {
 public:
  static constexpr int draws = 8192;
  static constexpr double least = 1.0 / (draws + 1);  ///< the p-value of what exceeds all draws: p is below
  /// A function of g and of further independent Gaussians.
  using Statistic = std::function<double(const Eigen::VectorXd&, std::span<const double>)>;

  NullDistribution() = default;
  NullDistribution(const Eigen::MatrixXd& covariance, const Statistic& statistic, std::size_t beside = 0);

  /// P(statistic ≥ value), from 1/(draws + 1) to 1.
  double exceedance(double value) const;
  /// The value that is exceeded with the probability `tail`.
  double quantile(double tail) const;

 private:
  std::vector<double> drawn_;  ///< ascending
};

/// C(x_a, x_b) of (2).
Eigen::MatrixXd fitted_process_covariance(const Eigen::ArrayXd& x, const EffectiveSampleSize& size);

/// The distribution of sup |D|. `x` ascends over the whole Gaussian, `covariance` is (2) there, `roughness`
/// S_∞.
NullDistribution supremum_distribution(const Eigen::ArrayXd& x, const Eigen::MatrixXd& covariance,
                                       double roughness);

}  // namespace asperity
