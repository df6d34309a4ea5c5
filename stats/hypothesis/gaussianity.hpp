/// Four tests for Gaussian heights that allow for the correlation of the heights.
///
/// Against the Gaussian with the field's own mean and rms height, x = (z - z̄)/Sq sorted to x_1 ≤ … ≤ x_N:
///     Jarque–Bera         JB = Ssk²/(6 S_3/N) + (Sku - 3 + 6 S_2/N)²/(24 S_4/N)                     (1)
///     Kolmogorov–Smirnov  √N sup |F_N - Φ|                                                          (2)
///     Anderson–Darling    A² = -N - 1/N Σ (2i-1) [ln Φ(x_i) + ln(1 - Φ(x_{N+1-i}))]                 (3)
///     Pearson's χ²        Σ (c - N/B)²/(N/B) over B bins of equal probability                       (4)
/// Published tables hold for independent heights and reject a Gaussian field whose neighbours are nearly
/// equal. The null distributions used instead are those of a Gaussian field with the sums S_k
/// (stats/uncertainty/effective_size.hpp):
///     JB   χ² of 2 degrees; -6 S_2/N is the bias of Sku in a finite field
///     KS   the supremum of the process D (stats/hypothesis/null_distribution.hpp)
///     A²   ∫ D²/(Φ(1-Φ)) dΦ, a weighted sum of χ² (stats/hypothesis/weighted_chi_squared.hpp), the weights
///          the eigenvalues of D's covariance by the trapezoidal rule over |x| ≤ 6
///     χ²   the sum of squared differences of D over bins, also a weighted sum of χ²; B - 1 or B - 3 degrees
///          of freedom would be wrong, because the heights are fitted and not the counts (Chernoff, Lehmann)
/// `naive_p` is the p-value with S_k = 1, for independent heights; for JB the statistic changes too.
/// Bins: B = 2 (N/S_3)^{2/5} (Mann and Wald), 6 ≤ B ≤ 64.
///
/// Symbols   F_N  empirical distribution     Φ  the Gaussian's      c  count of a bin      N  points
/// Accuracy  The distributions are limits for many independent patches, N/S_2 ≫ 1. The rate of false alarms
///           of 300 fields is within sampling error of the nominal 5 % from N/S_2 = 800 on
///           (tests/stats/gaussianity.cpp). Errors of p itself: 3e-4 for A², a relative 1e-9 for χ²,
///           √(p(1-p)/8192) for KS, with a least p of 1/8193; the error of estimated S_k adds to them.
/// Cost      set-up some 0.2 s, mostly KS' simulation; per field a sort and 2 N logarithms.
///
/// C. M. Jarque, A. K. Bera, Int. Stat. Rev. 55 (1987) 163-172; T. W. Anderson, D. A. Darling, Ann. Math.
/// Stat. 23 (1952) 193-212; H. W. Lilliefors, J. Am. Stat. Assoc. 62 (1967) 399-402; H. Chernoff, E. L.
/// Lehmann, Ann. Math. Stat. 25 (1954) 579-586; H. B. Mann, A. Wald, Ann. Math. Stat. 13 (1942) 306-317.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "stats/height/distribution.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/hypothesis/null_distribution.hpp"

namespace asperity {

/// The weights of the distributions of A², and of χ² over B bins.
Eigen::ArrayXd anderson_darling_weights(const EffectiveSampleSize& size);
Eigen::ArrayXd pearson_weights(const EffectiveSampleSize& size, int bins);

struct GoodnessOfFit {
  std::string_view test;
  double statistic = 0;                               ///< (1)–(4)
  double p = 0;                                       ///< for a Gaussian field of this correlation
  double naive_p = 0;                                 ///< for independent heights
  bool p_is_bound = false, naive_p_is_bound = false;  ///< the least that the simulation tells; p is below
  std::string why = {};                               ///< why there is no p
};
/// The names of the tests in their order.
std::array<GoodnessOfFit, 4> goodness_of_fit_tests();

class GaussianityTest {
 public:
  explicit GaussianityTest(const EffectiveSampleSize& size);

  int bins() const { return bins_; }
  static int bins_for(const EffectiveSampleSize& size);
  /// So many independent heights.
  static EffectiveSampleSize independent(const EffectiveSampleSize& size);
  /// The tests in the order (1)–(4); `moments` are those of z. Missing points are left out.
  std::array<GoodnessOfFit, 4> operator()(const Field& z, const Moments& moments) const;

 private:
  /// The distributions for one correlation.
  struct NullDistributions {
    NullDistributions(const EffectiveSampleSize& of, int bins);

    double jarque_bera(const Moments& moments) const;
    double jarque_bera_p(double statistic) const;

    EffectiveSampleSize size;
    Eigen::ArrayXd anderson_darling, pearson;  ///< weights
    NullDistribution supremum;
  };

  int bins_;
  NullDistributions correlated_, independent_;
};

// ---- heights in steps ----

/// The tests of stats/hypothesis/gaussianity.hpp for heights that stand on steps of an instrument.
///
/// Heights rounded to steps s (stats/height/distribution.hpp) tell F_N between the steps only, where it is
/// that of the heights themselves. At those edges x, in units of Sq from the mean,
///     Kolmogorov–Smirnov  √N max |F_N - Φ|                                                            (1)
///     Anderson–Darling    N Σ w (F_N - Φ)²/(Φ(1-Φ)),   w half of what Φ grows by around x              (2)
///     Pearson's χ²        Σ (c - N p)²/(N p) over classes of whole steps                               (3)
/// and Jarque–Bera by moments without what rounding adds to them (Sheppard). The null distributions are those
/// of the process D at the same edges. With ε = s²/(12 Sq²), rounding adds to D's covariance, by the fitted
/// mean and Sq, φφᵀ ε + (xφ)(xφ)ᵀ (ε + ε²/5), and to Jarque–Bera's S_3 and S_4 (1+ε)³ - 1 and (1+ε)⁴ - 1.
///
/// Symbols   s  step     Φ, φ  the Gaussian's distribution and density     N  points
/// Scope     Steps up to 1.25 Sq; the errors of rounding are independent, of variance s²/12.
/// Accuracy  Of fields of 100 × 100 points, white and exponential of 3 samples, by an estimated correlation,
///           1 to 6 % of 150 each at steps of Sq/3 and Sq, and 3 to 12 % of 60 each at Sq/20 and Sq/5 have a
///           p-value below 5 % by any one of the tests.
/// Cost      as of heights without steps.
///
/// W. F. Sheppard, Proc. Lond. Math. Soc. 29 (1898) 353-380; V. Choulakian, R. A. Lockhart, M. A. Stephens,
/// Can. J. Stat. 22 (1994) 125-137.

/// Moments of the heights before they were rounded. Sq is NaN where steps are coarser than the Scope.
Moments before_rounding(const Moments& rounded, double step);
/// ρ of the heights before, of an estimate that has lost R(0,0) to their rounding.
LagField before_rounding(const LagField& rho, const Moments& rounded, double step);

/// `heights` are runs of equal ones, `moments` theirs; `size` is of the heights before. Steps beyond the
/// Scope have no p-values, and say why.
std::array<GoodnessOfFit, 4> gaussianity_of_steps(const std::vector<HeightRun>& heights,
                                                  const Moments& moments, const HeightSteps& steps,
                                                  const EffectiveSampleSize& size);

}  // namespace asperity
