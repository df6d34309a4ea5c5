/// Standard errors of mean square slopes and second derivatives, and of Sdq and Sdr.
///
/// Differences of a Gaussian field are Gaussian too. First and second differences along x have the
/// autocorrelations
///     R'(p,q) = 2R(p,q) - R(p+1,q) - R(p-1,q),   R'' = (R')',                                          (1)
/// and their mean squares have the relative standard errors √(2 S_2/N) with the sum S_2 of (1)
/// (stats/uncertainty/effective_size.hpp). Slopes a along x and b along y are correlated,
///     ΔxΔy E[a b] = D(p,q) = R(p,q) + R(p-1,q+1) - R(p-1,q) - R(p,q+1),                                (2)
///     Var[Sdq²] = 2/N Σ w [R'_x²/Δx⁴ + R'_y²/Δy⁴ + 2 D²/(Δx Δy)²],   SE[Sdq] = √Var/(2 Sdq),             (3)
/// and Sdr, which is Sdq²/2 for small slopes, has the relative standard error √Var/Sdq².
///
/// Symbols   R  autocorrelation [m²] or its normalised form      w  overlap at the lag
/// Scope     Gaussian heights. Of an estimated R only lags whose R' exceeds its noise are used.
/// Accuracy  to first order in 1/N.
/// Cost      a pass over the lags for each moment.
#pragma once

#include <cmath>

#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

/// Relative standard errors of m20, m02, m40, m04 and of Sdq² (that of Sdq is half of it); NaN for a moment
/// that is zero to round-off, such as the slope along grooves.
struct DerivativeErrors {
  double m20 = NAN, m02 = NAN, m40 = NAN, m04 = NAN, square_slope = NAN;
};

/// The pairs of heights and of differences; differences have fewer if heights are missing.
struct DifferencePairs {
  Pairs heights, dx, dy, dxx, dyy;

  DifferencePairs(const Pairs& of_heights, const Field& z, int threads = 1);
  /// As many of each as of heights: correct to first order without missing points.
  explicit DifferencePairs(const Pairs& p) : heights(p), dx(p), dy(p), dxx(p), dyy(p) {}
};

/// From a known correlation, zero beyond its lags, or from an estimate.
DerivativeErrors derivative_errors(const LagField& correlation, const DifferencePairs& pairs,
                                   bool estimated = false);

}  // namespace asperity
