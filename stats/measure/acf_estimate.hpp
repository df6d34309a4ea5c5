/// An estimated autocorrelation, the correlation lengths found from it, and their errors, from the field's
/// own long waves (stats/uncertainty/lag_waves.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"
#include "stats/measure/surface.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/spatial/acf_length.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stats/uncertainty/acf_deviations.hpp"
#include "stats/uncertainty/lag_waves.hpp"

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

  /// Of the structure function, which is positive.
  Interval structure_interval(double value, Index lag) const {
    if (!(value > 0)) return Interval::about(value, structure(lag));
    return Interval::of_ratio(value, quantile * structure(lag) / value);
  }
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

/// The central lobe of a correlation at a level, with errors where they are known. Intervals are about the
/// figures of ρ' = (ρ + b)/(1 + b), which the field's own mean and form do not lower
/// (stats/uncertainty/effective_size.hpp), less their bias, and hold the values.
///
/// A direction has a value only where one is preferred: where by chance the anisotropy of the contour is
/// exceeded in less than 5 % of isotropic fields (stats/uncertainty/acf_deviations.hpp (4)), and the spectrum
/// does not show two lays (stats/spectrum/spectrum.hpp). These have two directions and a cross for a contour:
/// of it Sal alone has an error. Where no direction is preferred the contour may be a circle: intervals of
/// Sal and the slowest decay reach to that of its radius, those of Str and gamma to 1; errors are a circle's.
///
/// Accuracy  stated over true error and coverage of the 95 % intervals, the least and the most of eleven
///           textures (validation/error_coverage), at N_eff 290 to 1230 and at 33 to 140: of Sal
///           0.88 to 1.07, 90 to 100 % and 0.76 to 1.23, 90 to 100 %; of lengths at 1/e
///           0.96 to 1.08, 88 to 96 % and 0.87 to 1.37, 83 to 98 %; at 10 %
///           0.86 to 1.18, 88 to 97 % and 0.93 to 1.54, 86 to 99 %.
struct LobeEstimates {
  std::optional<Estimate> r_min = {}, r_max = {}, aspect_ratio = {}, gamma = {};
  std::optional<Estimate> r_min_axis = {}, r_max_axis = {}, gamma_axis = {};
  std::optional<Estimate> texture = {};  ///< Std
};
/// Without errors.
LobeEstimates lobe_estimates(const LagField& rho, const Grid& grid, double level);

/// Errors of what is found from the lags where ρ exceeds a level.
class LengthErrors {
 public:
  /// Of the prepared heights that the estimate is of.
  LengthErrors(const AcfEstimate& estimate, const Field& heights, double least_level, int threads = 1);

  LobeEstimates lobe(double level) const;
  const TextureDirection& texture() const { return texture_; }
  /// A length in a direction; without an error, as all others, if a mode on both sides leaves ρ' without it.
  Estimate along(double angle, double level, double length) const;
  /// Any positive figure of ρ, NaN, 0 or infinite as in AcfDeviations::Figures, between these bounds.
  using Figure = std::function<double(const LagField& rho)>;
  Estimate figure(double value, const Figure& of, double least, double most) const;

 private:
  Grid grid_;
  int threads_;
  AcfDeviations deviations_;
  LagField rho_, freed_;  ///< ρ'
  TextureDirection texture_;
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
