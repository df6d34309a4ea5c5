/// Summits: counted on the grid, and expected of a Gaussian surface of the same spectral moments.
///
/// Counted  A summit is a point that is higher than each of its eight neighbours, or a plateau that is.
///          Points next to a missing point, or at the edge of a field that is not periodic, are left out,
///          together with their area. The curvature is that of the parabolas along x and y,
///              κ = -½ [(z(i+1,j) - 2z + z(i-1,j))/Δx² + (z(i,j+1) - 2z + z(i,j-1))/Δy²];              (1)
///          Greenwood and Williamson's model uses the density η, the radius R = 1/mean κ, and the standard
///          deviation σ_s of the heights. Peaks of a profile are the same along its axis alone.
/// Plateau  A set of points of equal height that are joined by sides or corners, all of whose other
///          neighbours are lower, as heights in steps make of the top of a hill. One that meets a missing
///          point or the edge is left out; so is one that goes around a periodic field, a ridge. With c_i the
///          curvatures (1) of its n points, L its sides to lower points, and S the sides of a point, 4 of a
///          surface and 2 of a profile, it has the curvature
///              κ = S Σ c_i/(L a),   a = 1 + 2 (n-1)/π of a surface, 1 + (n²-1)/2 of a profile,         (2)
///          that of a single point at n = 1, and of a large plateau that of the paraboloid whose contour at
///          half the mean drop across these sides encloses the plateau, half a step being what rounding
///          leaves of a summit's height on the average.
/// Expected For an isotropic Gaussian surface with the spectral moments m0, m2, m4 of a profile
///          (stats/hybrid/spectral_moments.hpp) and α = m0 m4/m2² (Nayak):
///              η = m4/(6π√3 m2)                                                                       (3)
///              mean height 4 √(m0/(πα)),   σ_s² = m0 [1 - (1 + 16/π - 3√3)/α]                          (4)
///              mean κ = 8 √m4/(3√π),   R = 1/mean κ = 0.375 √(π/m4)                                    (5)
///
/// Symbols   η  density [1/m²]      κ  curvature [1/m]      heights above the mean [m]
///           1 + 16/π - 3√3 = 0.8968
/// Accuracy  Order 2 in the spacing: for a surface of the correlation exp(-r²/l²) the count is low by 0.8
///           (h/l)² and the mean curvature by (h/l)². (3) with finite differences is low by 7/6 (h/l)², the
///           curvature by 5/6 (h/l)². A ninth of independent heights are summits, whatever (3) gives
///           (Greenwood 1984): if counted and expected summits differ, the surface is rough at the scale of
///           the spacing or not Gaussian, or many summits are plateaus, as of heights in steps: such are
///           fewer, and higher.
///           Of Gaussian fields in steps s: κ of (2), and the number of summits, over those without steps, by
///           the length l of the correlation exp(-r²/l²), in points:
///                            l = 4           8            16
///               s = 0.01 Sq   .99, .98     .96, .97     .97, .96
///                   0.05      .98, .93     .99, .91    1.36, .91
///                   0.1       .99, .89    1.12, .86    1.73, .86
///                   0.3      1.11, .76    1.65, .73    2.38, .75
///           where means of c_i have up to 7 times the curvature. (2) holds while s is below κ ΔxΔy; small
///           summits, and those next to a higher one of the same step, are lost whatever is done. Those that
///           are left are higher, by 0.02, 0.04, 0.07 and 0.15 of their mean height.
/// Cost      one pass, in the time of comparing points with their neighbours, and a flood of each plateau. A
///           copy of the field.
///
/// J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300-319.
/// P. R. Nayak, J. Lubr. Technol. 93 (1971) 398-407. J. A. Greenwood, Proc. R. Soc. A 393 (1984) 133-157.
/// (4) from Nayak's joint density of heights and curvatures; in numbers: McCool, Wear 107 (1986) 37-60.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/hybrid/spectral_moments.hpp"

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
  double points = 0;    ///< with all eight neighbours
  double plateaus = 0;  ///< among them, of two points or more
  double width = 0;     ///< √ of the mean number of points of a plateau
};

/// Heights are equal where they round to the same multiple of `rounding`; 0: where they are. Throws
/// DataError("heights", …) without 3 × 3 measured points. Without a summit, density and count are 0 and the
/// others NaN.
CountedSummits counted_summits(const Field& z, const Grid& grid, double rounding = 0, int threads = 1);

struct FoundSummit {
  Index column;  ///< that before it; a plateau stands at its first point
  double height = 0;
  double curvature = 0;
  double points = 1;
};
/// Of each row of NeighbourRows(z, grid, 2) those of the points after it, a row and a column further on.
using SummitRows = std::vector<std::vector<FoundSummit>>;

SummitRows find_summits(const Field& z, const Grid& grid, double rounding = 0);
/// The peaks of a profile, heights `step` apart in a column of a field; each in the row before it.
SummitRows find_peaks(const Field& column, double step, bool periodic);

/// (3)–(5); without second derivatives the density is 0 and the others are NaN.
Summits expected_summits(const ProfileSpectralMoments& moments);

}  // namespace asperity
