/// The moments of a surface from one pass over its rows, and the map that gives it a prescribed rms.
///
/// The moments of rows are combined by
///     S ← S + S_row + (z̄_row - z̄)² n m/(n + m),    z̄ ← z̄ + (z̄_row - z̄) m/(n + m),                  (1)
/// S the sum of squares about the mean z̄ of n heights, m those of the row: without cancellation, and the
/// same however many rows come at a time.
///
/// T. F. Chan, G. H. Golub, R. J. LeVeque, Algorithms for computing the sample variance, Am. Stat. 37 (1983)
/// 242-247.
#pragma once

#include <limits>

#include "core/field.hpp"

namespace asperity {

/// z → (z - mean) · factor. Rounding keeps the order of heights, so that extremes become extremes.
struct Rescaling {
  double mean = 0, factor = 1;

  double operator()(double z) const { return (z - mean) * factor; }
  void apply(Eigen::Ref<Field> heights) const { heights = (heights - mean) * factor; }
};

class RunningMoments {
 public:
  void add(const Eigen::Ref<const Field>& rows);
  /// As if every height had been rescaled, which takes a positive factor.
  void rescale(const Rescaling& map);

  double mean() const { return mean_; }
  double rms() const;  ///< about the mean
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double count_ = 0, mean_ = 0, squares_ = 0;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

/// To mean zero and the root mean square `rms`. Throws ParameterError("exact-rq") when all heights are equal,
/// or so small or large that their squares are no numbers.
Rescaling exact_rms(const RunningMoments& moments, double rms);

}  // namespace asperity
