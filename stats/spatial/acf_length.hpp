/// Correlation lengths: where a profile of the autocorrelation first falls to a level.
///
/// Between the samples p and p+1 that enclose the level t, ln ρ is taken to be linear,
///     λ = p + ln(ρ_p / t) / ln(ρ_p / ρ_{p+1}),                                                     (1)
/// exact for an exponential. Noise about a ρ that is zero, or has no logarithm, must not move λ by most of a sample: λ is no
/// less than that of a straight line to ½ρ_{p+1}, or to ρ_{p+1} where that is negative. Between any two values, at the
/// fraction s of the way from the larger, that is
///     ρ = max(ρ_p^{1-s} ρ_{p+1}^s, (1-s) ρ_p + ½ s ρ_{p+1}),     linear unless both are positive.      (2)
/// (2) rises with either value, and so do λ and all that rests on it: a band about ρ has its lengths in order.
///
/// Symbols   λ  length [samples]      t  level of ρ = R/R(0,0), 0.1 or 1/e, say      ρ' slope per sample
/// Accuracy  Of the interpolation, where ρ falls to no less than 0.47 of itself in a sample: |error| ≤ max|(ln ρ)''| /
///           (8 |(ln ρ)'|) samples, none for an exponential and 1/(8λ) for a Gaussian ρ. (Were ρ itself taken linear,
///           ln(1/t)/(8λ) and about as much.)
///           Of the estimate: SE[λ] = SE[ρ(λ)] / |ρ'(λ)| (stats/uncertainty/acf_error.hpp), usually far larger.
///
/// In a direction θ the profile is sampled where the ray crosses the rows of lags, or the columns when it
/// leans that way, from the two lags beside it, again linear in ln ρ. That adds |error| ≤ h²/(8λ) for a ρ
/// whose ln is -r or -r², h the larger spacing. The shortest and the longest over all directions:
/// stats/spatial/acf_lobe.hpp.
#pragma once

#include <optional>

#include "core/field.hpp"
#include "stats/spatial/lag_field.hpp"

namespace asperity {

struct Crossing {
  double lag = 0;    ///< λ [samples; in a direction m]
  double slope = 0;  ///< dρ/dλ there [per sample; in a direction per m], negative
};

/// (1) with p = 0: above > level ≥ below.
Crossing crossing_between(double above, double below, double level);

/// The first crossing of `level`, 0 < level < 1, by a profile that begins with ρ(0) = 1; nothing where the
/// profile stays above it, or is not known on its way there.
std::optional<Crossing> first_crossing(const Eigen::ArrayXd& profile, double level);

/// The same in a direction, an angle from +x towards +y [rad], of a normalised ρ.
std::optional<Crossing> first_crossing(const LagField& rho, const Grid& grid, double angle, double level);

/// Whose error is that of a length: the lag nearest to its end, not lag zero, which has none.
Shape nearest_lag(const Grid& grid, double angle, double length);

}  // namespace asperity
