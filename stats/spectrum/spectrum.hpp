/// Power spectral densities: of the surface, radial, angular, and of its profiles.
///
/// With heights d on nx × ny points, the wave numbers qx = 2πp/Lx, qy = 2πq/Ly, and a window w of mean square
/// W,
///     C(qx,qy) = (ΔxΔy)²/(Lx Ly W) |Σ w d exp(-i(qx x + qy y))|²                          [m⁴]         (1)
///     1/(Lx Ly) Σ C = Σ (w d)²/(nx ny W), without a window Sq², over all nx ny wave numbers            (2)
/// (Parseval; in the limit Sq² = 1/(2π)² ∫∫ C dqx dqy). The PSD of the profiles along x is the mean over
/// them, with a window along the profile only, and likewise along y,
///     C1(qx) = Δx²/(Lx W) mean_j |Σ_i w d exp(-i qx x)|² = 1/Ly Σ_qy C(qx,qy)             [m³]         (3)
///     1/Lx Σ C1 = Sq² over all nx wave numbers, of both signs.
/// Of an even number of points the wave of two points is its own mirror image, one wave number in place of
/// two: the sums have it once, and tables that show both signs half of it at each (over_both_signs).
/// The radial PSD is the mean of C over rings of a width of 2π/min(Lx,Ly) up to the smaller of π/Δx, π/Δy.
///
/// A wave number midway between two rings belongs to the outer one, whatever the rounding of the spacing.
/// With ν degrees of freedom, the interval of a mean C is
///     C/χ²(ν; a) … C/χ²(ν; 1-a),     χ² divided by ν, a = (1 - level)/2 the chance to exceed it,       (6)
/// and where a window biases C by b (resolution.hpp), it begins at e^-b of that if b > 0, and ends there if
/// b < 0.
///
/// A field that is not periodic leaks: its joined edges form a step, with C ~ 1/q². Hann's window
/// 1 - cos(2πx/Lx), and the same in y, prevents this; resolution falls to 1.5 wave numbers.
///
/// Missing heights are set to the mean, and W is the mean of w² over all points with w = 0 at missing ones:
/// (2) is then Sq² of the measured points. Holes leak as edges do. If a share g of the points is missing
/// independently, the expectation of C is
///     (1-g) C + g Sq² ΔxΔy,                                                                           (4)
/// with a floor of white noise that hides short waves of the surface.
///
/// The angular spectrum is
///     F(θ) = ∫ C(q cos θ, q sin θ) q dq,                                                              (5)
/// the power of all waves that run in the direction θ, at right angles to their ridges. Each wave number is
/// spread over neighbouring angles by a triangle whose half width is 2°, or the angle Δq/q of its cell if
/// that is larger. Wave numbers below four times 2π/min(Lx,Ly), which hold remains of the form, and above the
/// smaller of π/Δx, π/Δy, which do not exist in all directions, are left out. Std of ISO 25178-2 is the angle
/// of the largest F. Its error is the rms change when powers are drawn again, 64 times, about those found:
/// with lognormal factors of the variance r/2, r what neighbouring wave numbers share (shared_power.hpp), and
/// ½ because a power found has chance itself; and a sector of 0.5°. F has another maximum F_2 beside the
/// largest, two lays, if
///     ln(F_2/F_b) > 3.5 √(Var[F_2]/F_2² + Var[F_b]/F_b²),     Var[F] = r/2 Σ (share of C)²,            (7)
/// F_b the least F on the way from one to the other, on either side, and F_2 > F/100 of the largest.
///
/// Symbols   p, q  indices of the wave numbers, p = 0 … nx/2, |q| ≤ ny/2; C(-p,-q) = C(p,q)
///           qx, qy  wave numbers [rad/m]      θ  angle from +x towards +y, in (-π/2, π/2] [rad]
/// Accuracy  (2) to round-off. As an estimate: a single C(p,q) of a Gaussian field has the standard deviation
///           C, its interval of 95 % runs from 0.271 C to 39.5 C (two degrees of freedom; one, 0.199 C to
///           1018 C, at its own mirror image, p and q 0 or half of an even nx, ny). Errors and degrees of
///           freedom of means: shared_power.hpp; what else an error holds, and what there is none of:
///           stats/measure/spectra.hpp. Std within 0.5° for a wave that covers a few wave numbers; for an
///           isotropic surface it is random. Its errors are 1.3 to 1.8 of the true ones, and intervals
///           of 1.96 of them hold 98 to 100 % (60 fields each of four textures, 128 × 128 points, lengths 2:1
///           and lays of 4:1). Two lays were found in none of 1800 fields with one lay or none, of twelve
///           textures, square, strips and oblong cells, and in 6 of 150 patchy; in all of 120 with two, at
///           right angles, of unequal strength, or 60° apart (N_eff 590 to 660).
/// Cost      one real transform; of (5) one pass over C.
/// Memory    of C with the field, two and a half of it.
///
/// T. D. B. Jacobs, T. Junge, L. Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001, for the conventions.
/// F. J. Harris, Proc. IEEE 66 (1978) 51-83, for windows.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "stats/filter/axis_products.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/spectrum/shared_power.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

