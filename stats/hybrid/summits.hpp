/// Summits: counted on the grid, and expected of a Gaussian surface of the same spectral moments.
///
/// Counted  A summit is a point higher than each of its eight neighbours; points at the edge of a field that is not
///          periodic, or beside a missing point, are none, nor do they count as area. Its curvature is that of the
///          parabolas through it along x and y,
///              κ = -½ [(z(i+1,j) - 2z + z(i-1,j))/Δx² + (z(i,j+1) - 2z + z(i,j-1))/Δy²],              (1)
///          and Greenwood and Williamson's model takes from them the density η, the radius R = 1/mean κ, and
///          the standard deviation σ_s of their heights.
/// Expected Of an isotropic Gaussian surface with the spectral moments m0, m2, m4 of a profile
///          (stats/hybrid/spectral_moments.hpp) and α = m0 m4/m2² (Nayak):
///              η = m4/(6π√3 m2)                                                                       (2)
///              mean height 4 √(m0/(πα)),   σ_s² = m0 [1 - (1 + 16/π - 3√3)/α]                          (3)
///              mean κ = 8 √m4/(3√π),   R = 1/mean κ = 0.375 √(π/m4)                                    (4)
///
/// Symbols   η  density [1/m²]      κ  curvature [1/m]      heights above the mean [m]
///           1 + 16/π - 3√3 = 0.8968
/// Accuracy  Order 2 in the spacing: of a surface of the correlation exp(-r²/l²) the count is low by 0.8
///           (h/l)² and the mean curvature by (h/l)². (2) with finite differences: by 7/6 (h/l)², the
///           curvature by 5/6 (h/l)². Of independent heights, which have no derivatives, the ninth part are
///           summits, whatever (2) says (Greenwood 1984): where counted and expected differ, the surface is
///           rough at the scale of the spacing, or not Gaussian. Points of equal height, as in coarsely
///           quantised data, are no summits.
/// Cost      one pass.
///
/// J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300-319.
/// P. R. Nayak, J. Lubr. Technol. 93 (1971) 398-407. J. A. Greenwood, Proc. R. Soc. A 393 (1984) 133-157.
/// (3) from Nayak's joint density of heights and curvatures; McCool, Wear 107 (1986) 37-60, has it in digits.
#pragma once

#include "core/field.hpp"
#include "stats/hybrid/neighbours.hpp"
#include "stats/hybrid/spectral_moments.hpp"

namespace asperity {

struct Summits {
  double density = 0;           ///< η [1/m²]
  double mean_height = 0;       ///< above the mean of the surface [m]
  double height_deviation = 0;  ///< σ_s [m]
  double mean_curvature = 0;    ///< [1/m]

  double radius() const { return 1 / mean_curvature; }  ///< R [m]
};

struct CountedSummits : Summits {
  double count = 0;
};

/// The sums of a field that comes in strips with two rows behind each but the last.
class SummitSums {
 public:
  /// `level` is the mean of the whole field.
  void add(const Strip& strip, double level, int threads = 1);
  /// Throws DataError("heights", …) without 3 × 3 points that are there. Without a summit all is zero.
  CountedSummits summits(const Grid& grid) const;

 private:
  RowSums<4> sums_{};
};

/// (2)–(4).
Summits expected_summits(const ProfileSpectralMoments& moments);

}  // namespace asperity
