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
///     c              mean height of these elements, from the pit of the dale to the peak of the hill
///     k, pk, vk, mr1, mr2, pkx, vkx, ak1, ak2, mc, dc
///                    of the profile's heights what Sk, Spk, Svk, Smr1, Smr2, Spkx, Svkx, Sak1, Sak2, Smc and
///                    Sdc are of a surface's (stats/height/material_ratio.hpp)
///     5p, 5v, 10z    mean height of the five highest peaks, depth of the five deepest pits, their sum, of a
///                    profile that has five. Hills and dales are pruned below z/20
///                    (stats/feature/hills.hpp); what is highest at an end or beside a missing point is none.
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
///           The standard has k to ak2 behind its robust filter, which is for the user to ask for.
///           Missing points are left out; no stencil (2) and no element spans one.
/// Accuracy  (1) to round-off; (2) of a wave u = qΔ is (45 sin u - 9 sin 2u + sin 3u)/(30u), 1 - u⁶/140,
///           times its slope. p, v of a wave of N points a period are low by up to 5/N².
///           Errors: docs/accuracy/asperity-stats.md. After a form of degree 2 they are 0.92 to 1.17 of the
///           true ones, those of plateaus 0.71 to 0.99: their profiles all bend with the error of the form.
/// Cost      of each profile a sort, two trees of hills and a few passes; one pass over the correlation.
///
/// ISO 21920-2:2021; ISO 4287:1997, 4.3.1 for (2). Sm and c use its limit of 10 % Rz, as some instruments do;
/// others take 10 % of Rp for hills and of Rv for dales. That of 1 % in length is not used. The text of the
/// former was not seen for k to 10z: that they are those of surfaces, and peaks are pruned at 5 %, is as
/// other programs say. P. J. Scott, The case of surface texture parameter RSm, Meas. Sci. Technol. 17 (2006)
/// 559-564.
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
  profile_c,
  profile_k,
  profile_pk,
  profile_vk,
  profile_mr1,
  profile_mr2,
  profile_pkx,
  profile_vkx,
  profile_ak1,
  profile_ak2,
  profile_mc_p,
  profile_mc_q,
  profile_dc,
  profile_5p,
  profile_5v,
  profile_10z,
  profile_parameters_count
};

/// NaN if a profile has no such parameter.
using ProfileParameters = Eigen::Array<double, profile_parameters_count, 1>;

/// Of one profile of heights `step` apart; `section` is l_sc, infinite for one section; (2) wraps around if
/// `periodic`. A profile whose heights above its mean are `round_off` at most is straight. mc and dc are at
/// the material ratios p, q.
ProfileParameters profile_parameters(const Eigen::ArrayXd& heights, double step, double section,
                                     bool periodic, double round_off = 0,
                                     const std::array<double, 2>& ratios = {0.1, 0.8});

struct ProfileAverages {
  std::array<SequenceMean, profile_parameters_count> of;
  double profiles = 0;     ///< m, without empty ones
  double independent = 0;  ///< m/c
};

/// Of the profiles along one axis of a field; ρ is a correlation that is zero beyond its lags. Throws
/// ParameterError("lambda-c", …) if the section is longer than the profiles.
ProfileAverages average_profiles(const Field& heights, const Pairs& pairs, const FieldExtent& extent,
                                 Axis1D along, double section, const LagField& rho, double round_off = 0,
                                 const std::array<double, 2>& ratios = {0.1, 0.8});

}  // namespace asperity
