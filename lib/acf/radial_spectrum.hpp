/// A power spectral density of an isotropic surface, known at some wave numbers.
///
/// With q = 2π/wavelength, C(q) is the density of the surface and C1(q) that of its profiles, of both signs,
/// as stats/spectrum/spectrum.hpp has them,
///     σ² = 1/(2π)² ∫∫ C dqx dqy = 1/2π ∫ q C dq,  σ² = 1/2π ∫ C1 dq over all q = 1/π ∫ C1 dq, q > 0.  (1)
/// Both are two-sided: of cycles in place of radians they have the same values, of one sign twice these.
///
/// Between two rows ln C is linear in ln q, a power law. Beyond its ends C is zero: nothing is extrapolated.
///
/// From profiles. A profile crosses the waves of all directions,
///     C1(k) = 1/π ∫_0^∞ C(√(k² + v²)) dv,                                                               (2)
/// which Abel's transform inverts [1]. In place of C = -2 ∫_q C1' dk/√(k² - q²), which differentiates a
/// measured C1, the same projection once more gives the power of all shorter waves,
///     G(q) = ∫_q^∞ k C dk = 2 ∫_0^∞ C1(√(q² + v²)) dv,    C = -G'/q,                                    (3)
/// and C at the middle of two rows by the power law of G between them. Rows nearer than 1/8 octave are
/// averaged first. Beyond its last row C1 falls in (3) as over its last octave, as q^-1.5 at the least: those
/// waves are in C1 too, and are left out of C. G must fall; where it does not, by chance or because no
/// isotropic surface has C1, it is replaced by the nearest that does (pool adjacent violators), and refused
/// where that changes it by more than a quarter of the variance.
///
/// Symbols   q, k  wave numbers [rad/m]   C [m⁴]   C1 [m³]   σ  rms height [m]
/// Accuracy  (1) of the power laws to round-off. (3) of one power law C1 = A q^-s, s ≥ 1.5, of which C is
///           √π s Γ((s+1)/2)/Γ(s/2+1) A q^-(s+1): 1e-6 with rows an eighth of an octave to an octave apart,
///           1e-5 at the widest gaps, 1 % with nearer rows. Of others second order in the step of ln q.
/// Cost      a search and an exponential a value; (3) 8 powers for each pair of rows.
///
/// [1] R. N. Bracewell, The Fourier transform and its applications (1965), ch. 12; P. R. Nayak, Wear 26
///     (1973) 165-174, for profiles of isotropic surfaces.
#pragma once

#include <vector>

namespace asperity {

/// Rows of a table.
struct SpectrumRows {
  std::vector<double> q, density;
};

class RadialSpectrum {
 public:
  static constexpr double widest_gap = 10;  ///< ratio of neighbouring wave numbers

  /// Of C. Throws DataError("psd", …) naming the row: fewer than two, q not positive or not increasing, a
  /// gap, a density that is not positive.
  explicit RadialSpectrum(SpectrumRows rows, double gap = widest_gap);

  double operator()(double q) const;
  double first() const { return rows_.q.front(); }
  double last() const { return rows_.q.back(); }
  /// (1) of the waves from `low` to `high`.
  double mean_square(double low, double high) const;
  /// (1) of the waves beyond most_x along x or most_y along y.
  double mean_square_beyond(double most_x, double most_y) const;

 private:
  SpectrumRows rows_;
};

/// C of C1 by (3).
struct ProfileSpectrum {
  RadialSpectrum spectrum;
  double change = 0;  ///< largest of G, as a share of the variance
  double beyond = 0;  ///< share of the variance beyond the last row
};
/// Throws as RadialSpectrum, and where no isotropic surface has the profiles.
ProfileSpectrum spectrum_of_profiles(const SpectrumRows& rows);

}  // namespace asperity
