/// Spectral moments of a surface and its profiles in any direction.
///
/// With the spectral density S(qx,qy) of the heights,
///     m_kl = ∫∫ qx^k qy^l S dqx dqy = mean of a product of derivatives,                                (1)
///     m20 = <zx²>,  m11 = <zx zy>,  m02 = <zy²>,
///     m40 = <zxx²>,  m31 = <zxx zxy>,  m22 = <zxx zyy>,  m13 = <zxy zyy>,  m04 = <zyy²>,
/// and m00 = Sq². A profile in the direction θ, with c = cos θ and s = sin θ, has the moments m0 = m00,
///     m2 = c² m20 + 2cs m11 + s² m02                                mean square slope                  (2)
///     m4 = c⁴ m40 + 4c³s m31 + 6c²s² m22 + 4cs³ m13 + s⁴ m04        mean square second derivative      (3)
/// (Longuet-Higgins), and the bandwidth parameter α = m0 m4/m2² (Nayak), ≥ 1 of a profile; 3/2 is the least
/// of an isotropic surface, 3 that of a Gaussian autocorrelation.
///
/// The derivatives are the simplest differences: along an axis z(i+1) - z(i) and z(i+1) - 2z(i) + z(i-1),
/// over all points that have these neighbours; zx zy of a cell from the means of its sides' slopes, zxy from
/// the four diagonal neighbours. On a periodic grid every point has neighbours; where one is missing, the difference
/// does not count.
///
/// Symbols   m_kl [m^{2-k-l}]      θ  angle from +x towards +y [rad]
/// Accuracy  With u = qx Δx/2, v = qy Δy/2 and S(t) = sin(t)/t, a wave (qx,qy) is counted in m20 with the
///           factor S(u)², in m11 S(u)S(v)cos(u)cos(v), in m40 S(u)⁴, in m22 S(u)²S(v)², in m31
///           S(u)³S(v)cos(u)cos(v): m2 is low by Δ² m4/12, m4 by Δ² m6/6, order 2. A surface that is rough
///           down to the spacing has no m2 and m4 other than those of its spacing. m0 as in
///           stats/sample/moments.hpp.
/// Cost      one pass.
///
/// M. S. Longuet-Higgins, Phil. Trans. R. Soc. A 249 (1957) 321-387.
/// P. R. Nayak, Random process model of rough surfaces, J. Lubr. Technol. 93 (1971) 398-407.
#pragma once

#include "core/field.hpp"
#include "stats/hybrid/neighbours.hpp"

namespace asperity {

/// Of a profile.
struct ProfileSpectralMoments {
  double m0 = 0;  ///< [m²]
  double m2 = 0;
  double m4 = 0;  ///< [1/m²]

  double bandwidth() const { return m0 * m4 / (m2 * m2); }
};

struct SpectralMoments {
  double m00 = 0;
  double m20 = 0, m11 = 0, m02 = 0;
  double m40 = 0, m31 = 0, m22 = 0, m13 = 0, m04 = 0;

  /// (2), (3).
  ProfileSpectralMoments along(double angle) const;
  /// The isotropic surface of the same m0 and geometric means √(m20 m02), √(m40 m04), as is usual where x and
  /// y are the texture's axes.
  ProfileSpectralMoments isotropic() const;
};

/// The sums of a field that comes in strips with two rows behind each but the last.
class SpectralMomentSums {
 public:
  /// `level` is the mean of the whole field.
  void add(const Strip& strip, double level, int threads = 1);
  /// Throws DataError("heights", …) without 3 × 3 points that are there.
  SpectralMoments moments(const Grid& grid) const;

 private:
  RowSums<9> sums_{};
};

}  // namespace asperity
