/// Periodic surfaces with a prescribed spectrum: no waves shorter than a cut-off, flat above a roll-off.
///
/// A surface that continues itself after Lx × Ly is a sum of waves q = 2π (j/Lx, k/Ly). Here their powers are
/// those of a model where the wave is not shorter than the cut-off λs, and nothing elsewhere,
///     P(q) = C(q̃) / Σ C   for 0 < |q| ≤ 2π/λs,   0 else,                                                (1)
///     R(r)/σ² = Σ P(q) cos(q·r),   kernel^ = √P:                                                        (2)
/// P is set wave by wave and never negative, so that the kernel has R to round-off, and the surface no waves
/// beyond the band except rounding. The mean is no wave and has no power: the rms height about the mean
/// is σ. Nothing in (1) depends on the grid, so that surfaces on a finer one have the same R. Without a
/// cut-off the band ends with the grid, at two samples along x and along y.
///
/// A roll-off λr leaves C as it is on and outside an ellipse, and within it flat along every direction, at
/// the value of C where that direction meets the ellipse:
///     q̃ = q / min(1, e),   e = √((qx' λr1)² + (qy' λr2)²) / 2π.                                         (3)
/// The self-affine model is one of these, of a power law: its own length gives its roll-off.
///
/// C is in acf/target.hpp, (2); the stretched exponential has none in closed form. A roll-off along x' below
/// the wavelength of the exponential-cosine would level the very wave, and is refused.
///
/// The mean square slope is known too, without differences of heights: Sdq²/σ² = Σ |q|² P(q).            (4)
///
/// A spectrum that is known in its own unit (acf/radial_spectrum.hpp) takes the place of the model's: P is
/// (1) of its C, and the waves of the period have the mean square Σ C/(Lx Ly).                            (5)
///
/// Symbols   ^  the discrete Fourier transform over the period    σ  rms height
///           λs, λr1, λr2  cut-off; roll-off along x' and y', in the unit of the model's lengths
/// Accuracy  ε log2(N M) of the variance.
/// Cost      N M/2 values of C, and a real transform for each of R and the kernel: 0.1 s at 1024².
///
/// T. D. B. Jacobs, T. Junge, L. Pastewka, Surf. Topogr.: Metrol. Prop. 5 (2017) 013001; V. A. Yastrebov,
/// G. Anciaux, J.-F. Molinari, Int. J. Solids Struct. 52 (2015) 83-102.
#pragma once

#include <array>
#include <limits>

#include "acf/periodic.hpp"
#include "acf/radial_spectrum.hpp"
#include "acf/target.hpp"

namespace asperity {

/// 2π/q_r along the axis of a self-affine model with this length, in the length's unit; and the inverse.
double rolloff_of(const EllipticTarget& model, double length);
double length_for_rolloff(const EllipticTarget& model, double rolloff);

/// Where the spectrum of a model is changed, in the unit of its lengths.
struct Band {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double cutoff = 0;        ///< shortest wavelength; 0: the band ends with the grid
  double rolloff_x = none;  ///< above it the spectrum is flat, along x'; `none` in both: nowhere
  double rolloff_y = none;  ///< the same along y'

  bool cuts() const { return cutoff != 0; }
  bool levels() const { return rolloff_x != none || rolloff_y != none; }
};

/// The wavelengths that make sense.
struct WaveBounds {
  double least, most;
  bool below(double wave) const { return !(wave >= least * (1 - rounded)); }
  bool above(double wave) const { return !(wave <= most * (1 + rounded)); }

  static constexpr double rounded = 1e-9;  ///< so little beyond is on the bound
};
/// From two samples to the shorter side of the period.
WaveBounds rolloff_bounds(const EllipticTarget& model, Shape period);
/// The same, or to the shorter roll-off, the band's or that of a self-affine model, where it is less.
WaveBounds cutoff_bounds(const EllipticTarget& model, const Band& band, Shape period);

class BandLimited {
 public:
  /// Throws ParameterError of the model's members; ("model") for a stretched exponential; ("rolloff") and
  /// ("cutoff") beyond the bounds; ("length") for a model without power at any wave of the band.
  BandLimited(const EllipticTarget& model, const Band& band, Shape period);
  /// Of all waves that have C. Throws DataError("psd") where no wave of the period has.
  BandLimited(const RadialSpectrum& spectrum, std::array<double, 2> spacing, Shape period);

  const Band& band() const { return band_; }
  /// R/σ² at the lags p = 0 … N/2, q = -M/2 … M/2.
  Field correlation() const { return correlation_of_power(power_, period_); }
  SpectralRoot root() const { return root_of_power(power_, period_); }
  /// Of the whole period, lag zero in its middle, of unit variance.
  Field kernel() const { return kernel_of_power(power_, period_); }
  /// (4), over the square of the unit of the lengths.
  double mean_square_slope() const { return slope_; }
  /// (5), of a spectrum [m²].
  double mean_square() const { return mean_square_; }

 private:
  template <class Density>
  void set_powers(const Density& density, double side_x, double side_y, double most);

  Shape period_;
  Band band_ = {};
  double slope_ = 0, mean_square_ = 0;
  PowerSpectrum power_;  ///< the sum over the whole spectrum is 1
};

}  // namespace asperity
