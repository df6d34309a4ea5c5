/// Profile parameters by ISO 21920-2 (formerly ISO 4287), averaged over all profiles along x or y.
///
/// For a profile z_0 … z_{n-1}, a row of heights Δ apart, measured from its own mean:
///     a = 1/n Σ|z|,  q = √(1/n Σz²),  sk = 1/n Σz³/q³,  ku = 1/n Σz⁴/q⁴                             (1)
///     p, v, z        highest peak, deepest valley, z = p + v, means over the sections of length l_sc
///     t              the same as z over the whole profile
///     dq = √(mean z'²),
///          z'_i = (z_{i+3} - 9 z_{i+2} + 45 z_{i+1} - 45 z_{i-1} + 9 z_{i-2} - z_{i-3})/(60Δ)          (2)
///     Sm             mean spacing of elements, a hill and the dale next to it. Hills rise over z/10 above
///                    the mean line, dales fall as far below; an element ends where the profile crosses it
///                    (half way from the first to the last of several crossings), and elements from hill to
///                    hill and from dale to dale are both counted.
/// The prefix P denotes the primary profile, with one section; R the roughness profile, whose sections are as
/// long as the cut-off of the filter, l_sc = λ_c.
///
/// Over m profiles a parameter has a mean and a spread, with divisor m, whose standard errors come from the
/// longest waves across the profiles (stats/uncertainty/sequence_error.hpp), whatever heights and correlation
/// are. Means of a and q are those of local functions of all points besides, whose waves of the plane tell
/// more (stats/uncertainty/long_waves.hpp): with h the height above the mean of its profile
///     a:   |h| - h mean(sign h),          q:   q + (h² - q²)/(2q).                                       (4)
/// sk and ku of short profiles stray less than such functions, which a few heights decide.
/// The mean squares of profiles at a distance of j profiles are correlated by
///     g(j) = Σ_p w_p ρ(p,j)² / Σ_p w_p ρ(p,0)²,   w_p the share of pairs at lag p along the profile,     (3)
/// if the heights are Gaussian. Of m profiles, m/c are independent, c = Σ_j w_j g(j) over all distances.
///
/// Symbols   z  heights, positive outwards [m]      l_sc  section length [m]      ρ  correlation
/// Scope     Filters act on the surface before profiles are taken from it (stats/filter/gaussian_filter.hpp).
///           Missing points are left out; no stencil (2) and no element spans one.
/// Accuracy  (1) to round-off; (2) of a wave u = qΔ is (45 sin u - 9 sin 2u + sin 3u)/(30u), 1 - u⁶/140,
///           times its slope. p, v of a wave of N points a period are low by up to 5/N².
///           Errors: docs/accuracy/asperity-stats.md. After a form of degree 2 they are 0.92 to 1.17 of the
///           true ones, those of plateaus 0.71 to 0.99: their profiles all bend with the error of the form.
/// Cost      a few passes over the data, one over the correlation.
///
/// ISO 21920-2:2021; ISO 4287:1997, 4.3.1 for (2). Sm uses its limit of 10 % Rz, but not that of 1 % in
/// length. P. J. Scott, The case of surface texture parameter RSm, Meas. Sci. Technol. 17 (2006) 559-564.
#pragma once

#include <array>

#include "core/field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/spectrum/spectrum.hpp"
#include "stats/uncertainty/long_waves.hpp"
#include "stats/uncertainty/sequence_error.hpp"

namespace asperity {

/// In the order of ProfileParameters.
enum ProfileParameter {
  profile_a,
  profile_q,
  profile_sk,
  profile_ku,
  profile_p,
  profile_v,
  profile_z,
  profile_t,
  profile_dq,
  profile_sm,
  profile_parameters_count
};

/// NaN if a profile has no such parameter.
using ProfileParameters = Eigen::Array<double, profile_parameters_count, 1>;

/// Of one profile of heights `step` apart; `section` is l_sc, infinite for one section; (2) wraps around if
/// `periodic`. A profile whose heights above its mean are `round_off` at most is straight.
ProfileParameters profile_parameters(const Eigen::ArrayXd& heights, double step, double section,
                                     bool periodic, double round_off = 0);

struct ProfileAverages {
  std::array<SequenceMean, profile_parameters_count> of;
  double profiles = 0;     ///< m, without empty ones
  double independent = 0;  ///< m/c
};

/// Of the profiles along one axis of a field; ρ is a correlation that is zero beyond its lags. Throws
/// ParameterError("lambda-c", …) if the section is longer than the profiles.
ProfileAverages average_profiles(const Field& heights, const Pairs& pairs, const FieldExtent& extent,
                                 Axis1D along, double section, const LagField& rho, double round_off = 0);

}  // namespace asperity
