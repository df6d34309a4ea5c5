/// Simulated distributions of tests on correlated heights: of a statistic of g = A n, A Aᵀ the covariance and
/// n independent Gaussians, in 8192 draws with a fixed seed.
///
/// Such a g is how far the empirical distribution of a Gaussian field strays from the Gaussian fitted to it.
/// Let F_N(x) be the part of the N heights with (z - z̄)/Sq ≤ x. By the Hermite series of the indicator, the
/// terms k = 1 and 2 taken up by the fitted mean and rms height,
///     D(x) = √N (F_N(x) - Φ(x)) = -Σ_{k≥3} √S_k h_{k-1}(x)/√k g_k + O(N^{-1/2}),                     (1)
/// h_k the Hermite functions (math/hermite.hpp), S_k the sums over the correlation
/// (stats/uncertainty/effective_size.hpp), g_k the sample means of He_k(z)/√k!, over √(S_k/N): uncorrelated,
/// of variance 1 (Mehler), and in the limit of many independent patches independent Gaussians (Breuer and
/// Major). D is then a Gaussian process of covariance
///     C(x,y) = S_∞ [Φ(x)(1 - Φ(y)) - φ(x)φ(y)(1 + xy/2)] + Σ_{k≥3} (S_k - S_∞) h_{k-1}(x) h_{k-1}(y)/k,  (2)
/// x ≤ y. S_k falls to S_∞, 1 unless distant heights are the same, so that the sum is short and smooth; the
/// bracket is that of independent heights, and all of the limit's roughness: over short distances D is a
/// Brownian motion of variance S_∞ dΦ, which gives the largest |D| between two points as exactly as at them.
///
/// Accuracy  (2) is exact for the k ≤ 512 that are summed, with S_512 for S_∞. Of a probability p
///           √(p(1-p)/8192).
/// Cost      512 n² for (2) at n points; an eigenvalue problem and 8192 products of n², 24 n ns a draw for
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
  /// Of g, and of independent Gaussians beside it.
  using Statistic = std::function<double(const Eigen::VectorXd&, std::span<const double>)>;

  NullDistribution() = default;
  NullDistribution(const Eigen::MatrixXd& covariance, const Statistic& statistic, std::size_t beside = 0);

  /// P(statistic ≥ value), from 1/(draws + 1) to 1.
  double exceedance(double value) const;
  /// What is exceeded with the probability of a tail.
  double quantile(double tail) const;

 private:
  std::vector<double> drawn_;  ///< ascending
};

/// C(x_a, x_b) of (2).
Eigen::MatrixXd fitted_process_covariance(const Eigen::ArrayXd& x, const EffectiveSampleSize& size);

/// Of sup |D|. `x` ascends over all of the Gaussian, `covariance` is (2) there, `roughness` is S_∞.
NullDistribution supremum_distribution(const Eigen::ArrayXd& x, const Eigen::MatrixXd& covariance,
                                       double roughness);

}  // namespace asperity
