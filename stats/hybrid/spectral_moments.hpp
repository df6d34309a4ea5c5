/// Spectral moments of a surface and its profiles in any direction.
///
/// With the spectral density S(qx,qy) of the heights,
///     m_kl = ∫∫ qx^k qy^l S dqx dqy = mean of a product of derivatives,                                (1)
///     m20 = <zx²>,  m11 = <zx zy>,  m02 = <zy²>,
///     m40 = <zxx²>,  m31 = <zxx zxy>,  m22 = <zxx zyy>,  m13 = <zxy zyy>,  m04 = <zyy²>,
/// and m00 = Sq². A profile in the direction θ, with c = cos θ and s = sin θ, has the moments m0 = m00,
///     m2 = c² m20 + 2cs m11 + s² m02                                mean square slope                  (2)
///     m4 = c⁴ m40 + 4c³s m31 + 6c²s² m22 + 4cs³ m13 + s⁴ m04        mean square second derivative      (3)
/// (Longuet-Higgins), and the bandwidth parameter α = m0 m4/m2² (Nayak): at least 1 for a profile, at least
/// 3/2 for an isotropic surface, and 3 for a Gaussian autocorrelation.
///
/// The derivatives are the simplest differences: z(i+1) - z(i) and z(i+1) - 2z(i) + z(i-1) along an axis; zx
/// zy of a cell from the mean slopes of its sides; zxy from the four diagonal neighbours. Means are over all
/// points that have these neighbours; on a periodic grid every point has them.
///
/// Symbols   m_kl [m^{2-k-l}]      θ  angle from +x towards +y [rad]
/// Accuracy  With u = qx Δx/2, v = qy Δy/2 and S(t) = sin(t)/t, the contribution of a wave (qx,qy) to m20 has
///           the factor S(u)², to m11 S(u)S(v)cos(u)cos(v), to m40 S(u)⁴, to m22 S(u)²S(v)², to m31
///           S(u)³S(v)cos(u)cos(v): m2 is low by Δ² m4/12, m4 by Δ² m6/6, order 2. For a surface that is
///           rough down to the spacing, m2 and m4 depend on the spacing. m0 as in stats/sample/moments.hpp.
/// Cost      one pass.
///
/// M. S. Longuet-Higgins, Phil. Trans. R. Soc. A 249 (1957) 321-387.
/// P. R. Nayak, Random process model of rough surfaces, J. Lubr. Technol. 93 (1971) 398-407.
#pragma once

#include <cmath>

#include "core/field.hpp"

namespace asperity {

/// Of a profile.
struct ProfileSpectralMoments {
  double m0 = NAN;  ///< [m²]
  double m2 = NAN;
  double m4 = NAN;  ///< [1/m²]

  double bandwidth() const { return m0 * m4 / (m2 * m2); }
};

struct SpectralMoments {
  double m00 = NAN;
  double m20 = NAN, m11 = NAN, m02 = NAN;
  double m40 = NAN, m31 = NAN, m22 = NAN, m13 = NAN, m04 = NAN;

  /// (2), (3).
  ProfileSpectralMoments along(double angle) const;
  /// The isotropic surface of the same m0 and geometric means √(m20 m02), √(m40 m04), the usual choice if x
  /// and y are the axes of the texture.
  ProfileSpectralMoments isotropic() const;
  /// With derivatives of zero where differences of neighbours have at most this rms value [m], and second
  /// differences four times of it.
  SpectralMoments without_round_off(const Grid& grid, double difference) const;
};

/// Throws DataError("heights", …) without 3 × 3 measured points.
SpectralMoments spectral_moments(const Field& z, const Grid& grid, int threads = 1);

}  // namespace asperity
