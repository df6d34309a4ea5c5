/// What a removed form takes from a field.
///
/// The form of degree d (stats/filter/form.hpp) holds M orthonormal modes φ_ab = P_a P_b, a + b ≤ d. Of a
/// field of variance σ² and correlation ρ it takes the share
///     w = 1/N Σ_ab φ_abᵀ ρ φ_ab = M/N Σ_{p,q} v B ρ,     M = (d+1)(d+2)/2,                            (1)
///     B(p,q) = 1/M Σ_ab α_a(p) α_b(q),     α_a(p) = n/(n-|p|) Σ_i P_a(i) P_a(i+p),                    (2)
/// v(p,q) the share of the points that have a partner at a lag, B the mean autocorrelation of the modes over
/// these pairs, 1 at lag zero and at all lags for d = 0. Where ρ is short compared with the modes, each takes
/// about the same, and
///     E[Sq²] = σ² (1 - w),     ρ becomes (ρ - w B)/(1 - w).                                           (3)
///
/// Symbols   N  points, n along an axis      σ  rms height without removal [m]
/// Scope     Full grids; with missing points v is that of the points, and the modes are as if all were
///           there: of a disc in 128 × 128 points, form of degree 4, 95 % intervals of the mean cover 67 to
///           77 %, and those of Sq 75 to 88 %.
///           Filters are not forms.
/// Accuracy  (1) exact for a full grid, round-off ε n. (3) to first order in the ratio of the correlation
///           length to the modes' waves. Estimates of w from the field itself, by its correlation
///           (stats/uncertainty/effective_size.hpp) and by the modes of the next degrees
///           (stats/height/height_error.hpp), median of 24 fields of 128 × 128 points, N_eff 340, degree 1,
///           2, 4: exponential 0.029, 0.049, 0.086 (true: 0.030, 0.055, 0.115), Gaussian 0.018, 0.034, 0.071
///           (0.017, 0.032, 0.074), a lay 0.015, 0.027, 0.056 (0.006, 0.011, 0.026).
///           95 % intervals, 100 fields of each of 11 textures, N_eff 290 to 1230, degree 2
///           (validation/error_coverage 100 all 128x128 4 2): those of Sq cover 87 to 96 % (56 to 94 % if
///           nothing is put back), of Sal 89 to 100 % (76 to 100 %), of lengths at 1/e 83 to 99 % (78 to
///           98 %), of ρ 80 to 97 % (78 to 96 %), least for plateaus.
/// Cost      nothing for the mean; else d+1 pairs of transforms of either side for (2) and d products a lag
///           for B.
#pragma once

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

class FormModes {
 public:
  FormModes() = default;  ///< the mean
  FormModes(const Grid& grid, int degree);

  int degree() const { return degree_; }
  double count() const { return count_; }  ///< M
  /// B at the lags up to max_lag, at most the field less one point.
  LagField correlation(Shape max_lag) const;

 private:
  int degree_ = 0;
  double count_ = 1;
  Eigen::MatrixXd along_x_ = {}, along_y_ = {};  ///< α, a column a degree, a row a lag
};

}  // namespace asperity
