/// The calibrated constants of the search for a kernel, and the runs that show them.
///
/// [S] validation/acf_error_time.cpp, the table "Stability": targets from feasible to hopeless under each
/// policy. [T] there, the tables of Newton's iteration and of the other methods: steps, products and seconds.
/// [K] validation/stability_kernel.cpp: targets and tables at the limits. The runs in which they were first
/// fitted are not on record; those named show what they do today.
#pragma once

#include <algorithm>

#include "core/field.hpp"

namespace asperity::solver {

// ---- what the spectrum of a cut target tells before any iteration, relative to its maximum: [S], [K] ----

inline constexpr double hopeless_share = 0.1;  ///< of the spectrum, negative: beyond it nothing is iterated
inline constexpr double round_off = 1e-10;     ///< of the windowed spectrum
/// A spectrum this close to zero is that of a smooth target: Newton's matrix is singular there, the root of
/// the spectrum on a wider torus nearly exact. Somewhat below zero the latter is worth trying at once.
inline constexpr double smooth_spectrum = 1e-12, nearly_smooth = -1e-4;
/// A target is of no surface if, where it has fallen to `far`, its spectrum is still negative by half of what
/// it was where it had fallen to `near`; of a cut alone less than a tenth would be left.
inline constexpr double near = 1e-4, far = 1e-6, still_negative = 0.5;

// ---- how far the answers go: [S] ----

inline constexpr double largest_change = 1e-2;     ///< that the automatic answer makes unasked [σ²]
inline constexpr double negligible_change = 1e-6;  ///< for which no kernel is widened unasked [σ²]

/// Products that find a kernel whose spectrum changes sign, if there is one: a second at any size.
inline long modest_budget(Index unknowns) { return std::clamp<long>(4'000'000 / unknowns, 100, 3000); }
/// Products of least squares that were asked for.
inline long large_budget(Index unknowns) { return std::clamp<long>(100'000'000 / unknowns, 500, 20000); }

/// The torus of projections, over the lags, what it grows by, and its most points: a step then takes a
/// second.
inline constexpr Index least_torus = 4;
inline constexpr Index wider_torus(Index torus) { return torus * 3 / 2; }
inline constexpr double most_torus_points = 1 << 24;

// ---- preconditioners: [T] ----

/// Spectral values this far below the rms are not inverted: there a preconditioner would only amplify.
inline constexpr double inverse_floor = 1e-3, minimum_norm_floor = 1e-2;

// ---- the choice of lags: [T], where errors follow the target at the last lag ----

/// A cut where the target has fallen to so many times the tolerance leaves an error of about the tolerance.
inline constexpr double cut_over_error = 5;
inline constexpr double growth = 1.2;  ///< of the lags, a trial
inline constexpr int most_trials = 10;
/// Unknowns for which 40 vectors still fit into the memory of a workstation.
inline constexpr double most_unknowns = 1 << 24;

}  // namespace asperity::solver
