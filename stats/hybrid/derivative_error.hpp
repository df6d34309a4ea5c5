/// Standard errors of mean square slopes and second derivatives, and of Sdq and Sdr.
///
/// Differences of a Gaussian field are Gaussian too. First differences along x, and second ones, have the
/// autocorrelations
///     R'(p,q) = 2R(p,q) - R(p+1,q) - R(p-1,q),   R'' = (R')',                                          (1)
/// so that their mean squares have the relative standard errors √(2 S_2/N) with the sum S_2 of (1)
/// (stats/uncertainty/effective_size.hpp): slopes are less correlated than heights, and more of them count. Slopes a
/// along x and b along y covary,
///     ΔxΔy E[a b] = D(p,q) = R(p,q) + R(p-1,q+1) - R(p-1,q) - R(p,q+1),                                (2)
///     Var[Sdq²] = 2/N Σ w [R'_x²/Δx⁴ + R'_y²/Δy⁴ + 2 D²/(Δx Δy)²],   SE[Sdq] = √Var/(2 Sdq),             (3)
/// and Sdr, which is Sdq²/2 where slopes are small, has the relative standard error √Var/Sdq².
///
/// Symbols   R  autocorrelation [m²] or its normalised form      w  overlap at the lag
/// Scope     Gaussian heights. An estimated R is admitted lag by lag where R' stands out of its own noise.
/// Accuracy  to first order in 1/N.
/// Cost      a pass over the lags for each moment.
#pragma once

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

/// Relative standard errors of m20, m02, m40, m04 and of Sdq² (that of Sdq is half of it); NaN of what is zero to round-off,
/// as slopes along grooves are.
struct DerivativeErrors {
  double m20 = 0, m02 = 0, m40 = 0, m04 = 0, square_slope = 0;
};

/// The pairs of heights and of the differences that they allow: where heights are missing, more differences are.
struct DifferencePairs {
  Pairs heights, dx, dy, dxx, dyy;

  /// Of a field without missing points, to first order as many of each.
  DifferencePairs(const Grid& grid) : heights(grid), dx(grid), dy(grid), dxx(grid), dyy(grid) {}
  DifferencePairs(const Pairs& of_heights, const Field& z, int threads = 1);
  /// Where the field is not at hand: as many of each as there are heights.
  explicit DifferencePairs(const Pairs& p) : heights(p), dx(p), dy(p), dxx(p), dyy(p) {}
};

/// From a correlation that is zero beyond its lags, or from an estimate.
DerivativeErrors derivative_errors(const LagField& correlation, const DifferencePairs& pairs,
                                   bool estimated = false);

}  // namespace asperity
