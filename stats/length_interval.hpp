/// Confidence intervals of correlation lengths.
///
/// A length is where an estimate of the correlation falls to a level t (stats/acf_length.hpp). Over the lags about it the
/// estimate strays by nearly the same, SE of them (stats/acf_error.hpp), and all of it lies low, for the field's own
/// mean is taken from the heights. Put back,
///     ρ' = (ρ + b)/(1 + b),   b = S_1/(N - S_1),                                                       (1)
/// and the interval at the level 1 - 2a goes from where ρ' falls to t + u SE to where it falls to t - u SE,
///     λ(ρ', t + u SE) … λ(ρ', t - u SE),                                                              (2)
/// without an end where ρ' does not fall so far: symmetric about λ only where ρ is straight, and as far as SE is small.
///
/// Sal is the least of the lengths in all directions, and the least of many that stray is low. Its interval is (2) with
/// Sal for λ, but above with a larger u: the quantile of the largest of Gaussians that are correlated as the errors of ρ
/// are (stats/acf_error.hpp, (3)) in those of 12 directions in which λ is within twice (2), simulated with a fixed seed. From
/// below Sal is hardly ever missed; a fifth of 2a is left for that, four fifths for the upper end.
///
/// Of a known correlation u is the normal quantile. An estimated one is cut where noise begins, so that its SE, of squares
/// of the lags, is √(S_2'/S_2) too small, S_2' with the tail (stats/effective_size.hpp); u is Student's of its degrees.
///
/// Symbols   ρ  estimate, 1 at lag zero      N  points      S_k  sums over the correlation      SE  of ρ where it is t
/// Scope     Gaussian heights.
/// Accuracy  95 % intervals cover, of lengths along an axis at 1/e and 10 %, 92 to 98 % from N/S_2 = 468 on, and 94 to all
///           at 153; of Sal 92 to 98 %, but at 153 90 % with a known correlation (1000 fields a row,
///           validation/statistics_coverage).
/// Cost      one Bartlett sum a length; of Sal up to 180, and a simulation of 8192 draws, 5 ms.
#pragma once

#include <optional>
#include <vector>

#include "grid/field.hpp"
#include "stats/acf_error.hpp"
#include "stats/effective_size.hpp"
#include "stats/lag_field.hpp"
#include "stats/moment_interval.hpp"

namespace asperity {

class LengthIntervals {
 public:
  /// `known` is the correlation that errors rest on, if it is known.
  LengthIntervals(const LagField& estimate, const Pairs& pairs, const std::optional<LagField>& known);

  /// (2) in a direction, an angle from +x towards +y [rad], in metres; NaN for an end that there is not.
  Interval along(double angle, double level, double confidence = 0.95) const;
  /// (2) of Sal.
  Interval fastest(double level, double confidence = 0.95) const;

 private:
  /// A quantile of the normal law, or of Student's.
  double quantile(double tail) const;
  /// SE at the lag nearest to a length in a direction.
  double error_at(double angle, double length) const;
  /// Sal of ρ'.
  double fastest_at(double level) const;
  /// The lags where ρ' falls to a level within a length, of those in 12 directions.
  std::vector<Shape> lags_within(double level, double length) const;

  LagField rho_, freed_;  ///< ρ, ρ'
  Grid grid_;
  AcfError error_;
  double inflation_ = 1, degrees_;
};

}  // namespace asperity
