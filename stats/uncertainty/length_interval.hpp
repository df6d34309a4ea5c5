/// Confidence intervals of correlation lengths.
///
/// A length is the lag at which the estimated correlation falls to a level t (stats/spatial/acf_length.hpp).
/// At lag h the estimate has the standard error SE(h) (stats/uncertainty/acf_error.hpp), and it is low
/// because the field's own mean is subtracted. With the correction ρ' = (ρ + b)/(1 + b)
/// (stats/uncertainty/effective_size.hpp) the interval at the level 1 - 2a is
///     λ(ρ' - u SE) … λ(ρ' + u SE),                                                                     (1)
/// open above if the upper band does not fall to t. λ rises with ρ, so that the ends are in order; they
/// enclose λ(ρ) unless b exceeds the error u SE/(1 - t).
///
/// Sal is the least of the lengths in all directions, and the least of many estimates is biased low. Its
/// interval is (1) with Sal for λ, but for the upper end u is the quantile of the largest of Gaussians with
/// the correlations of the errors of ρ, in those of 12 directions whose λ(ρ') lies within the interval. The
/// lower end hardly ever fails, so that the upper end has the whole probability 2a. The slowest decay is the
/// greatest of the lengths; its interval is the mirror image.
///
/// For a known correlation the errors are smaller by the factor √(1 - S_1²/(N S_2)), because the field's mean
/// removes S_1²/N from the squares. An estimate already lacks that part, but it is cut where noise begins:
/// its errors are larger by the factor ⁴√(S_2'/S_2), S_2' with the tail, an empirical half of the loss in the
/// sum of squares. The upper end of Sal uses Student's quantile for their degrees of freedom.
///
/// Symbols   ρ  estimate, 1 at lag zero    N  points    S_k  sums over the correlation    λ(f)  where f = t
/// Scope     Gaussian heights.
/// Accuracy  95 % intervals cover, of 2000 fields a row (validation/statistics_coverage): Sal and lengths
///           along an axis at 1/e and 10 % 93.6 to 97.0 % with a known correlation and 93.9 to 97.2 % with an
///           estimated one, down to N/S_2 = 41, except 97.7 % for the length at 1/e there.
/// Cost      one autocorrelation of ρ; a pass over the lags per end; for Sal one to four simulations, 5 ms
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
  /// `known` is the correlation that errors rest on; none if it is estimated.
  LengthIntervals(const LagField& estimate, const Pairs& pairs, const std::optional<LagField>& known);

  /// (1) in a direction, an angle from +x towards +y [rad], in metres; open above if it exceeds the lags.
  Interval along(double angle, double level, double confidence = 0.95) const;
  Interval r_min(double level, double confidence = 0.95) const;  ///< of Sal
  Interval r_max(double level, double confidence = 0.95) const;  ///< of the slowest decay

 private:
  LengthIntervals(const LagField& rho, const LagField& admitted, const Pairs& pairs,
                  const std::optional<LagField>& known);
  /// ρ' + u SE at all lags.
  LagField band(double u) const;
  /// Sal or the slowest decay for this ρ; infinite if it exceeds the lags.
  enum class Decay { r_min, r_max };
  double length_of(Decay decay, const LagField& rho, double level) const;
  /// The lag at which ρ' falls to a level in one of 12 directions.
  struct Reached {
    Shape lag;
    double length;
  };
  /// The quantile of the largest deviation among these.
  double quantile_of_extreme(const std::vector<Reached>& reached, double tail) const;
  /// The end of (1) that depends on many directions: the upper end of the fastest, the lower of the slowest
  /// decay.
  double strayed(Decay decay, double level, double tail) const;

  LagField rho_;
  Grid grid_;
  EffectiveSampleSize size_;
  AcfError error_;
  LagField freed_, strays_;  ///< ρ', SE
};

}  // namespace asperity
