/// Heights of any distribution from Gaussian ones, by translation:
///
///     z = σ g(y),    g = F⁻¹ ∘ Φ,    E[g(y)] = 0,    E[g(y)²] = 1,                                       (1)
///
/// of a Gaussian field y of unit variance has heights z/σ of the distribution F; g is increasing. What it
/// does to the autocorrelation is in marginal/correlation_map.hpp.
///
/// M. Grigoriu, Crossings of non-Gaussian translation processes, J. Eng. Mech. 110 (1984) 610-620.
#pragma once

#include <string>

#include <Eigen/Core>

#include "math/noise.hpp"

namespace asperity {

/// Of heights; the kurtosis is 3 of a Gaussian.
struct HeightMoments {
  double mean = 0, variance = 1, skewness = 0, kurtosis = 3;
};

struct Translation {
  std::string family;  ///< of the distribution: "normal", "S_L", "S_U", "S_B", "measured"
  double detail = 1;   ///< distance in y over which the slope of g may change by its own size, ≤ 1
  Pointwise apply;     ///< y → g(y)

  double operator()(double y) const {
    apply({&y, 1});
    return y;
  }
};

/// Means over the standard normal law: the trapezoidal rule with nodes y_i = i h, |y_i| ≤ 15, whose error is
/// exp(-2π²/h²) for entire functions and exp(-2πb/h) for one whose nearest pole is b away from the real axis.
struct NormalQuadrature {
  static constexpr double reach = 15;  ///< E[g⁴] of a lognormal g of kurtosis 1e4 ends at 14.5
  Eigen::ArrayXd nodes, weights;

  explicit NormalQuadrature(double step);
  /// The step that resolves g⁴.
  static double step_for(const Translation& g);
  /// g at the nodes.
  Eigen::ArrayXd heights(const Translation& g) const;
};

/// Of g(y), by quadrature.
HeightMoments height_moments(const Translation& g);

}  // namespace asperity
