/// Sums over pairs of points a lag apart, at every lag up to (P, Q), by the fast Fourier transform.
///
///     C(p,q) = Σ f(i,j) f(i+p, j+q)                                                                (1)
/// over all pairs of points (Wiener and Khinchin: the inverse transform of |f^|²), p = 0 … P, q = -Q … Q; on
/// a periodic grid every point has a partner at every lag.
///
/// Accuracy  round-off ε log2(N) Σ f².
/// Cost      one pruned transform there and back, padded only as far as the lags requested.
/// Memory    a half spectrum, for lags up to half the field one and a half times as large as it, and C.
///
/// N. Wiener, Generalized harmonic analysis, Acta Math. 55 (1930) 117-258.
#pragma once

#include "core/field.hpp"
#include "transform/pruned.hpp"

namespace asperity {

/// C in row p, column Q + q.
Field lag_sums(const Field& f, const Grid& grid, Shape max_lag, int threads = 1);
/// The same of f row by row.
Field lag_sums_of_rows(const RowSource& f, const Grid& grid, Shape max_lag, int threads = 1);

}  // namespace asperity
