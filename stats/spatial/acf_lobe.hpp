/// The central lobe of an autocorrelation: Sal and Str of ISO 25178-2, ellipticity and its angle.
///
/// The lobe is the connected region about lag zero where ρ > s; lags are connected to their four neighbours.
/// Its contour is taken at the crossings of ρ = s with the lines between neighbouring lags, in each of which
/// ln ρ is linear (stats/spatial/acf_length.hpp). Of these contour points
///     Sal = r_min, the nearest to lag zero: the autocorrelation length of the fastest decay,          (1)
///     Str = r_min / r_max, the nearest over the farthest: the texture aspect ratio, 0 < Str ≤ 1,       (2)
/// both at s = 0.2 unless said otherwise, and the ellipse
///     A x² + 2B xy + C y² = 1                                                                         (3)
/// that fits them best in least squares has the half axes μ^{-1/2}, μ the eigenvalues of [A B; B C]: the
/// lengths along and across the texture. γ is their ratio, ≥ 1, and its angle that of the long axis.
///
/// Symbols   ρ  correlation, ρ(0,0) = 1      s  level      x, y  lags [m]
///           angles from +x towards +y [rad]
/// Scope     A lobe that reaches the longest lags, or lags without a pair of points, has no r_max, and no Str; it
///           needs longer lags or a larger field.
/// Accuracy  For a ρ that is exp(-r) or exp(-r²) of one elliptic radius r, h the larger spacing: Sal within
///           3h²/(8 r_min), r_max within 3h² r_max/(8 r_min²), the ellipse's axes within a third of these.
///           The sampling error of a length is SE[ρ]/|dρ/dr| in its direction (stats/uncertainty/acf_error.hpp), usually
///           far larger; being the least of many lengths, Sal of an estimate is also biased low.
/// Cost      the lags of the lobe.
#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

struct Reach {
  double length = 0;  ///< [m]
  double angle = 0;   ///< [rad], in (-π/2, π/2]
};

struct LobeEllipse {
  Reach major;       ///< the longer half axis
  double minor = 0;  ///< the shorter one, at right angles [m]

  double gamma() const { return major.length / minor; }
};

struct CentralLobe {
  std::optional<Reach> r_min;          ///< (1); none when the lags end before
  std::optional<Reach> r_max;          ///< none when the lobe reaches the longest lags
  std::optional<LobeEllipse> ellipse;  ///< (3); none when the lobe is open, or no ellipse

  /// (2).
  std::optional<double> aspect_ratio() const {
    return r_min && r_max ? std::optional(r_min->length / r_max->length) : std::nullopt;
  }
};

/// Of a normalised ρ. Throws ParameterError("acf-level", …) unless 0 < level < 1.
CentralLobe central_lobe(const LagField& rho, const Grid& grid, double level = 0.2);

}  // namespace asperity
