/// Correlation lengths: where a profile of the autocorrelation first falls to a level.
///
/// Between the samples p and p+1 that enclose the level t, ln ρ is taken to be linear,
///     λ = p + ln(ρ_p / t) / ln(ρ_p / ρ_{p+1}),                                                     (1)
/// exact for an exponential; where ρ_{p+1} ≤ 0 has no logarithm, ρ itself is linear.
///
/// Symbols   λ  length [samples]      t  level of ρ = R/R(0,0), 0.1 or 1/e, say      ρ' slope per sample
/// Accuracy  Of the interpolation: |error| ≤ max|(ln ρ)''| / (8 |(ln ρ)'|) samples, none for an exponential
///           and 1/(8λ) for a Gaussian ρ. (Were ρ itself taken linear, ln(1/t)/(8λ) and about as much.)
///           Of the estimate: SE[λ] = SE[ρ(λ)] / |ρ'(λ)| (stats/acf_error.hpp), usually far larger.
///
/// Sal of ISO 25178-2 is the shortest such length over all directions, for t = 0.2.
#pragma once

#include <optional>

#include "grid/field.hpp"

namespace asperity {

struct Crossing {
  double lag = 0;    ///< λ [samples]
  double slope = 0;  ///< dρ/dp there [per sample], negative
};

/// The first crossing of `level`, 0 < level < 1, by a profile that begins with ρ(0) = 1; nothing where the
/// profile stays above it.
std::optional<Crossing> first_crossing(const Eigen::ArrayXd& profile, double level);

}  // namespace asperity
