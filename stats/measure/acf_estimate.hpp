/// An estimated autocorrelation, the correlation lengths found from it, and their errors, from the field's
/// own long waves (stats/uncertainty/lag_waves.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"
#include "stats/measure/surface.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/lag_waves.hpp"
#include "stats/uncertainty/length_interval.hpp"

namespace asperity {

struct AcfEstimate {
  LagField rho;     ///< normalised
  double variance;  ///< R(0,0)
  ErrorBasis basis;
  EffectiveSampleSize size;
  bool biased;

  AcfEstimate(const LagField& acf, const ErrorBasis& basis, bool biased = false);
  /// Of a prepared surface.
  static AcfEstimate of(const Surface& surface, const AcfParameters& parameters);
  /// At lags up to half the field.
  static AcfEstimate of(const Sample& sample);

  const Grid& grid() const { return basis.pairs.grid(); }
};

/// Lags at which the upper end of an interval is looked for: two and a half times as far as ρ exceeds the
/// level, on an ellipse.
Shape lags_about(const LagField& rho, const Grid& grid, double level);

/// Standard errors of R(p,0) or R(0,q), a row each lag; NaN if too few heights are independent.
struct ProfileErrors {
  Eigen::ArrayXd acf;        ///< of ρ, or of R if asked for
  Eigen::ArrayXd structure;  ///< of the structure function
  double quantile;           ///< half the 95 % interval in errors
  Eigen::ArrayXd bias;       ///< that the form leaves, in ρ or R

  /// Of the value at a lag, corrected for the bias.
  Interval interval(double value, Index lag) const {
    const double freed = value - bias(lag), half = quantile * acf(lag);
    if (std::isnan(half)) return {};
    return Interval::of(value, std::min(value, freed - half), std::max(value, freed + half));
  }
};
/// `heights`, here and below: those that the estimate is of, prepared. About another level errors are wrong.
ProfileErrors profile_errors(const AcfEstimate& estimate, const Field& heights, bool along_x, bool absolute,
                             int threads = 1);

/// Standard errors of ρ, or of R, at all lags; NaN if too few heights are independent.
LagField acf_errors(const AcfEstimate& estimate, const Field& heights, bool absolute, int threads = 1);

/// Errors of what is found from the lags where ρ exceeds a level.
class LengthErrors {
 public:
  /// Of the prepared heights that the estimate is of.
  LengthErrors(const AcfEstimate& estimate, const Field& heights, double least_level, int threads = 1);

  /// A length in a direction; without an error, as all others, if a mode on both sides leaves ρ without it.
  Estimate along(double angle, double level, double length) const;
  Estimate r_min(double level, const Reach& reach) const;  ///< Sal
  Estimate r_max(double level, const Reach& reach) const;  ///< the slowest decay
  /// A ratio of lengths between these bounds. Its interval is about that of ρ' = (ρ + b)/(1 + b)
  /// (stats/uncertainty/length_interval.hpp), less the bias, and holds the value; no error where ρ' has none.
  Estimate ratio(double value, const AcfDeviations::Figure& figure, double least, double most) const;
  /// A direction, found among some that are `resolution` apart [rad]; without an error unless the interval of
  /// the aspect ratio of the contour excludes 1.
  Estimate axis(double angle, const AcfDeviations::Figure& figure, const Estimate& aspect,
                double resolution = 0) const;

 private:
  using Extreme = std::optional<Reach> CentralLobe::*;
  Estimate length(double found, const AcfDeviations::Figure& figure, const Interval& interval) const;
  Estimate extreme(double level, const Reach& reach, Extreme which, const Interval& interval) const;

  Grid grid_;
  int threads_;
  AcfDeviations deviations_;
  LagField rho_;
  LengthIntervals intervals_;
};

/// A level of the ACF, and the tag in the names of its lengths: length_10_x for 10 %, length_e_x for 1/e.
struct AcfLevel {
  double value;
  std::string tag, text;
};

/// At each level: lengths along x, y and a direction [rad], the ratio of the first two, and the ellipse of
/// the contour, with errors if they are given. Those of a target are named target_… and have no errors.
/// Lengths beyond the lags are left out.
Parameters acf_lengths(const AcfEstimate& estimate, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction, const std::optional<LagField>& target,
                       const std::optional<LengthErrors>& errors);
/// Those of any normalised ρ, without errors.
Parameters acf_lengths(const LagField& rho, const Grid& grid, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction);
/// Sal, Str, the slowest decay, the ellipse and their directions, at this level, without errors.
Parameters lobe_lengths(const LagField& rho, const Grid& grid, double level);

}  // namespace asperity
