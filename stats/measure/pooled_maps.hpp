/// Parameters of several maps of one surface, pooled: what the maps have in common is evaluated once.
///
/// The mean of single estimates keeps the bias of each, which does not fall with the number of maps: a map
/// lacks the waves that its mean or form took, and lengths and shares are curved functions of noisy figures.
/// Pooled are therefore, over n maps i of variance m_i about their own means or forms and of the share a_i of
/// the measured area of all (stats/sample/ensemble.hpp says why that), 1/n for equal maps,
///     F = Σ a_i F_i,     m = Σ a_i m_i,     B = Σ a_i B_i,     w = B/(m + B),                          (1)
///     ρ = Σ a_i (R_i + B_i b_i)/(m + B),                                                               (2)
/// F_i the distribution of heights z - z̄_i, R_i the autocorrelation, B_i = m_i w_i/(1 - w_i) the variance
/// that mean or form took (stats/height/height_error.hpp; stats/uncertainty/effective_size.hpp of a known
/// correlation), b_i the correlation of its modes (stats/uncertainty/form_modes.hpp). Heights of F are larger
/// by 1/√(1 - w); Ssk, Sku and shares of area are those of F; lengths are those of ρ; Sdq² and the spectral
/// moments are means, and what is a function of them - bandwidth, expected summits, radius - is that of the
/// means. Errors are those of the jackknife over the maps left out one by one,
///     SE² = 1/(n-1) Σ a_i (P_i - P̄)²,    P_i = T/a_i - (1/a_i - 1) T_(i),    P̄ = Σ a_i P_i,            (3)
/// for equal maps (n-1)/n Σ (T_(i) - T̄)². Of a mean T = Σ a_i x_i, P_i is x_i: its variances are as 1/a_i,
/// and SE² is without bias, with n - 1 degrees of freedom of Student's t. More than 40 maps are left out in
/// 40 groups, which count as their mean map, with 39. Sal, the slowest decay, Str and ellipticities are
/// extremes over directions of a noisy contour. The jackknife takes their bias of order 1/n,
///     P̄ = T - (n-1) (T̄ - T),    T̄ = Σ (1-a_i) T_(i)/(n-1),                                            (4)
/// and half of that of a circle, which is of order 1/√n. The first three still keep one of an error or more:
/// they have none. A direction whose error exceeds π/8, as by chance, is none.
///
/// Of several spacings the lags of (2) are those of the coarsest; R of a finer map is interpolated there by
/// cubics, h⁴/43 of its fourth derivative off for its spacing h, and nothing at common lags. Derivatives
/// depend on the spacing and have no value then.
///
/// Symbols   R  autocovariance [m²]      T, T_(i)  a parameter, and that without map i
/// Scope     maps of any size, that resolve the same waves. Other parameters stay means of estimates, by
///           area; extremes depend on the size.
/// Accuracy  of 50 ensembles of 12 Gaussian maps each, estimated correlation: 48 × 48 points, Gaussian
///           correlation of length 6 at 10 %, form of degree 2; 96 × 96, exponential of 18; 64 × 64,
///           exponential of 20. Bias and coverage of 95 % intervals in per cent, first of means of estimates
///           with ± 1.96 errors:
///             Sq    -5.2, 20 → 1.5, 90    -1.9, 82 → 0.1, 98    -4.2, 62 → 1.7, 98
///             Sku   -1.7, 86 → 0.0, 96    -1.0, 92 → 0.5, 96    -2.8, 70 → 0.7, 96
///             Sk    -5.4, 36 → 1.8, 86    -1.7, 88 → 0.0, 100   -4.0, 68 → 1.5, 98
///             Spk   -7.6, 62 → -0.5, 92   -3.0, 78 → -0.1, 100  -6.5, 72 → 2.3, 100
///             Vvv   -6.1, 50 → 1.1, 98    -2.5, 76 → 0.0, 90    -6.2, 58 → 1.0, 94
///             length_e_x  -8.1, 12 → 0.7, 94   -3.9, 84 → 0.6, 96
///             Sal   -19, 0 → -3           -20, 4 → -6           -33, 0 → -3       before (4)
///             Str   -21, 0 → -8           -33, 0 → -13          -40, 0 → -22      before (4)
///           Of 40 ensembles of 12 maps of 64 × 64 points, isotropic, with a known mean, exponential and
///           Gaussian of length 4, (4) makes Sal -4.4 → -2.8 and -2.7 → -1.6 %, Str -10 → -7 and -6 → -3 %,
///           gamma 10 → 7 and 6 → 3 %.
///           Of 60 ensembles of 12 maps of twelve sizes and outlines from 48 × 48 to 96 × 96, estimated
///           correlation, exponential and Gaussian of 8 at 10 %: Sq -0.2, 98 and -0.2, 97; Sk -0.2, 98 and
///           -0.2, 100; Sku 0.1, 92 and -0.1, 95; Sdq 0.0, 98 and -0.1, 100; Sal -2.7 and -2.0 after (4).
///           Where every second has twice the spacing and half the points along a side, lengths of 12: Sq
///           -0.5, 97 and -0.5, 92; Sk -0.5, 100 and -0.2, 92; Sku 0.0, 95 and -0.7, 87; Sal -3.8 and -2.8.
/// Memory    500 heights a map, and 40 tables of lags to twice those about the ACF's central lobe.
///
/// M. H. Quenouille, Biometrika 43 (1956) 353-360; J. W. Tukey, Ann. Math. Statist. 29 (1958) 614.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "stats/measure.hpp"
#include "stats/measure/acf_estimate.hpp"
#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"

