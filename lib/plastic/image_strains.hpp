/// What the periodic images of a plastic strain add to its stress, to be taken off.
///
/// A strain on a torus of the period P acts on itself from P, 2P, … away. That stress is smooth: a few waves
/// on a torus of 16 points tell it, and it falls with P as P⁻³, in a body periodic along the other axis as
/// P⁻². On the same coarse points, σ_P being the stress with the period P,
///     σ - σ_P = κ (σ_2P - σ_P),   κ = 1/(1 - 2⁻ⁿ),   n = 3 or 2,                                         (1)
/// but for a tenth of the next term, P⁻ⁿ⁻². Strains go to the coarse points by the transpose of the cubic
/// interpolation that brings stresses back, so that their moments up to the third are kept, and the whole
/// stays symmetric. Along an axis where the body is periodic, images are no error.
///
/// Accuracy  a tenth of what the images add: of strains that fill the cells, on a torus of twice as many,
///           2e-4 in place of 2e-3 of the largest stress; of strains in the middle third 3e-5.
/// Cost      700 waves: a twelfth of the stress of 64 × 64 cells, less of more.
#pragma once

#include "plastic/layer_waves.hpp"

namespace asperity {

/// Adds (1) to the stress of a strain in these cells on a torus of so many: five components, or six with the
/// mean.
void take_off_images(const Grid& cells, Shape torus, const LayerWaves& waves, double two_mu,
                     const LayeredField& strain, LayeredField& stress, int threads = 1);

}  // namespace asperity
