/// Points of spectra as parameters, and the spectra that a texture has, without a window, leakage or chance,
///
///     C1(k) = Δx Σ_p R(p,0) cos(2πkp/nx),     C(k,l) = ΔxΔy Σ_pq R(p,q) cos(2π(kp/nx + lq/ny))
///
/// over all lags R that the texture has.
#pragma once

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"
#include "textures.hpp"

namespace asperity {

/// psd_x_K, psd_y_K of profiles and psd_ring_K at K = 2, 3, 5, 12, 40, where the field has them.
Parameters spectrum_points(const Sample& sample);
/// The same of the texture, at the wave numbers of a field of a shape and a spacing; Sq is the spacing before
/// the translation.
Parameters true_spectrum_points(const textures::Texture& texture, Shape shape, double spacing, Index reach);

}  // namespace asperity
