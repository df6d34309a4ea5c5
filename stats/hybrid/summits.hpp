/// Summits: counted on the grid, and expected of a Gaussian surface of the same spectral moments.
///
/// Counted  A summit is a point that is higher than each of its eight neighbours, or a plateau of equal
///          points that is (stats/hybrid/summit_finder.hpp). Points beside a missing point, or at the edge of
///          a field that is not periodic, are left out, together with their area. The curvature is that of
///          the parabolas along x and y,
///              κ = -½ [(z(i+1,j) - 2z + z(i-1,j))/Δx² + (z(i,j+1) - 2z + z(i,j-1))/Δy²];              (1)
///          Greenwood and Williamson's model uses the density η, the radius R = 1/mean κ, and the standard
///          deviation σ_s of the heights.
/// Expected For an isotropic Gaussian surface with the spectral moments m0, m2, m4 of a profile
///          (stats/hybrid/spectral_moments.hpp) and α = m0 m4/m2² (Nayak):
///              η = m4/(6π√3 m2)                                                                       (2)
///              mean height 4 √(m0/(πα)),   σ_s² = m0 [1 - (1 + 16/π - 3√3)/α]                          (3)
///              mean κ = 8 √m4/(3√π),   R = 1/mean κ = 0.375 √(π/m4)                                    (4)
///
/// Symbols   η  density [1/m²]      κ  curvature [1/m]      heights above the mean [m]
///           1 + 16/π - 3√3 = 0.8968
/// Accuracy  Order 2 in the spacing: for a surface of the correlation exp(-r²/l²) the count is low by 0.8
///           (h/l)² and the mean curvature by (h/l)². (2) with finite differences is low by 7/6 (h/l)², the
///           curvature by 5/6 (h/l)². A ninth of independent heights are summits, whatever (2) gives
///           (Greenwood 1984): if counted and expected summits differ, the surface is rough at the scale of
///           the spacing or not Gaussian, or many summits are plateaus, as of heights in steps: such are
///           fewer, and higher.
/// Cost      one pass.
///
/// J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300-319.
/// P. R. Nayak, J. Lubr. Technol. 93 (1971) 398-407. J. A. Greenwood, Proc. R. Soc. A 393 (1984) 133-157.
/// (3) from Nayak's joint density of heights and curvatures; in numbers: McCool, Wear 107 (1986) 37-60.
#pragma once

#include "stats/hybrid/neighbours.hpp"
#include "stats/hybrid/spectral_moments.hpp"
#include "stats/hybrid/summit_finder.hpp"

namespace asperity {

struct Summits {
  double density = NAN;           ///< η [1/m²]
  double mean_height = NAN;       ///< above the mean of the surface [m]
  double height_deviation = NAN;  ///< σ_s [m]
  double mean_curvature = NAN;    ///< [1/m]

  double radius() const { return mean_curvature > 0 ? 1 / mean_curvature : NAN; }  ///< R [m]
};

struct CountedSummits : Summits {
  double count = 0;
  double plateaus = 0;  ///< among them, of two points or more
  double width = 0;     ///< √ of the mean number of points of a plateau
};

/// The sums of a field.
class SummitSums {
 public:
  /// Heights that round to the same multiple of `rounding` are equal.
  SummitSums(double rounding = 0) : finder_(rounding) {}
  /// `level` is the mean of the field.
  void add(const Strip& strip, double level, int threads = 1);
  /// Throws DataError("heights", …) without 3 × 3 measured points. Without a summit, density and count are 0
  /// and the others NaN.
  CountedSummits summits(const Grid& grid) const;

 private:
  SummitFinder finder_;
  RowSums<5> sums_{};
};

/// (2)–(4); without second derivatives the density is 0 and the others are NaN.
Summits expected_summits(const ProfileSpectralMoments& moments);

}  // namespace asperity
