/// Mean, spread and standard error over the realisations of an ensemble, which come one by one.
///
/// Of each of a set of quantities, by Welford's recurrence over the realisations m = 1, 2, …,
///     δ = x_m - mean,   mean += δ/m,   squares += δ (x_m - mean),                                   (1)
///     spread = √(squares/(m - 1)),   standard error = spread/√m.                                    (2)
/// Realisations are independent, however correlated the heights of each are: (2) needs no effective size. One
/// that lacks a quantity, whose value is not finite, does not count for it.
///
/// Accuracy  relative to the spread, whatever the offset. The standard error is known to 1/√(2(m-1)) of it.
///
/// B. P. Welford, Technometrics 4 (1962) 419-420.
#pragma once

#include <Eigen/Core>

namespace asperity {

class Ensemble {
 public:
  /// Of one realisation; throws DataError("ensemble", …) when it has another number of quantities.
  void add(const Eigen::ArrayXd& values);

  const Eigen::ArrayXd& count() const { return count_; }  ///< realisations with a finite value
  Eigen::ArrayXd mean() const;                            ///< NaN of none
  Eigen::ArrayXd spread() const;                          ///< standard deviation; NaN of less than two
  Eigen::ArrayXd standard_error() const { return spread() / count_.sqrt(); }

 private:
  Eigen::ArrayXd count_, mean_, squares_;
};

}  // namespace asperity
