/// An estimated autocorrelation with its errors, and the lengths that are read off it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/surface.hpp"
#include "stats/spatial/acf.hpp"
#include "stats/uncertainty/acf_error.hpp"
#include "stats/uncertainty/length_interval.hpp"

namespace asperity {

struct AcfEstimate {
  LagField rho;     ///< normalised
  double variance;  ///< R(0,0)
  ErrorBasis basis;
  AcfError error;
  LengthIntervals lengths;
  EffectiveSampleSize size;
  bool biased;

  AcfEstimate(const LagField& acf, const ErrorBasis& basis, bool biased = false);
  /// Of a prepared surface.
  static AcfEstimate of(const Surface& surface, const AcfParameters& parameters);

  /// Of ρ(p,q), or of R(p,q)/R(0,0) as `absolute`; NaN of too few independent heights.
  double standard_error(Index p, Index q, bool absolute) const;
  /// Of a length in a direction, at which ρ has this slope, from that of ρ at the nearest lag.
  double length_error(double angle, double length, double slope) const;
};

/// A level to which the ACF falls, and how its lengths are named: length_10_x for 10 %, length_e_x for 1/e.
struct AcfLevel {
  double value;
  std::string tag, text;
};

/// Lengths along x and y, and in a direction [rad], their ratio, and the ellipse of the contour at each
/// level; of a target too, named target_…, without errors. What the lags do not reach is left out.
Parameters acf_lengths(const AcfEstimate& estimate, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction, const std::optional<LagField>& target);

}  // namespace asperity
