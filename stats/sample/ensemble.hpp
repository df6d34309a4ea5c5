/// Mean, spread and standard error of quantities over the realisations of an ensemble, added one by one.
///
/// By Welford's recurrence over the realisations m = 1, 2, …, of weights w_m and W = w_1 + … + w_m, for each
/// quantity
///     δ = x_m - mean,   mean += w_m δ/W,   squares += w_m δ (x_m - mean),                            (1)
///     spread = √(m/W squares/(m - 1)),   standard error = spread/√m.                                 (2)
/// Realisations are independent even if the heights of each are correlated, so that (2) needs no effective
/// size. A value that is not finite is left out.
///
/// Maps of one surface have variances as their areas A, to first order in correlation length over side: the
/// number of independent heights is proportional to A. With w = A the mean has the least variance, and (2) is
/// free of bias, with m - 1 degrees of freedom; spread is that of maps of mean area. Areas do not depend on
/// the heights, as an estimated number of independent heights does: a mean so weighted would be biased. The
/// variance of maps hardly larger than a correlation length does not grow as 1/A: beside larger ones they
/// would make (2) too small. Of unequal areas there is an error only where each has independent heights
/// enough.
///
/// Accuracy  relative to the spread, independent of the offset. The standard error has a relative error of
///           1/√(2(m-1)). If maps differ by more than chance, so that variances are equal and areas are not,
///           it is low by the factor √((1 - s)/((m - 1) s)), s = Σ w²/W²: 8 % for twelve areas of 1 to 4.
///
/// B. P. Welford, Technometrics 4 (1962) 419-420; D. H. D. West, Commun. ACM 22 (1979) 532-535, with weights.
#pragma once

#include <Eigen/Core>

#include "core/field.hpp"

namespace asperity {

class Ensemble {
 public:
  /// One realisation; throws DataError("ensemble", …) if it has another number of quantities.
  void add(const Eigen::ArrayXd& values, double weight = 1);

  const Eigen::ArrayXd& count() const { return count_; }  ///< realisations with a finite value
  Eigen::ArrayXd mean() const;                            ///< NaN without a value
  Eigen::ArrayXd spread() const;                          ///< standard deviation; NaN for fewer than two
  Eigen::ArrayXd standard_error() const { return spread() / count_.sqrt(); }

 private:
  Eigen::ArrayXd count_, weights_, mean_, squares_;
};

/// The weights of maps by their areas, in that of the first, so that equal maps have the weight 1 exactly.
class AreaWeights {
 public:
  /// `enough`: the map has independent heights enough for errors of its own.
  double of(double area, bool enough = true);
  int maps() const { return maps_; }
  double sum() const { return sum_; }
  double least() const { return least_ / sum_; }  ///< of the whole
  double most() const { return most_ / sum_; }
  bool differ() const { return most_ > least_; }
  bool give_errors() const { return enough_ || most_ <= alike_ * least_; }

 private:
  static constexpr double alike_ = 1.1;
  int maps_ = 0;
  bool enough_ = true;
  double first_ = 0, sum_ = 0, least_ = 0, most_ = 0;
};
/// The area of the points that are measured; of a profile too.
double measured_area(const Field& heights, const Grid& grid);

/// To six digits, for sizes may come from texts.
bool same_spacing(const Grid& one, const Grid& other);

}  // namespace asperity
