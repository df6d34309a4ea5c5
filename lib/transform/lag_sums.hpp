/// Sums over pairs of points a lag apart, at every lag up to (P, Q), by the fast Fourier transform.
///
///     C(p,q) = Σ f(i,j) f(i+p, j+q)                                                                (1)
/// over all pairs of points (Wiener and Khinchin: the inverse transform of |f^|²), p = 0 … P, q = -Q … Q; on
/// a periodic grid every point has a partner at every lag.
///
/// Accuracy  round-off ε log2(N) Σ f².
/// Cost      one pruned transform there and back, padded only as far as the lags requested.
///
/// N. Wiener, Generalized harmonic analysis, Acta Math. 55 (1930) 117-258.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// C in row p, column Q + q.
Field lag_sums(const Field& f, const Grid& grid, Shape max_lag, int threads = 1);

}  // namespace asperity
