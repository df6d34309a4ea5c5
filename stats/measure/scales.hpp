/// Rms heights, slopes and second derivatives of a surface by scale, along x and along y.
///
/// With z(i) the heights along an axis of n points a distance Δ apart, and means over all lines,
///     band_…(λ)              √(1/L Σ q^{2d} C1(q)),  π/λ < q ≤ 2π/λ, of either sign                     (1)
///     patch_height(l)        √mean (z - line through the patch)²,  patches of l/Δ points side by side   (2)
///     distance_slope(l)      √mean [(z(i+s) - z(i))/l]²,  l = sΔ                                        (3)
///     distance_curvature(l)  √mean [(z(i+s) - 2z(i) + z(i-s))/(sΔ)²]²,  l = 2sΔ                         (4)
/// at octaves: λ, l = 2Δ, 4Δ, …, of (3) from Δ on and of (2) from 4Δ, up to half the side. (1), for d = 0, 1,
/// 2 the height, slope and curvature of the waves from λ to 2λ, takes C1 of stats/spectrum/spectrum.hpp (3);
/// the heights of all bands add up to Sq, in squares. (2) is the variable-bandwidth method, which no tilt
/// changes; (3) and (4) are the scale-dependent roughness parameters of [1], l the length of the stencil:
///     (3)² = 2 (R(0) - R(l))/l²,     (4)² = [6 R(0) - 8 R(l/2) + 2 R(l)]/(l/2)⁴
/// of the autocorrelation R. At l = Δ and 2Δ they are √m2 and √m4 of stats/hybrid/spectral_moments.hpp.
///
/// Errors. (2) to (4) are means over the field of local functions: stats/uncertainty/long_waves.hpp, of the
/// part of the field that has them. (1) is a mean over wave numbers: stats/measure/spectra.hpp, its bias by
/// window and holes the mean of those of its wave numbers, weighted by what each adds to the band. A value
/// has no error, with one word for the reason, where
///     form        a removed form of degree d takes half waves of l: d > 0, l > n Δ/(2 + 2⌈d/2⌉); of bands
///                 as of profiles (stats/spectrum/resolution.hpp);
///     leakage     a tenth of the band or more comes from other waves; resolution, holes: as of profiles, and
///                 a distance or a patch of which holes leave none has no value;
///     steps       heights in steps s, noise of s²/12, are a hundredth of the square or more;
///     size        the field holds too few independent heights, or fewer than eight stencils side by side;
///     flat        it is zero, or the same all over the field, to round-off.
///
/// A tip of radius R cannot follow summits that curve more. Data are taken for unreliable at scales l where
///     min [z(i+s) - 2z(i) + z(i-s)]/(sΔ)² < -1/(2R),   l = 2sΔ,                                         (5)
/// ½ the factor that [1] finds on simulated scans; so are patches, wavelengths and distances below the first
/// l where (5) fails.
///
/// Symbols   L  side [m]      q  wave number [rad/m]
/// Scope     any field on a grid, with missing points; of white noise of variance v, (2)² = v (1 - 2Δ/l),
///           (3)² = 2v/l², (4)² = 96v/l⁴.
/// Accuracy  (1) to (4) to round-off. Of 120 fields each of eleven kinds (exponential, Gaussian, self-affine,
///           skewed; with a form of degree 0 to 5; periodic; 128 × 128 and 48 × 48 points, profiles of 256
///           and 512), 95 % intervals of (2) to (4) cover 93 to 100 %, and errors are 0.79 to 1.39 of the
///           true ones; of (1) 88 to 100 %, and 0.75 to 1.15.
///           (5) is a rule of thumb: scans of self-affine maps with H = 0.5 and 0.8, rms slope 0.1 and 0.3,
///           R = 15Δ and 40Δ had 0.77 to 0.93 of the surface's curvature at l, 0.75 to 0.97 of its slope, and
///           0.15 to 0.62 of the curvature at 2Δ.
/// Cost      for each octave and axis some 60 operations a point; (1) two spectra.
///
/// [1] A. Sanner, W. G. Nöhring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka, Scale-dependent roughness
///     parameters for topography analysis, Appl. Surf. Sci. Adv. 7 (2022) 100190.
#pragma once

#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/spectra.hpp"

namespace asperity {

struct ScalePoint {
  const char* quantity;  ///< "band_height", as above
  int order;             ///< d, 0 of a height, 1 of a slope, 2 of a curvature
  Axis1D axis;
  double scale;               ///< λ or l [m]
  Estimate estimate = {NAN};  ///< in the unit of the heights over m^d
  NoError no_error = NoError::none;
};

/// (1) to (4). None of a side of fewer than four points.
std::vector<ScalePoint> by_scale(const Sample& sample, DataWindows windows);

/// The first l of (5) at which a tip follows the surface, along both axes [m]; 0: all. A side with none
/// counts with the next step after its longest, a quarter.
double first_reliable_scale(const Surface& surface, double tip_radius);

}  // namespace asperity
