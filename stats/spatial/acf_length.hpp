/// Correlation lengths: the lags at which the autocorrelation falls to a level, in one or all directions (ISO
/// 25178-2).
///
/// Between the samples p and p+1 that enclose the level t, ln ρ is linear,
///     λ = p + ln(ρ_p / t) / ln(ρ_p / ρ_{p+1}),                                                     (1)
/// exact for an exponential. So that noise about ρ = 0 does not move λ by most of a sample, λ is at least
/// that of a straight line to ½ρ_{p+1}, or to ρ_{p+1} if that is negative. Between any two values, at the
/// fraction s of the way from the larger,
///     ρ = max(ρ_p^{1-s} ρ_{p+1}^s, (1-s) ρ_p + ½ s ρ_{p+1}),     linear unless both are positive.      (2)
/// (2) rises with either value, and so does λ: the lengths of a band about ρ are in order. In a direction θ
/// the profile is sampled where the ray crosses the rows of lags, or the columns if it crosses more of them,
/// by (2) from the two neighbouring lags.
///
/// The central lobe is the region about lag zero where ρ > t, connected through the four neighbours of a lag.
/// Its contour consists of the points (1) on the lines between neighbouring lags, with r_min the least and
/// r_max the largest distance from lag zero:
///     Sal = r_min: the autocorrelation length, that of the fastest decay,                              (3)
///     Str = r_min / r_max: the texture aspect ratio, 0 < Str ≤ 1,                                      (4)
/// and the ellipse
///     A x² + 2B xy + C y² = 1                                                                         (5)
/// that fits these points best in least squares has the half axes μ^{-1/2}, μ the eigenvalues of [A B; B C].
/// γ is their ratio, ≥ 1, and its angle α that of the long axis. The same fit to the points of any lobe,
/// closed or not, has the anisotropy
///     ε (cos 2α, sin 2α) = (C - A, -2B)/(A + C),     ε = (γ² - 1)/(γ² + 1),                            (6)
/// which is zero for a circle and varies with chance about it without a preferred direction.
///
/// Symbols   λ  length [samples]      t  level of ρ = R/R(0,0), 0.1, 0.2 or 1/e      ρ' slope per sample
///           x, y  lags [m]      angles from +x towards +y [rad]
/// Scope     A lobe that reaches the longest lags, or lags without a pair of points, has no r_max and no Str.
/// Accuracy  (1), if ρ_{p+1} ≥ 0.47 ρ_p: |error| ≤ max|(ln ρ)''| / (8 |(ln ρ)'|) samples, zero for an
///           exponential and 1/(8λ) for a Gaussian ρ; h²/(8λ) more in a direction, h the larger spacing. For
///           exp(-r) or exp(-r²) of one elliptic radius r: Sal within 3h²/(8 r_min), r_max within 3h²
///           r_max/(8 r_min²), the ellipse's axes within a third of these. The sampling error SE[ρ(λ)] /
///           |ρ'(λ)| is usually far larger; as the least of many lengths, Sal of an estimate is also biased
///           low.
/// Cost      proportional to the lags of the lobe.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"

namespace asperity {

struct Crossing {
  double lag = 0;    ///< λ [samples; in a direction m]
  double slope = 0;  ///< dρ/dλ there [per sample; in a direction per m], negative
};

/// (1) with p = 0: above > level ≥ below.
Crossing crossing_between(double above, double below, double level);

/// The first crossing of `level`, 0 < level < 1, by a profile that begins with ρ(0) = 1; nothing if the
/// profile stays above it or is NaN before.
std::optional<Crossing> first_crossing(const Eigen::ArrayXd& profile, double level);

/// The same for a normalised ρ in a direction.
std::optional<Crossing> first_crossing(const LagField& rho, const Grid& grid, double angle, double level);

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
  std::optional<Reach> r_min = {};                 ///< (3); none if the lags end before
  std::optional<Reach> r_max = {};                 ///< none if the lobe reaches the longest lags
  std::optional<LobeEllipse> ellipse = {};         ///< (5); none if the lobe is open or the fit is no ellipse
  std::optional<Eigen::Vector2d> anisotropy = {};  ///< (6), of an open lobe too

  /// (4).
  std::optional<double> aspect_ratio() const {
    return r_min && r_max ? std::optional(r_min->length / r_max->length) : std::nullopt;
  }
};

/// For a normalised ρ. Throws ParameterError("sal-level", …) unless 0 < level < 1.
CentralLobe central_lobe(const LagField& rho, const Grid& grid, double level = 0.2);

}  // namespace asperity
