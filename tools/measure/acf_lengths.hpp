/// An estimated autocorrelation with its errors, and the lengths that are read off it.
#pragma once

#include <string>
#include <vector>

#include "stats/uncertainty/acf_error.hpp"
#include "stats/uncertainty/effective_size.hpp"
#include "stats/uncertainty/length_interval.hpp"
#include "tools/cli/table.hpp"
#include "tools/measure/measured.hpp"

namespace asperity::cli {

/// The estimate, normalised, and its errors.
struct AcfEstimate {
  LagField rho;
  AcfError error;
  double variance;  ///< R(0,0)
  Pairs pairs;
  bool biased;
  LengthIntervals lengths;
  EffectiveSampleSize size;

  static AcfEstimate of(const Measured& measured, const AcfParameters& parameters);
  /// Of ρ(p,q), or of R(p,q)/R(0,0) as `absolute`; NaN of too few independent heights.
  double standard_error(Index p, Index q, bool absolute) const;
};

/// A level to which the ACF falls, and how its lengths are named: length_10_x for 10 %, length_e_x for 1/e.
struct AcfLevel {
  double value;
  std::string tag, text;
};
/// "0.1,1/e"; throws ParameterError("acf-level", …) unless each is between 0 and 1.
std::vector<AcfLevel> acf_levels(const std::string& list);

struct LengthsRequest {
  std::string levels = "0.1,1/e", direction;
};

/// Along x and y, in the direction asked for, their ratio, and the ellipse of the contour; of the target too
/// where the dataset carries one. Warns of levels that the lags do not reach, of lengths below a sample or beyond half
/// the field, and of few independent heights.
Quantities lengths_of(const Tool& tool, const Measured& measured, const AcfEstimate& estimate,
                      const LengthsRequest& request);

}  // namespace asperity::cli
