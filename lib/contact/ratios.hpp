/// A rough contact in the pure numbers that contact mechanics compares.
///
/// Flat bodies, with the nominal area A₀ of the domain and the mean pressure p̄ = Q/A₀:
///     A/A₀                        share of the area                                           (1)
///     p̄/(E* S)                    reduced pressure                                            (2)
///     κ = (A/A₀) E* S / p̄         (1) over (2): constant under small loads, √(8/π) = 1.60 by
///                                 Persson [1], √(2π) = 2.51 by Bush, Gibson and Thomas [2]     (3)
///     ū/σ                         mean gap over the rms height                                (4)
/// A sphere on a flat, or two spheres, with Hertz's radius a₀ of the smooth bodies under the same load:
///     α = σR/a₀²                  roughness over the smooth approach; below 0.05 Hertz errs by 7 % [3]  (5)
/// Any, with a limit pressure p_Y as the hardness:
///     ψ = (E*/p_Y) √(σ_s κ_s)     plasticity index: elastic below 0.6, plastic above 1 [4]     (6)
///
/// The rough gap is what the heights of both bodies add to the gap of their smooth forms; S is its rms slope,
/// σ its rms height about the mean, σ_s and κ_s the deviation of its summits' heights and their mean
/// curvature. The caller measures them (stats/hybrid).
///
/// Symbols   A contact area [m²]   Q load [N]   E* composite modulus [Pa]   R composite radius [m]
///
/// [1] B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840-3861.
/// [2] A. W. Bush, R. D. Gibson, T. R. Thomas, Wear 35 (1975) 87-111.
/// [3] J. A. Greenwood, K. L. Johnson, E. Matsubara, Wear 100 (1984) 47-57.
/// [4] J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300-319.
#pragma once

#include <limits>

#include "contact/bodies.hpp"
#include "contact/grid_error.hpp"
#include "contact/solver.hpp"

namespace asperity {

/// Of the rough gap; NaN is not known.
struct GapRoughness {
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  double rms_height = unknown;        ///< σ [m]
  double rms_slope = unknown;         ///< S
  double rms_slope_error = unknown;   ///< by the spacing of the heights
  double nayak_alpha = unknown;       ///< m0 m4/m2² of the isotropic surface
  double summit_deviation = unknown;  ///< σ_s [m]
  double summit_curvature = unknown;  ///< κ_s [1/m]
  double plateaus = 0;                ///< share of the summits that are plateaus of equal heights
};

/// NaN where a ratio is not defined or what it needs is not known.
struct ContactRatios {
  double area_share = GapRoughness::unknown;        ///< (1)
  double reduced_pressure = GapRoughness::unknown;  ///< (2)
  double kappa = GapRoughness::unknown;             ///< (3)
  double reduced_gap = GapRoughness::unknown;       ///< (4)
  double sphere_roughness = GapRoughness::unknown;  ///< (5)
  double plasticity_index = GapRoughness::unknown;  ///< (6)
};

/// `area` is the contact's A [m²], as counted or corrected.
ContactRatios contact_ratios(const Grid& grid, const Bodies& bodies, const GapRoughness& gap,
                             double limit_pressure, const Contact& contact, double area);

/// What the grid leaves of (1) to (4): the relative errors of what they are computed from, added. NaN where
/// not known; (5) and (6) have none. `load_error` is 0 of a load that was prescribed.
ContactRatios ratio_errors(const ContactRatios& ratios, const GapRoughness& gap, const Contact& contact,
                           double area, const GridErrors& errors, double load_error);

}  // namespace asperity
