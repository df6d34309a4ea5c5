/// Mean, spread and standard error of quantities over the realisations of an ensemble, added one by one.
///
/// By Welford's recurrence over the realisations m = 1, 2, …, for each quantity
///     δ = x_m - mean,   mean += δ/m,   squares += δ (x_m - mean),                                   (1)
///     spread = √(squares/(m - 1)),   standard error = spread/√m.                                    (2)
/// Realisations are independent even if the heights of each are correlated, so that (2) needs no effective
/// size. A value that is not finite is left out.
///
/// Accuracy  relative to the spread, independent of the offset. The standard error has a relative error of
///           1/√(2(m-1)).
///
/// B. P. Welford, Technometrics 4 (1962) 419-420.
#pragma once

#include <Eigen/Core>

namespace asperity {

class Ensemble {
 public:
  /// One realisation; throws DataError("ensemble", …) if it has another number of quantities.
  void add(const Eigen::ArrayXd& values);

  const Eigen::ArrayXd& count() const { return count_; }  ///< realisations with a finite value
  Eigen::ArrayXd mean() const;                            ///< NaN without a value
  Eigen::ArrayXd spread() const;                          ///< standard deviation; NaN for fewer than two
  Eigen::ArrayXd standard_error() const { return spread() / count_.sqrt(); }

 private:
  Eigen::ArrayXd count_, mean_, squares_;
};

}  // namespace asperity
