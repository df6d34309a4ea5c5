/// Profile parameters by ISO 21920-2 (formerly ISO 4287), averaged over all profiles of a surface along x or along y.
///
/// Of a profile z_0 … z_{n-1}, a row of heights Δ apart, measured from its own mean:
///     a = 1/n Σ|z|,  q = √(1/n Σz²),  sk = 1/n Σz³/q³,  ku = 1/n Σz⁴/q⁴                             (1)
///     p, v, z        highest peak, deepest valley, and their sum z = p + v, each of every section and averaged
///                    over the sections, n_sc of them, l_sc long, from the profile's beginning on
///     t              the same as z over the whole profile
///     dq = √(mean z'²),   z'_i = (z_{i+3} - 9 z_{i+2} + 45 z_{i+1} - 45 z_{i-1} + 9 z_{i-2} - z_{i-3})/(60Δ)  (2)
///     Sm             mean spacing of profile elements, a hill and the dale beside it. Hills rise more than a tenth of
///                    z above the mean line, dales fall as far below it; an element ends where the profile crosses
///                    the mean line (half way from the first to the last crossing, where it does so more than once),
///                    and elements from hill to hill and from dale to dale are both counted.
/// With the prefix P they are those of the primary profile, of one section; with R those of the roughness profile, whose
/// sections are as long as the cut-off λ_c of the filter, l_sc = λ_c.
///
/// Over m profiles a parameter has a mean and a spread s, of divisor m. Profiles beside each other are correlated, the
/// k-th power of the heights' Hermite components at a distance of j profiles by
///     g_k(j) = Σ_p w_p ρ(p,j)ᵏ / Σ_p w_p ρ(p,0)ᵏ,   w_p the share of pairs at lag p along the profile,   (3)
/// and the mean has the standard error, with c = Σ_j w_j g_k(j) over all distances,
///     SE = s √(c / (m - c)),   m/c the profiles that are independent,                                    (4)
/// k = 3 for sk, 4 for ku, and 2 for all others: measured from the profile's mean, none has a linear component, and
/// those beyond the second are less correlated. A dash where m ≤ 2c.
///
/// Symbols   z  heights, positive outwards [m]      l_sc  section length [m]      ρ  correlation
/// Scope     Filters act on the surface before profiles are taken from it (stats/filter/gaussian_filter.hpp). Missing points
///           are left out; no stencil (2) and no element reaches over one.
/// Accuracy  (1) to round-off; (2) of a wave u = qΔ is (45 sin u - 9 sin 2u + sin 3u)/(30u), 1 - u⁶/140, times its
///           slope. p, v of a wave of N points a period are low by up to 5/N². (4) is that of Gaussian heights.
/// Cost      a few passes over the data, one over the correlation.
///
/// ISO 21920-2:2021; ISO 4287:1997, 4.3.1 for (2), whose limit of 10 % Rz and not that of 1 % in length is taken for Sm.
/// P. J. Scott, The case of surface texture parameter RSm, Meas. Sci. Technol. 17 (2006) 559-564.
#pragma once

#include <array>

#include "core/field.hpp"
#include "stats/sample/ensemble.hpp"
#include "stats/spatial/lag_field.hpp"
#include "stats/spatial/pairs.hpp"
#include "stats/spectrum/spectrum.hpp"

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
  profile_sm
};
inline constexpr int profile_parameters_count = 10;

/// Not a number where a profile has no such parameter.
using ProfileParameters = Eigen::Array<double, profile_parameters_count, 1>;

/// Of one profile of heights `step` apart; `section` is l_sc, infinite for one section. On a periodic grid (2) goes on
/// with its first points.
ProfileParameters profile_parameters(const Eigen::ArrayXd& heights, double step, double section,
                                     bool periodic);

struct ProfileAverages {
  ProfileParameters mean, spread, standard_error;
  double profiles = 0;     ///< m, those that have a height
  double independent = 0;  ///< m/c, k = 2
};

/// The profiles along one axis of a field that comes in parts.
class ProfileSums {
 public:
  /// Throws ParameterError("lambda-c", …) when the section is longer than the profiles.
  ProfileSums(const Grid& grid, Axis1D along, double section);
  /// Whole profiles: columns of heights along x, rows along y.
  void add(const Field& heights);
  /// ρ is a correlation that is zero beyond its lags.
  ProfileAverages averages(const Pairs& pairs, const LagField& rho) const;

 private:
  Grid grid_;
  Axis1D along_;
  double section_;
  Ensemble profiles_;
};

}  // namespace asperity
