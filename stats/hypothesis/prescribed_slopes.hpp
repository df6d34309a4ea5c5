/// The rms slope and the density of summits that a grid shows of a Gaussian surface of known correlation.
///
/// Sdq is that of differences between neighbours (stats/hybrid/slopes.hpp). No limit of a small spacing is
/// needed, nor that the surface has a slope: of rms height σ and correlation ρ, whatever the distribution,
///     E[Sdq²] = 2σ² [(1 - ρ(1,0))/Δx² + (1 - ρ(0,1))/Δy²].                                           (1)
/// Sdq² has the spectrum of the heights times that of the differences, as the mean square of a field with
///     D(h) = [2ρ(h) - ρ(h+e_x) - ρ(h-e_x)]/Δx² + the same for y,                                     (2)
/// and of Gaussian heights over N cells the variance 2σ⁴ Σ v D²/N and the third cumulant 8σ⁶ mean F³/N², v
/// the overlap of the field with itself and F the spectrum of D √v.
///
/// Summits are points above their eight neighbours (stats/hybrid/summits.hpp). A point is one with the
/// probability that eight Gaussian differences are positive,
///     P = P(z(0) - z(j) > 0, all j),   Cov(j,k)/σ² = 1 - ρ(j) - ρ(k) + ρ(j-k),                       (3)
/// by Genz's sequence of conditional probabilities over a lattice. Nayak's density is the limit of P/(ΔxΔy)
/// for a spacing far below the shortest wave. Translated heights have the summits of the Gaussian field.
/// The number of summits among N points has the variance φ P N. A summit keeps others away, so that φ is a
/// third to a half. It is taken from periodic fields that are drawn, six times as long as the slopes are
/// correlated, and of every k-th point only where that leaves ten of them or more in this length c, which
/// changes φ little. At the edges of a field nothing is kept away: there φ grows by (1 - φ)(c_x/nx +
/// c_y/ny)/2.
///
/// Symbols   ρ  correlation    σ  rms height [m]    Δx, Δy  spacings [m]    P  share of points
/// Scope     Tables of ρ with lags up to 1 for (1), 2 for (3).
/// Missing   N counts the cells, or the points, that have all neighbours. The variances are upper bounds: of
///           scattered holes the error is too large by up to 1/√(share of these).
/// Accuracy  (1) and (3) are exact but for the lattice, whose error is given: 0.1 % where slopes are hardly
///           correlated, 1 % where they are over 20 points. φ to √(2/K) of K fields.
/// Cost      (3) 3 ms, 8 ms where slopes are correlated over many points; φ 400 000 points, 5 to 10 ms.
///
/// A. Genz, J. Comput. Graph. Stat. 1 (1992) 141-149; J. A. Greenwood, Proc. R. Soc. A 393 (1984) 133-157.
#pragma once

#include <cstdint>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

/// What a field shows; NaN without a cell of 2 × 2 points, or 3 × 3 points, that are all there.
struct GridSlopes {
  double square = unset, cells = 0;  ///< Sdq², and the cells
  double share = unset, points = 0;  ///< summits per point, and the points
  double plateaus = 0;               ///< share of the summits

  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
};
GridSlopes grid_slopes(const Field& z, const Grid& grid, int threads = 1);

/// A number with its standard error.
struct SummitShare {
  double value, error;
};
/// (3); zero along an axis without slopes.
SummitShare summit_share(const LagField& correlation);

/// What is expected, per σ.
class PrescribedSlopes {
 public:
  PrescribedSlopes() = default;
  /// Of a normalised ρ.
  PrescribedSlopes(const LagField& correlation, const Grid& grid);

  double square = GridSlopes::unset;          ///< (1); NaN where the table lacks the lags
  SummitShare summits{GridSlopes::unset, 0};  ///< the same
  double variance = 0, skewness = 0;          ///< of Sdq²: times the cells of a field, times their root
  double dispersion = 0;                      ///< φ
  int drawn = 0;                              ///< fields that it rests on

  /// Of the correlation of the Gaussian field; where the table and the grid have the lags and a summit.
  void set_summits(const LagField& correlation, const Grid& grid);
  /// Draws fields for φ; where they have no summit, there is none to expect.
  void draw_summits(const LagField& correlation, const Grid& grid, int threads, std::uint64_t seed);
};

}  // namespace asperity
