/// The standard error of a mean from the long waves of what it is the mean of, by an average over the spectra
/// that it may have.
///
/// The mean f̄ of a local function f of a field is its wave of number zero. Of the next K waves, of numbers
/// ν_k and mean zero, the field tells the amplitudes c_k. If the spectrum falls from wave number zero on as
/// s(ν), s(0) = 1, the variance of the mean is known from each of them:
///     Var[f̄] ≈ m = 1/K Σ_k c_k²/s(ν_k).                                                                (1)
/// How it falls is not known, only that it is one of 62 shapes. Of them 54 fall with the length of the wave,
///     s_i(ν) = a + (1 - a) g(bν),   g(x) = e^(-x) or (1 + 2x)^(-3/2),   a = 0, 0.1, 0.4,
///     b = 0.001 … 0.3 in nine equal ratios,                                                            (2)
/// those of Gaussian and exponential correlations of many lengths, without and with noise of single points.
/// Seven are ridges, of lines that cross the field, such as grooves and scratches: their power lies at waves
/// across them. At d half waves beside a ridge at the angle φ a line across the field has the mean power
/// 2/(πd)², and waves (x, y) are cosines of both signs,
///     s_i = ½ Σ_± 1/(1 + ½π² d²),   d = x sin φ ± y cos φ,   φ = 0 … π/2 in six steps.                  (3)
/// One is s = 1. Of prior probability 1/16 each, 1/12 the ridges, and 1 for s = 1, they have by the
/// amplitudes the probability
///     p_i ∝ prior_i Π_k s_i(ν_k)^(-1/2) m_i^(-K/2),                                                    (4)
/// and the error and its degrees of freedom are
///     SE = exp(½ Σ p_i ln m_i),     v = Σ p_i ln² m_i - (Σ p_i ln m_i)²,
///     degrees = max(1.6, 2/(2/K + v) · N_g/(N_g + 20)),     N_g = 0.785/Σ p_i b_i.                      (5)
/// N_g counts the patches of f that are independent, as the waves tell: of few of them c_k² is skewed, and
/// low where f̄ is low.
///
/// Symbols   ν  as in stats/uncertainty/long_waves.hpp      x, y  half waves along the sides
///           a, b  noise, decay
/// Accuracy  for c_k = 1 SE = 1.10 at K = 21 with 5.7 degrees of freedom, of white noise 1.17 as an rms: flat
///           spectra may fall. Lines in many directions have a ridge each, which none of (3) is: of ten
///           scratches the error is 0.6 of the true one. Of the tools' figures, and on which textures:
///           docs/accuracy/asperity-stats.md
/// Cost      124 K operations and 124 logarithms.
///
/// U. K. Müller, HAC corrections for strongly autocorrelated time series, J. Bus. Econ. Stat. 32 (2014)
/// 311-322, for long waves in one dimension; J. A. Hoeting et al., Bayesian model averaging, Stat. Sci. 14
/// (1999) 382-417.
#pragma once

#include <Eigen/Core>

namespace asperity {

/// Of some waves, a row a wave.
struct LongWaveNumbers {
  Eigen::ArrayXd nu = {};
  Eigen::ArrayX2d half_waves = {};  ///< x, y; without them, and along one side, there are no ridges
};

struct WaveError {
  double error = 0;    ///< 0 where nothing varies, NaN without a wave
  double degrees = 1;  ///< of freedom, of Student's t

  double half_width() const;  ///< of a 95 % interval
};

class WaveSpectra {
 public:
  WaveSpectra() = default;
  explicit WaveSpectra(const LongWaveNumbers& numbers);

  Eigen::Index waves() const { return inverse_.cols(); }  ///< K
  /// (5) of c_k².
  WaveError error(const Eigen::ArrayXd& squares) const;
  /// Factors w_k of which SE² = Σ w_k c_k².
  Eigen::ArrayXd weights(const Eigen::ArrayXd& squares) const;

 private:
  struct Posterior {
    Eigen::ArrayXd logarithms, probabilities;  // ln m_i, p_i
  };
  Posterior posterior(const Eigen::ArrayXd& squares) const;

  Eigen::MatrixXd inverse_ = {};             // 1/s_i(ν_k), a row a shape
  Eigen::ArrayXd before_ = {}, decay_ = {};  // ln prior_i - ½ Σ_k ln s_i(ν_k); b
};

}  // namespace asperity
