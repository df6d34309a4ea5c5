/// Gaussian regression of order 2: about each point the quadratic that fits best.
///
///     min Σ_k s(x_k - x) δ_k (z_k - P(x_k - x))²  over P of total degree 2,   w(x) = P(0),            (1)
/// s the weight of stats/filter/gaussian_filter.hpp, δ a weight of each point, 0 where it is missing. With
/// u = (x_k - x)/λ_c the six coefficients of P solve
///     Σ_cd M_{a+c,b+d} p_cd = N_ab,   M_ab = Σ s δ u^a v^b,   N_ab = Σ s δ z u^a v^b.                 (2)
/// A quadratic surface stays as it is, ends included. With δ = 1 and far from an end a wave passes by
/// H(λ) (1 + ln(2) (λ_c/λ)²), H of the filter of order 0: by 0.85 at the cut-off.
///
/// Accuracy  the sums are cut where s is below 1e-16. Where a pivot of (2) is below 1e-8 of the largest, by
///           too few points under the weight, w keeps its former value.
/// Cost      29 sums over 3.3 λ_c/Δ points a point, and an equation of six unknowns.
///
/// ISO 16610-31:2016; ISO 16610-71:2014.
#pragma once

#include "core/field.hpp"

namespace asperity {

/// w of (1); `former` where (2) is singular. Neither z, δ nor former has missing points.
Field local_quadratic(const Field& z, const Field& delta, const Field& former, const Grid& grid,
                      double cutoff, int threads);

}  // namespace asperity
