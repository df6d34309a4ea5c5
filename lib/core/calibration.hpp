/// Empirical constants, and the run that determined each. They control cost and when a method gives up;
/// results are verified independently of them.
#pragma once

#include <algorithm>

#include "core/field.hpp"

/// [S] validation/acf_error_time, "Stability": targets from feasible to hopeless under each policy. [T] same
/// program, tables of methods: steps, products and seconds. [K] validation/stability_kernel: extreme targets.
/// The original fits were not recorded; these runs show the present effect of the constants.
namespace asperity::calibration::acf {

// The spectrum of a truncated target, relative to its maximum: [S], [K].
inline constexpr double hopeless_share = 0.1;  ///< negative share above which no iteration is tried
inline constexpr double round_off = 1e-10;     ///< of the windowed spectrum
/// Below the first value a target is smooth: Newton's matrix is singular and the spectral root nearly exact.
/// Down to the second value that root is tried first.
inline constexpr double smooth_spectrum = 1e-12, nearly_smooth = -1e-4;
/// No surface has a target whose negative spectrum keeps this fraction from truncation at `near` to `far`; of
/// a negative part due to truncation less than a tenth remains.
inline constexpr double near = 1e-4, far = 1e-6, still_negative = 0.5;

// Accepted changes of a target: [S].
inline constexpr double largest_change = 1e-2;     ///< of a target without request [σ²]
inline constexpr double negligible_change = 1e-6;  ///< below which no kernel is widened without request [σ²]
/// Products to find a kernel whose spectrum changes sign, if there is one: one second at any size.
inline long modest_budget(Index unknowns) { return std::clamp<long>(4'000'000 / unknowns, 100, 3000); }
/// Products for requested least squares.
inline long large_budget(Index unknowns) { return std::clamp<long>(100'000'000 / unknowns, 500, 20000); }
/// The torus of projections relative to the lags, its growth, and its largest size: one second per step.
inline constexpr Index least_torus = 4;
inline constexpr Index wider_torus(Index torus) { return torus * 3 / 2; }
inline constexpr double most_torus_points = 1 << 24;

// Floors of preconditioners relative to the rms of the spectrum; inverses of less would amplify errors: [T].
inline constexpr double inverse_floor = 1e-3, minimum_norm_floor = 1e-2;

// The choice of lags: [T].
inline constexpr double cut_over_error = 5;  ///< the target at the cut, relative to the error by the cut
inline constexpr double growth = 1.2;        ///< of the lags per trial
inline constexpr int most_trials = 10;
inline constexpr double most_unknowns = 1 << 24;  ///< a workstation holds 40 such vectors

}  // namespace asperity::calibration::acf

/// What the grid leaves of a contact: `validation/contact_grid_error`. m is max(|v(n) - v(n/2)|, ¼ |v(n/2) -
/// v(n/4)|): the first difference alone is near zero by accident in a few per cent of scenes.
namespace asperity::calibration::grid_error {

inline constexpr double floor_of_first = 0.25;  ///< of the second difference
inline constexpr Index least_side = 12;         ///< cells of the coarsest grid

// The growth of a mean square slope from grid to grid.
inline constexpr double resolved = 1.0, doubtful = 0.8;

}  // namespace asperity::calibration::grid_error
