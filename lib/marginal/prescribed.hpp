/// The translation of heights, or of noise, that a prescribed skewness and kurtosis need.
///
/// Translation   the heights are z = σ g(y) of a Gaussian field y (marginal/translation.hpp): any pair that
///               there is, and the autocorrelation of y is predistorted (marginal/predistortion.hpp).
/// Filter        the white noise is η = g(y) and the kernel a is that of a Gaussian surface. Sums of
///               independent values add their cumulants, so that z = Σ a η has
///                   Sk = Sk_η f₃,  f₃ = Σa³/(Σa²)^(3/2),        K - 3 = (K_η - 3) f₄,  f₄ = Σa⁴/(Σa²)²,  (1)
///               and the autocorrelation of the kernel. For wide kernels such noise often does not exist.
///
/// Where a skewness alone is given, the kurtosis follows it as in the gamma family,
///     K = 3 + 1.5 Sk²,                                                                                  (2)
/// that of sums of heights skewed to one side, and 3 of a Gaussian. Johnson's distribution of these moments
/// is S_B, of one peak, and ends 2.4 Sq from the mean on the short side at |Sk| = 1, 1.3 at 2; of a kurtosis
/// of 3 at |Sk| = 1 it would be J-shaped, cut at 1.1 Sq.
///
/// Every distribution has K ≥ Sk² + 1. If a kurtosis is too low for the heights or for the noise, the least
/// kurtosis possible at that skewness replaces it, if the request allows this.
///
/// Y. Z. Hu, K. Tonder, Simulation of 3-D random rough surface by 2-D digital filter and Fourier analysis,
/// Int. J. Mach. Tools Manuf. 32 (1992) 83-90; V. Bakolas, Wear 254 (2003) 546-554.
#pragma once

#include "acf/kernel.hpp"
#include "core/field.hpp"
#include "marginal/translation.hpp"

namespace asperity {

/// (2).
inline double gamma_kurtosis(double skewness) { return 3 + 1.5 * skewness * skewness; }

struct PrescribedHeights {
  double skewness = 0, kurtosis = 3;
  InfeasiblePolicy infeasible = InfeasiblePolicy::automatic;

  /// These, or with the least kurtosis of the skewness where that is higher and may take its place.
  PrescribedHeights feasible() const;
  /// The translation of the feasible heights. Throws ParameterError("kurtosis") or ("skewness").
  Translation translation() const;
  /// The translation of the white noise that this kernel averages; the same errors.
  Translation noise(const Field& kernel) const;
};

/// f₃ and f₄ of (1), and the moments of heights averaged from noise.
struct KernelCumulants {
  double third, fourth;

  static KernelCumulants of(const Field& kernel);
  HeightMoments heights(const HeightMoments& noise) const;
};

}  // namespace asperity
