/// Power spectral densities: of the surface, radial, angular, and of its profiles.
///
/// With heights d on nx × ny points, the wave numbers qx = 2πp/Lx, qy = 2πq/Ly, and a window w of mean square
/// W,
///     C(qx,qy) = (ΔxΔy)²/(Lx Ly W) |Σ w d exp(-i(qx x + qy y))|²                          [m⁴]         (1)
///     1/(Lx Ly) Σ C = Σ (w d)²/(nx ny W), without a window Sq², over all nx ny wave numbers            (2)
/// (Parseval; in the limit Sq² = 1/(2π)² ∫∫ C dqx dqy). The PSD of the profiles along x is their mean, and
/// along y likewise, with a window along the profile alone,
///     C1(qx) = Δx²/(Lx W) mean_j |Σ_i w d exp(-i qx x)|² = 1/Ly Σ_qy C(qx,qy)             [m³]         (3)
///     1/Lx Σ C1 = Sq² over all nx wave numbers, of both signs.
/// The radial PSD is the mean of C over rings of a width of 2π/min(Lx,Ly) up to the smaller of π/Δx, π/Δy.
///
/// A field that is not periodic leaks: its edges, joined, are a step of C ~ 1/q². Hann's window 1 -
/// cos(2πx/Lx), and the same in y, ends that at the price of 1.5 wave numbers of resolution.
///
/// Missing heights are given the mean, and W is the mean of w² over all points, of missing ones zero: (2) is
/// then Sq² of the points that are there. Holes leak as edges do. Of points missing here and there,
/// independently, a share g, the expectation of C is
///     (1-g) C + g Sq² ΔxΔy,                                                                           (4)
/// a floor of white noise, below which the surface's short waves cannot be seen.
///
/// The angular spectrum is
///     F(θ) = ∫ C(q cos θ, q sin θ) q dq,                                                              (5)
/// the power of all waves that run in the direction θ; ridges stand at right angles to it. Each wave number
/// is spread over the angles around its own by a triangle whose half width is 2°, or the angle Δq/q that its
/// cell subtends where that is more. Those below four times 2π/min(Lx,Ly), which hold what is left of the
/// form, and above the smaller of π/Δx, π/Δy, which not all directions have, are left out. Std of ISO 25178-2
/// is where F is largest.
///
/// Symbols   p, q  indices of the wave numbers, p = 0 … nx/2, |q| ≤ ny/2; C(-p,-q) = C(p,q)
///           qx, qy  wave numbers [rad/m]      θ  angle from +x towards +y, in (-π/2, π/2] [rad]
/// Accuracy  (2) to round-off. As an estimate: a single C(p,q) of a Gaussian field has the standard deviation
///           C. The mean over a ring of n of them, half of which are the other half again, has the variance
///           I/n² Σ C², over a row half of that; estimated without bias. I is 1, and 35/18 for each axis with
///           Hann's window, whose neighbours share power; with missing points N Σ w⁴/(Σ w²)² over those that
///           are there. Std within 0.5°, for a wave that fills a few wave numbers; of an isotropic surface it
///           is an accident.
/// Cost      one real transform; of (5) one pass over C.
///
/// T. D. B. Jacobs, T. Junge, L. Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001, for the conventions.
/// F. J. Harris, Proc. IEEE 66 (1978) 51-83, for windows.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

enum class DataWindow { none, hann };

/// Windows along either axis.
struct DataWindows {
  DataWindow x = DataWindow::hann, y = DataWindow::hann;
};

/// None on a periodic grid, Hann's on any other.
DataWindows default_windows(const Grid& grid);

/// I of the variance of means over wave numbers.
double spectrum_inflation(const Field& d, DataWindows windows);

/// (1) over the half-plane of wave numbers p ≥ 0. Sums over all wave numbers: for_each_lag on the periodic
/// grid.
LagField power_spectrum(const Field& d, const Grid& grid, DataWindows windows, int threads = 1);

/// A PSD over one wave number.
struct SpectrumPoint {
  double wave_number = 0;  ///< [rad/m]; of a ring their mean
  double density = 0;      ///< [m³] of profiles, [m⁴] of rings
  double standard_error = 0;
  double count = 0;  ///< wave numbers (qx,qy) that went into it, of both signs
};

enum class Axis1D { x, y };

/// (3) for wave numbers ≥ 0.
std::vector<SpectrumPoint> profile_spectrum(const Field& d, const Grid& grid, Axis1D axis, DataWindow window,
                                            int threads = 1);
/// Of (1), for rings from the first on; `inflation` is I.
std::vector<SpectrumPoint> radial_spectrum(const LagField& psd, const Grid& grid, double inflation);

struct TextureDirection {
  double angle = 0;     ///< Std [rad]
  double contrast = 0;  ///< F at its largest over its mean, 1 for no direction at all
};

/// Of (1).
TextureDirection texture_direction(const LagField& psd, const Grid& grid);

}  // namespace asperity
