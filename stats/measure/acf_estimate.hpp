/// An estimated autocorrelation with its standard errors, and the correlation lengths found from it.
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

  /// Of ρ(p,q), or of R(p,q)/R(0,0) if `absolute`; NaN if too few heights are independent.
  double standard_error(Index p, Index q, bool absolute) const;
  /// Of a length in a direction, from the slope of ρ there and the error of ρ at the nearest lag.
  double length_error(double angle, double length, double slope) const;
};

/// A level of the ACF, and the tag in the names of its lengths: length_10_x for 10 %, length_e_x for 1/e.
struct AcfLevel {
  double value;
  std::string tag, text;
};

/// At each level: lengths along x, y and a direction [rad], the ratio of the first two, and the ellipse of
/// the contour. Those of a target are named target_… and have no errors. Lengths beyond the lags are left
/// out.
Parameters acf_lengths(const AcfEstimate& estimate, const std::vector<AcfLevel>& levels,
                       const std::optional<double>& direction, const std::optional<LagField>& target);

}  // namespace asperity
