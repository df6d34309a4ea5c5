/// The autocorrelation of a field that comes in strips, from the pairs of points within one strip.
///
///     R(p,q) = Σ_strips C(p,q) / Σ_strips n(p,q)                                                      (1)
/// with the sums over pairs C and the number of pairs n of each strip (stats/spatial/acf.hpp). It is unbiased
/// if heights are measured from the mean of the whole field, but has fewer pairs and only lags that fit a
/// strip. It serves for standard errors, which are too small if the correlation is longer than the strips.
///
/// Cost      one autocorrelation per strip; with missing heights two.
#pragma once

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

class StripAutocorrelation {
 public:
  /// Lags up to half a strip of `rows`, and half the field across.
  StripAutocorrelation(const Grid& grid, Index rows, int threads = 1);

  /// Heights above the mean of the whole field, without rows that belong to the next strip.
  void add(const Field& strip);
  /// (1).
  LagField estimate() const;
  /// The pairs of the whole field, if points are missing everywhere as they are within the strips.
  Pairs pairs() const;
  /// Whether a correlation is still above 0.1 at the longest lag that fits a strip: at least 6 % of S_2 is
  /// lost.
  bool reaches_beyond(const LagField& correlation) const;

 private:
  Grid grid_;
  Shape max_lag_;
  int threads_;
  Field sums_, counts_, complete_;  ///< C, n, and n if nothing were missing
};

}  // namespace asperity
