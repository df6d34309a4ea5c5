/// Std of ISO 25178-2: the direction in which the angular spectrum of a surface is largest.
///
///     F(θ) = ∫ C(q cos θ, q sin θ) q dq,                                                               (1)
/// the power of all waves that run in the direction θ; ridges, the lay, stand at right angles to it. Here F
/// is the sum of C over all wave numbers, each spread over the angles around its own by a triangle whose half
/// width is 2°, or the angle Δq/q that its cell subtends where that is more. Wave numbers below four times
/// 2π/min(Lx,Ly) are left out: they hold what is left of the form, and know few directions; and those above
/// the smaller of π/Δx, π/Δy, which not all directions have.
///
/// Symbols   C  power spectral density (stats/spectrum/spectrum.hpp)
///           θ  angle from +x towards +y, in (-π/2, π/2] [rad]
/// Accuracy  0.5°, for a wave that fills a few wave numbers. Of an isotropic surface (Str near 1) the
///           direction is an accident, and the contrast not far from 1.
/// Cost      one pass over C.
#pragma once

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

struct TextureDirection {
  double angle = 0;     ///< Std [rad]
  double contrast = 0;  ///< F at its largest over its mean, 1 for no direction at all
};

TextureDirection texture_direction(const LagField& psd, const Grid& grid);

}  // namespace asperity
