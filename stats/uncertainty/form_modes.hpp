/// What a removed form takes from a field.
///
/// The form of degree d (stats/filter/form.hpp) holds M modes φ_k that are orthonormal over the measured
/// points (stats/filter/axis_products.hpp). Of a field of variance σ² and correlation ρ it takes the share
///     w = 1/N Σ_k φ_kᵀ ρ φ_k = M/N Σ_{p,q} v B ρ,                                                      (1)
///     v B = 1/M Σ_k Σ_{i,j} φ_k(i,j) φ_k(i+p, j+q),                                                    (2)
/// v(p,q) the share of the points that have a partner at a lag, B the mean autocorrelation of the modes over
/// these pairs, 1 at lag zero and at all lags for d = 0. Of a complete field the modes are the products
/// P_a P_b, a + b ≤ d, M = (d+1)(d+2)/2 where no side has fewer points than degrees, and
///     B(p,q) = 1/M Σ_ab α_a(p) α_b(q),     α_a(p) = n/(n-|p|) Σ_i P_a(i) P_a(i+p).                    (3)
/// Where ρ is short compared with the modes, each takes about the same, and
///     E[Sq²] = σ² (1 - w),     ρ becomes (ρ - w B)/(1 - w).                                           (4)
///
/// Symbols   N  points, n along an axis      σ  rms height without removal [m]
/// Scope     any outline. Filters are not forms.
/// Accuracy  (1) exact, round-off ε n. (4) to first order in the ratio of the correlation
///           length to the modes' waves. Estimates of w from the field itself, by its correlation
///           (stats/uncertainty/effective_size.hpp) and by the modes of the next degrees
///           (stats/height/height_error.hpp), median of 24 fields of 128 × 128 points, N_eff 340, degree 1,
///           2, 4: exponential 0.029, 0.049, 0.086 (true: 0.030, 0.055, 0.115), Gaussian 0.018, 0.034, 0.071
///           (0.017, 0.032, 0.074), a lay 0.015, 0.027, 0.056 (0.006, 0.011, 0.026).
///           95 % intervals, 100 fields of each of 11 textures, N_eff 290 to 1230, degree 2
///           (validation/error_coverage 100 all 128x128 4 2): those of Sq cover 87 to 96 % (56 to 94 % if
///           nothing is put back), of Sal 89 to 100 % (76 to 100 %), of lengths at 1/e 83 to 99 % (78 to
///           98 %), of ρ 80 to 97 % (78 to 96 %), least for plateaus.
///           Of 100 fields of 64 × 64 points on a triangle, N_eff 140 to 510, form of degree 2, intervals of
///           the mean cover 88 to 98 % (80 to 90 % with modes of the square), of Sq 92 to 96 %; on a disc,
///           N_eff 220 to 820, degree 4, 85 to 99 % and 91 to 97 % (69 to 76 % and 64 to 90 % of four
///           of them): ten textures, validation/error_coverage.
///           Of 16 fields of 64 × 64 points with a Gaussian correlation of 4 samples, degree 2, 4, 6, 8, 12,
///           20, M/N_eff of what is left is 0.03, 0.08, 0.14, 0.20, 0.32, 0.52, and intervals of Sq cover all
///           but at degree 20, where they cover none: there the modes beyond the form hold next to nothing,
///           and tell nothing of it. Of 8 fields of 24 × 24 points, 3 samples, degree 8, it is 0.40, and 6
///           are covered. Above M/N_eff = 1/3, or w = 1/2, no errors are given.
/// Cost      nothing for the mean; of a complete field d+1 pairs of transforms of either side and d products
///           a lag; of others 2M transforms of twice the sides.
#pragma once

#include <memory>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/filter/form.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

class FormModes {
 public:
  FormModes() = default;  ///< the mean
  /// Of a complete field.
  FormModes(const Grid& grid, int degree);
  /// Of a field whose missing points are NaN.
  FormModes(const Field& z, const Pairs& pairs, int degree, int threads = 1);

  int degree() const { return degree_; }
  double count() const { return count_; }  ///< M
  /// B at a lag, p ≥ 0, that is shorter than the field.
  double operator()(Index p, Index q) const;
  /// B at the lags up to max_lag.
  LagField correlation(Shape max_lag) const { return LagField::of(max_lag, *this); }

 private:
  int degree_ = 0;
  double count_ = 1;
  Eigen::MatrixXd along_x_ = {};                    ///< α_a, a row a lag
  Eigen::MatrixXd along_y_ = {};                    ///< Σ_b α_b over b ≤ d - a, likewise
  std::shared_ptr<const LagField> of_points_ = {};  ///< B, where heights are missing
};

}  // namespace asperity