namespace asperity {

/// What maps add up to.
class MapSums {
 public:
  /// Of one map. `rows`, its parameters, give the means of derivatives.
  MapSums(const Moments& moments, const Grid& grid, double taken, const Parameters& rows = {});
  void set_heights(const MaterialRatioCurve& curve, double mean);
  /// R + B b at all lags of the estimate.
  LagField acf(const AcfEstimate& estimate) const;
  /// At lags about the lobe above this level.
  void set_acf(const AcfEstimate& estimate, double level);
  void operator+=(const MapSums& more);

 private:
  friend class PooledMaps;
  void weigh(double weight);
  /// The ACF at the lags of a coarser spacing, and no derivatives.
  void take_spacing(const Grid& coarser);
  Field heights() const;
  double weight_of_map() const { return weight_ / static_cast<double>(weights_.size()); }

  double weight_ = 1;
  Grid grid_;                           ///< its spacing
  Eigen::Array<double, 5, 1> sums_;     // of |z|, z², z³, z⁴, B
  std::map<std::string, double> rows_;  // of derivatives, and Sdq²
  std::vector<double> heights_ = {};    // about the mean, as many of each map
  std::vector<double> weights_ = {1};   // of each
  std::optional<LagField> acf_ = {};    // Σ R + B b
};

/// The share of the variance of the heights that their form, or mean, took.
double taken_from(const Surface& surface, const AcfEstimate& estimate, const Moments& moments, int threads);

/// Of one map and its parameters, for the groups asked for.
MapSums map_sums(const Sample& sample, const Parameters& rows, const MeasureOptions& asked);

struct PooledOptions {
  std::vector<double> quantiles = {};
  std::array<double, 2> material_ratios{0.1, 0.8};
  std::vector<MaterialHeight> material_heights = {};
  /// Lengths of the pooled correlation, on a grid of its lags.
  std::function<Parameters(const LagField& rho, const Grid& grid)> of_acf = {};
};

class PooledMaps {
 public:
  static constexpr int most_degrees = 39;  ///< of freedom of the errors

  void add(MapSums map, double weight = 1);
  int maps() const { return maps_; }
  bool one_spacing() const { return one_spacing_; }
  const Grid& grid() const { return grid_; }  ///< of the coarsest spacing
  /// Values and errors (3) of all that is pooled.
  Parameters all(const PooledOptions& options) const;

 private:
  static Parameters evaluated(const MapSums& of, const PooledOptions& options);

  std::vector<MapSums> groups_ = {};
  int maps_ = 0;
  Grid grid_ = {};
  bool one_spacing_ = true;
};

}  // namespace asperity
