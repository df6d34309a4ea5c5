/// Stress kernels of cells that repeat along one axis.
///
/// Below a load of period L along an axis, here x, a cell acts with all its images. Their sum falls off as
/// slowly as 1/m² and is cut off smoothly,
///     S(x) = Σ_m w(x + mL) K(x + mL),                                                         (1)
///     w = 1 up to L, then down to 0 at 10 L as the integral of exp(β√(1-u²)), |u| < 1, β = 9π.
/// w has no modes from the first of the period on but for e^-β, so that S lacks of the sum the mean along x
/// alone. That is known: a load that is uniform along x is one of strips, in plane strain (and antiplane
/// shear). A cell has of it the n-th part,
///     K_L(x) = S(x) + (P - Σ_i S(x + iΔx)) / n,                                               (2)
/// P the stress below an endless strip of the cell's width. (2) holds for a load constant in each cell.
///
/// Symbols   K  kernel of a cell, stress/influence.hpp     n  cells Δx of a period
/// Accuracy  1e-11 of the largest pressure.
/// Cost      the corners of ten periods in place of one; of several ranks each computes all.
#pragma once

#include <memory>

#include "stress/layer_influence.hpp"

namespace asperity {

/// How far w reaches [periods].
inline constexpr int image_periods = 10;
/// w at a distance in periods.
double image_weight(double periods);

/// (2) for a resolution whose cells repeat along one axis. by_lags gives the kernel itself, tapered across,
/// not its corner functions, and may not be requested with fewer lags than there are.
std::unique_ptr<LayerInfluence> make_image_influence(const Resolution& resolution, double poisson,
                                                     stress::Tractions acting, int threads);

}  // namespace asperity
