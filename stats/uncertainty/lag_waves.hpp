/// Standard errors of an estimated autocorrelation from the field's own long waves, whatever its correlation
/// and the distribution of its heights.
///
/// At each lag h the estimates are means over the n_h pairs of points z, z' a lag apart,
///     R = mean z z',    S = mean (z - z')²,    Q = mean ½(z² + z'²),    ρ = R/R(0,0),                 (1)
/// and stray as long waves of the local functions do (stats/uncertainty/long_waves.hpp): of z z' for R, of
/// (z - z')² for S, and for ρ of
///     f = [z z' - ½ρ (z² + z'²)]/R(0,0),                                                              (2)
/// which is small where z' hardly differs from z. R(0,0) is the mean over the field, Q that over the pairs;
/// they differ by the points near the edges, which makes ρ deviate by ρ (Q/R(0,0) - 1) beside (2).
///
/// At each lag the mode of wave k is c_k times the root of its weight in the average over spectra
/// (stats/uncertainty/wave_spectra.hpp), without its ridges, so that the squares of the modes add up to SE².
/// At all lags of up to half the field they are of the waves ν ≤ 5, too few to tell a ridge from a lay, whose
/// intervals it would widen by half. Student's t has the degrees of freedom of the mean of z².
///
/// The waves are sums over blocks of the field, two a half wave of the shortest, four along a period, and for
/// odd sides one more;
/// a block's products at all lags are a correlation by the FFT, piece by piece where the lags are short. A
/// pair at the lag h whose first point lies in a block about x_b counts there with u(x_b + h/2), the place of
/// its middle; each pair is met from both of its points, and counts a half each time, so that a field and its
/// mirror images have the same errors. With missing heights the waves are made independent over the points
/// of the blocks. At each lag they are divided by their deviation over its pairs, √(mean u² - ū²).
///
/// Symbols   K  waves      ν  half waves      P, Q  longest lags
/// Scope     long_waves.hpp; lags up to half the field.
/// Accuracy  the error itself is known to 1/√(2K). Stated over true error and coverage of the 95 % intervals,
///           the least and the most of eleven textures and of lags 1, 4, 16 (validation/error_coverage), at
///           N_eff 290 to 1230 and at 33 to 140: of ρ 0.88 to 1.03, 90 to 98 % and 0.81 to 1.19, 88 to 100 %;
///           of S 0.90 to 1.04, 91 to 96 % and 0.79 to 1.15, 85 to 98 %. The longest lag has the least.
/// Cost      for B blocks of bx × by points three transforms of (bx + 2P)(by + 2Q) points each, nine with
///           missing heights. Memory: 4K fields over the lags, and five such transforms, of a piece.
#pragma once

#include <cmath>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/long_waves.hpp"

namespace asperity {

class PairBlocks;

class LagWaves {
 public:
  /// Of heights less their mean, NaN where missing, at lags up to max_lag.
  LagWaves(const Field& d, const Grid& grid, Shape max_lag, const FieldExtent& extent, int threads = 1,
           double most = LongWaves::reach);

  /// Of ρ, at least at these lags; of R; of S.
  AcfDeviations of_ratio(const LagField& rho) const;
  AcfDeviations of_covariance() const;
  AcfDeviations of_structure() const;
  double degrees() const;  ///< of freedom

 private:
  // Of a wave u, all over the pairs: Σ u z z', Σ ½u (z² + z'²), Σ u, Σ u².
  struct Wave {
    Field products, squares, pairs, weights;

    void add(const Field& u, const Field& of_products, const Field& of_squares, const Field& of_pairs);
  };
  // Over the points of the blocks.
  static LongWaves::Directions directions(const LongWaves& all, const PairBlocks& blocks,
                                          const Grid& of_blocks);
  // Of a mean of `per_product` z z' + `per_square` ½(z² + z'²): c_k at each lag; the modes.
  std::vector<Field> amplitudes(const Field& per_product, const Field& per_square) const;
  AcfDeviations deviations(const Field& per_product, const Field& per_square) const;

  int threads_;
  WaveSpectra spectra_ = {};
  double variance_ = 0;
  std::vector<Wave> waves_ = {};  // the first is u = 1
};

}  // namespace asperity