enum class DataWindow { none, hann };

/// Windows along either axis.
struct DataWindows {
  DataWindow x = DataWindow::hann, y = DataWindow::hann;
};

/// Of profiles along one axis.
inline DataWindows windows_along(Axis1D axis, DataWindow window) {
  return axis == Axis1D::x ? DataWindows{window, DataWindow::none} : DataWindows{DataWindow::none, window};
}

/// None on a periodic grid, Hann's on others.
DataWindows default_windows(const Grid& grid);

/// What the wave numbers of power_spectrum share.
SharedPower shared_power(const Field& d, DataWindows windows);

/// (1) over the half-plane of wave numbers p ≥ 0. For sums over all wave numbers use for_each_lag on the
/// periodic grid.
LagField power_spectrum(const Field& d, const Grid& grid, DataWindows windows, int threads = 1);

/// C with that of a wave of two points halved along either axis: the half-plane that adds up to (2) when rows
/// p > 0 count twice and all columns once.
Field over_both_signs(const LagField& psd, const Grid& grid);

/// Why a point of a spectrum has no error (stats/spectrum/resolution.hpp, holes.hpp), or a value by scale
/// (stats/measure/scales.hpp).
enum class NoError { none, form, leakage, resolution, holes, steps, size, flat, tip };
/// In one word; "" for none.
const char* reason(NoError why);

/// A PSD over one wave number.
struct SpectrumPoint {
  double wave_number = 0;  ///< [rad/m]; for a ring the mean
  double density = 0;      ///< [m³] for profiles, [m⁴] for rings
  double standard_error = 0;
  double degrees = 0;  ///< ν of the χ² that density is distributed as
  double count = 0;    ///< number of wave numbers (qx,qy), of both signs
  double bias = 0;  ///< ln of the density over that of the surface, by window and holes, as far as it is seen
  NoError no_error = NoError::none;

  /// (6)
  Interval interval(double level = 0.95) const;
};

/// (3) for wave numbers ≥ 0.
std::vector<SpectrumPoint> profile_spectrum(const Field& d, const Grid& grid, Axis1D axis, DataWindow window,
                                            int threads = 1);
/// The same from (1) with a window along this axis alone.
std::vector<SpectrumPoint> profile_spectrum(const LagField& psd, const Grid& grid, Axis1D axis,
                                            const SharedPower& shared);
/// The means of (1) over rings from the first on.
std::vector<SpectrumPoint> radial_spectrum(const LagField& psd, const Grid& grid, const SharedPower& shared);

struct TextureDirection {
  double angle = std::numeric_limits<double>::quiet_NaN();  ///< Std [rad]
  double contrast = angle;                                  ///< largest F over its mean, 1 for no texture
  double error = angle;                                     ///< of Std [rad]
  std::optional<double> other = {};                         ///< of F_2 of (7) [rad]
};

/// From (1). `overlap` is that of what the wave numbers share.
TextureDirection texture_direction(const LagField& psd, const Grid& grid, double overlap = 1);
/// With the default windows.
TextureDirection texture_direction(const Field& d, const Grid& grid, int threads = 1);

}  // namespace asperity
