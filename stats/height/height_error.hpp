/// Standard errors of height parameters, whatever the distribution of the heights and their correlation.
///
/// Powers of the heights are local functions: their means have the errors of
/// stats/uncertainty/long_waves.hpp, and the moments are functions of these means. The share of heights
/// below q is the mean of one more. A quantile of heights above the field's own mean moves with that mean,
/// by the density φ at q: with the error e of the share, the field's own quantiles q(s), and the error e' of
/// the mean of [1 if z ≤ q] + φ z, it has the error e'/φ, and Woodruff's interval, Student's t,
///     q(s - t e) … q(s + t e),                                                                          (1)
/// wider by the factor e'/e on both sides, and open where s ± t e is no share. Subtracting the field's own
/// mean lowers all heights to √(1 - Var[z̄]/σ²), which intervals of Sq, Sa and quantiles allow for.
///
/// Above a form of degree d (stats/filter/form.hpp) the heights themselves lack the long waves, the modes
/// P_a P_b that it took. The m = 2d + 5 modes ψ of the next two degrees, orthonormal over the measured points
/// to each other and to the form (stats/filter/axis_products.hpp), have the mean power
///     P = 1/N mean (Σ ψ z)²/Sq²,                                                                      (2)
/// of which the error of the mean is Sq √P/(1 - L), L = (1.2 + d)/√N_eff, and the form has taken
///     b/(1 + b),     b = M P/(1 - L)²,     L = (1.2 + 0.35 d)/√N_eff,     M = (d+1)(d+2)/2            (3)
/// of the variance, known to √(2/m); L, 0.4 at most, is about three quarters of what an exponential
/// correlation loses to the next modes. Without a form the share is (error of the mean)²/Sq².
///
/// Accuracy  docs/accuracy/asperity-stats.md
/// Cost      one pass, 80 operations a point; another one for quantiles, of some 30.
///
/// R. S. Woodruff, Confidence intervals for medians and other position measures,
/// J. Am. Stat. Assoc. 47 (1952) 635-646.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "stats/filter/form.hpp"
#include "stats/sample/moments.hpp"
#include "stats/uncertainty/long_waves.hpp"
#include "stats/uncertainty/share_error.hpp"

namespace asperity {

class HeightErrors {
 public:
  using Function = std::function<double(const Moments&)>;

  /// Of a field of these moments, measured from a form of this degree.
  HeightErrors(const Field& z, const Grid& grid, const FieldExtent& extent, const Moments& moments,
               int degree = 0, int threads = 1);

  /// Of a function of sa, sq, ssk and sku, and of the mean above a mean.
  WaveError operator()(const Function& parameter) const;
  WaveError of_mean() const;
  /// The share of the variance that the form took, (3), and its error.
  double taken() const;
  double error_of_taken() const;

 private:
  void find_power(const Field& x, double points);
  double loss(double factor) const;  // L

  double mean_, sq_;
  int degree_;
  double patches_;
  Index taken_ = 0, next_ = 0;  // modes of the form, and beyond it
  double power_ = NAN;          // P
  LocalMeans means_ = {};
};

/// Standard errors of the shares of a field below some heights, and of these heights.
class QuantileErrors {
 public:
  QuantileErrors(const Field& z, const Grid& grid, const FieldExtent& extent, std::vector<double> heights);

  /// Of the share below height k.
  WaveError operator()(std::size_t k) const { return with_mean(k, 0); }
  /// Of that share plus `density` times the mean of the field.
  WaveError with_mean(std::size_t k, double density) const;

 private:
  std::vector<double> heights_, ascending_;
  ShareErrors errors_;
};

}  // namespace asperity
