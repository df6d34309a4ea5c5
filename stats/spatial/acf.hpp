/// The autocorrelation and the structure function of a measured surface, at every lag up to (P, Q), by the
/// FFT.
///
/// With heights d = z - level,
///     C(p,q) = Σ d(i,j) d(i+p, j+q)                                                                (1)
/// over all pairs of points (transform/lag_sums.hpp). The estimate is
///     R(p,q) = C(p,q) / ((nx - |p|)(ny - |q|)),      unbiased, the default,                        (2)
///     R(p,q) = C(p,q) / (nx ny),                     biased: positive definite, smaller far out,   (3)
/// and on a periodic grid C(p,q)/(nx ny), which is both. If heights are missing, (1) is summed over pairs of
/// two measured points, the level is the mean of the measured heights, and
///     R(p,q) = C(p,q) / n(p,q),   or C(p,q) / n(0,0),                                              (4)
/// n(p,q) the number of these pairs (stats/spatial/pairs.hpp). At a lag without a pair the unbiased R is NaN.
///
/// The structure function is the mean square difference of heights a lag apart,
///     S(p,q) = mean over all pairs of [z(i+p, j+q) - z(i,j)]²,                                     (5)
/// for a stationary surface 2 (R(0,0) - R(p,q)). It needs no mean height and exists even if the variance
/// grows with the field, as for a self-affine surface or one with a trend. It is
///     S = [Σ_first z² + Σ_second z² - 2C(p,q)]/pairs,                                              (6)
/// with the squares over the rectangles of the first and the second points of the pairs, from a table of
/// partial sums, or, if heights are missing, from correlations of the squares with the mask.
///
/// Symbols   z  heights [m]      R, S  [m²], R(0,0) = Sq²      p, q  lags [samples]
/// Accuracy  Round-off ε log2(N) Σd²/N, for S a few ε Sq² √N more. As an estimate, (2) is unbiased if the
///           level is known; subtracting the field's own mean lowers every lag by about σ² Σρ / N
///           (stats/uncertainty/effective_size.hpp).
/// Cost      one pruned transform and its inverse, padded only up to the longest lag; with missing heights
///           another one, at all lags. S needs two more passes; with missing heights three times the ACF's
///           cost.
/// Memory    of R at lags up to half the field, with the field, three of it; with missing heights five.
///
/// G. M. Jenkins, D. G. Watts, Spectral analysis and its applications, Holden-Day (1968), ch. 5. J. S.
/// Bendat, A. G. Piersol, Random data, 4th ed., Wiley (2010). R. S. Sayles, T. R. Thomas, Nature 271 (1978)
/// 431.
#pragma once

#include <optional>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

struct AcfParameters {
  Shape max_lag = {};   ///< P, Q [samples]; at most the field less one point, half of it when periodic
  bool biased = false;  ///< (3) instead of (2)
  std::optional<double> level = {};  ///< known mean height [m]; otherwise the field's mean
  int threads = 1;

  /// Throws ParameterError("max-lag", …).
  void check(const Grid& grid) const;
};

/// Half the field in either direction; longer lags have few independent pairs.
inline Shape default_max_lag(const Grid& grid) { return {grid.shape.nx / 2, grid.shape.ny / 2}; }

LagField estimate_autocorrelation(const Field& z, const Grid& grid, const AcfParameters& parameters);
/// With the field's pairs, if they are known.
LagField estimate_autocorrelation(const Field& z, const Pairs& pairs, const AcfParameters& parameters);

/// S at all lags up to max_lag; throws ParameterError("max-lag", …) as the ACF does.
LagField structure_function(const Field& z, const Grid& grid, Shape max_lag, int threads = 1);

}  // namespace asperity
