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
/// Accuracy  as in long_waves.hpp; validation/error_coverage.
/// Cost      one pass, 80 operations a point; another one for quantiles, of some 30.
///
/// R. S. Woodruff, Confidence intervals for medians and other position measures,
/// J. Am. Stat. Assoc. 47 (1952) 635-646.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "stats/sample/moments.hpp"
#include "stats/uncertainty/long_waves.hpp"
#include "stats/uncertainty/share_error.hpp"

namespace asperity {

class HeightErrors {
 public:
  using Function = std::function<double(const Moments&)>;

  /// Of a field with this mean and rms height.
  HeightErrors(const Grid& grid, double mean, double sq);
  /// The next rows of the field.
  void add(const Field& rows, int threads = 1);
  /// Adds no more.
  void finish(const FieldExtent& extent) { means_ = sums_.means(extent); }

  /// Of a function of mean, sa, sq, ssk and sku.
  double operator()(const Function& parameter) const;
  double degrees() const { return means_.degrees(); }  ///< of freedom

 private:
  double mean_, sq_;
  LocalSums sums_;
  LocalMeans means_ = {};
};

/// Part of the rms height that subtracting a mean of this error leaves; √½ at least.
inline double left_by_mean(double error_of_mean, double sq) {
  return std::sqrt(std::max(0.5, 1 - std::pow(error_of_mean / sq, 2)));
}

/// Standard errors of the shares of a field below some heights, and of these heights.
class QuantileErrors {
 public:
  QuantileErrors(const Grid& grid, const FieldExtent& extent, std::vector<double> heights);
  void add(const Field& rows, int = 1);
  /// Adds no more.
  void finish() { errors_.accumulate(); }

  /// Of the share below height k.
  double operator()(std::size_t k) const { return with_mean(k, 0); }
  /// Of that share plus `density` times the mean of the field.
  double with_mean(std::size_t k, double density) const;
  /// Part of the rms height that the field's own mean leaves.
  double left_by_mean() const;
  double degrees() const { return errors_.degrees(); }  ///< of freedom

 private:
  std::vector<double> heights_, ascending_;
  ShareErrors errors_;
};

}  // namespace asperity
