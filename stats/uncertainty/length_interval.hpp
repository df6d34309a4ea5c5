/// Confidence intervals of correlation lengths.
///
/// A length is where an estimate of the correlation falls to a level t (stats/spatial/acf_length.hpp). At a
/// lag h it strays by SE(h) (stats/uncertainty/acf_error.hpp), and is low by the field's own mean. With that
/// put back, ρ' = (ρ + b)/(1 + b) (stats/uncertainty/effective_size.hpp), the interval at the level 1 - 2a is
///     λ(ρ' - u SE) … λ(ρ' + u SE),                                                                     (1)
/// open above where that side of the band does not fall to t. λ rises with ρ, so that the ends are in order,
/// and about λ(ρ) but where b exceeds the error u SE/(1 - t).
///
/// Sal is the least of the lengths in all directions, and the least of many that stray is low. Its interval
/// is (1) with Sal for λ, but above u is the quantile of the largest of Gaussians that are correlated as the
/// errors of ρ are, in those of 12 directions whose λ(ρ') is within the interval that they make. From below
/// Sal is hardly ever missed: the upper end takes all of 2a. The slowest decay is the greatest of the
/// lengths, its interval the mirror image.
///
/// Of a known correlation the errors are √(1 - S_1²/(N S_2)) as large, for the field's mean takes S_1²/N from
/// the squares. An estimated one has lost that, but is cut where noise begins: its errors are taken
/// ⁴√(S_2'/S_2) as large, S_2' with the tail; that is measured, half of what the sum of squares loses. The
/// upper end of Sal, which no other makes good, has Student's quantile of their degrees.
///
/// Symbols   ρ  estimate, 1 at lag zero    N  points    S_k  sums over the correlation    λ(f)  where f is t
/// Scope     Gaussian heights.
/// Accuracy  95 % intervals cover, of 2000 fields a row (validation/statistics_coverage): Sal and lengths
///           along an axis at 1/e and 10 % 93.6 to 97.0 % of a known correlation and 93.9 to 97.2 % of an
///           estimated one, down to N/S_2 = 41, but for the length at 1/e there, 97.7 %.
/// Cost      one autocorrelation of ρ; a pass over the lags an end; of Sal one to four simulations, 5 ms
///           each.
#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/uncertainty/acf_error.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

class LengthIntervals {
 public:
  /// `known` is the correlation that errors rest on, if it is known.
  LengthIntervals(const LagField& estimate, const Pairs& pairs, const std::optional<LagField>& known);

  /// (1) in a direction, an angle from +x towards +y [rad], in metres; beyond the lags open above.
  Interval along(double angle, double level, double confidence = 0.95) const;
  Interval r_min(double level, double confidence = 0.95) const;  ///< of Sal
  Interval r_max(double level, double confidence = 0.95) const;  ///< of the slowest decay

 private:
  LengthIntervals(const LagField& rho, const LagField& admitted, const Pairs& pairs,
                  const std::optional<LagField>& known);
  /// ρ' + u SE at all lags.
  LagField band(double u) const;
  /// Sal of such a field, or its slowest decay; infinite where it lies beyond the lags.
  enum class Decay { r_min, r_max };
  double length_of(Decay decay, const LagField& rho, double level) const;
  /// Where ρ' falls to a level in each of 12 directions.
  struct Reached {
    Shape lag;
    double length;
  };
  /// The quantile of the largest stray among these.
  double quantile_of_extreme(const std::vector<Reached>& reached, double tail) const;
  /// The end of (1) that strays of many directions make: above of the fastest, below of the slowest decay.
  double strayed(Decay decay, double level, double tail) const;

  LagField rho_;
  Grid grid_;
  EffectiveSampleSize size_;
  AcfError error_;
  LagField freed_, strays_;  ///< ρ', SE
};

}  // namespace asperity
