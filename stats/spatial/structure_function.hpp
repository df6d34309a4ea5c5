/// The structure function of a surface: the mean square difference of heights a lag apart.
///
///     S(p,q) = mean over all pairs of [z(i+p, j+q) - z(i,j)]²                                          (1)
/// for a stationary surface 2 (R(0,0) - R(p,q)); unlike R it needs no mean height and exists where the
/// variance grows with the field, as of a self-affine surface or one with a trend. It is summed from the
/// pairs as
///     S = [Σ_first z² + Σ_second z² - 2C(p,q)]/pairs,                                                  (2)
/// the squares over the rectangles that the first and the second points of the pairs fill, from a table of
/// partial sums, C(p,q) by the transform (stats/spatial/acf.hpp). Where heights are missing the pairs are those that are there,
/// and the squares of their points are correlations of the squares with the mask, by the transform too; at a lag
/// without a pair S is not a number.
///
/// Symbols   z  heights [m]      S  [m²]      p, q  lags [samples]
/// Accuracy  (2) is (1) to round-off of the transform, ε log2(N) Sq² and a few ε Sq² √N: where S is a small
///           part of Sq², at short lags of a smooth surface, by as much relative to it.
/// Cost      the ACF's, and two passes; with missing heights three times the ACF's.
///
/// J. S. Bendat, A. G. Piersol, Random data, 4th ed., Wiley (2010). R. S. Sayles, T. R. Thomas, Nature 271
/// (1978) 431-434.
#pragma once

#include "core/field.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

/// For all lags up to max_lag, as the ACF has them; throws ParameterError("max-lag", …).
LagField structure_function(const Field& z, const Grid& grid, Shape max_lag, int threads = 1);

}  // namespace asperity
