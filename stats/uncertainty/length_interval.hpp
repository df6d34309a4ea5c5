/// Confidence intervals of correlation lengths.
///
/// A length is the lag at which the estimated correlation falls to a level t (stats/spatial/acf_length.hpp).
/// At lag h the estimate has the standard error SE(h) (stats/uncertainty/acf_deviations.hpp), and it is low
/// because a form is subtracted, the field's own mean at least. With the correction ρ' = (ρ + b B)/(1 + b)
/// (stats/uncertainty/effective_size.hpp) the interval at the level 1 - 2a is
///     λ(ρ' - u SE) … λ(ρ' + u SE),                                                                     (1)
/// u Student's quantile, open above if the upper band does not fall to t. λ rises with ρ, so that the ends
/// are in order; where ρ' - ρ exceeds the error u SE, λ(ρ) is an end.
///
/// Sal is the least of the lengths in all directions, and the least of many estimates is biased low. Its
/// interval is (1) with Sal for λ, but for the upper end u is the quantile of the largest deviation, with the
/// correlations of the errors of ρ, in those of 12 directions whose λ(ρ') lies within the interval. The lower
/// end hardly ever fails, so that the upper end has the whole probability 2a. The slowest decay is the
/// greatest of the lengths; its interval is the mirror image.
///
/// SE is known to 1/√(2K) only, differently in each direction, and an extreme would choose the direction by
/// it: for Sal and the slowest decay SE² is its mean over all lags of nearly the same ρ'.
///
/// Symbols   ρ  estimate, 1 at lag zero    λ(f)  where f = t
/// Accuracy  stated over true error and coverage of the 95 % intervals, the least and the most of eleven
///           textures (validation/error_coverage), at N_eff 290 to 1230 and at 33 to 140: of Sal
///           0.88 to 1.07, 90 to 100 % and 0.76 to 1.23, 90 to 100 %; of lengths at 1/e
///           0.96 to 1.08, 88 to 96 % and 0.87 to 1.37, 83 to 98 %; at 10 %
///           0.86 to 1.18, 88 to 97 % and 0.93 to 1.54, 86 to 99 %.
/// Cost      a pass over the lags per end; for Sal one to four simulations, 5 ms each.
#pragma once

#include <vector>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/interval.hpp"

namespace asperity {

class LengthIntervals {
 public:
  /// `freed` is ρ'.
  LengthIntervals(const LagField& rho, const Grid& grid, const AcfDeviations& deviations, LagField freed);

  const LagField& freed() const { return freed_; }  ///< ρ'
  /// (1) in a direction, an angle from +x towards +y [rad], in metres; open above if it exceeds the lags.
  Interval along(double angle, double level, double confidence = 0.95) const;
  Interval r_min(double level, double confidence = 0.95) const;  ///< of Sal
  Interval r_max(double level, double confidence = 0.95) const;  ///< of the slowest decay

 private:
  /// ρ' + u SE at all lags.
  static LagField band(const LagField& freed, double u, const LagField& strays);
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
  AcfDeviations deviations_;
  LagField freed_, strays_;  ///< ρ', SE
  LagField even_;            ///< SE as a function of ρ' alone
};

}  // namespace asperity
