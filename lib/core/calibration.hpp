/// Constants that were measured, not derived, and the run that measured each. They set what an answer costs
/// and where a method gives up; what was asked for is confirmed whatever they are.
#pragma once

#include <algorithm>

#include "core/field.hpp"

/// [S] validation/acf_error_time, "Stability": targets from feasible to hopeless under each policy. [T]
/// there, the tables of methods: steps, products and seconds. [K] validation/stability_kernel: extreme
/// targets. The first fits are not on record; these runs show what the constants do today.
namespace asperity::calibration::acf {

// The spectrum of a cut target, over its maximum: [S], [K].
inline constexpr double hopeless_share = 0.1;  ///< that is negative: beyond it nothing is iterated
inline constexpr double round_off = 1e-10;     ///< of the windowed spectrum
/// So near to zero a target is smooth: Newton's matrix is singular, the spectral root nearly exact. Down to
/// the second that root is worth trying at once.
inline constexpr double smooth_spectrum = 1e-12, nearly_smooth = -1e-4;
/// A target is of no surface if its spectrum stays negative by this part from a cut at `near` to one at
/// `far`; of what a cut alone does less than a tenth would stay.
inline constexpr double near = 1e-4, far = 1e-6, still_negative = 0.5;

// How far answers go: [S].
inline constexpr double largest_change = 1e-2;     ///< of a target, unasked [σ²]
inline constexpr double negligible_change = 1e-6;  ///< for which no kernel is widened unasked [σ²]
/// Products that find a kernel whose spectrum changes sign, if there is one: a second at any size.
inline long modest_budget(Index unknowns) { return std::clamp<long>(4'000'000 / unknowns, 100, 3000); }
/// Products of least squares that were asked for.
inline long large_budget(Index unknowns) { return std::clamp<long>(100'000'000 / unknowns, 500, 20000); }
/// The torus of projections, over the lags, its growth, and its most points: a second a step.
inline constexpr Index least_torus = 4;
inline constexpr Index wider_torus(Index torus) { return torus * 3 / 2; }
inline constexpr double most_torus_points = 1 << 24;

// Preconditioners, over the rms of the spectrum; inverses of less would only amplify: [T].
inline constexpr double inverse_floor = 1e-3, minimum_norm_floor = 1e-2;

// The choice of lags: [T].
inline constexpr double cut_over_error = 5;  ///< the target at the cut, over the error that the cut leaves
inline constexpr double growth = 1.2;        ///< of the lags, a trial
inline constexpr int most_trials = 10;
inline constexpr double most_unknowns = 1 << 24;  ///< of which a workstation holds 40 vectors

}  // namespace asperity::calibration::acf

/// `validation/contact_error_time 16 128`, second table: six scenes at ε = 1e-4, 1e-6, 1e-8, 1e-10 take 403
/// convolutions and 247 preconditionings in all. Beside a number, the convolutions of others in its place; a
/// number without is a safeguard.
namespace asperity::calibration::contact {

// Conjugate gradients on a free set.
inline constexpr double reduction = 0.25;   ///< of |r|, before violations count; 0.1: 413, 0.5: 407, 0.9: 470
inline constexpr double goal = 0.9;         ///< of the tolerance, for max|r|; 0.5: 407
inline constexpr int subspace_steps = 200;  ///< at most
inline constexpr double divergence = 1e3;   ///< of |r| over its least: round-off adds up (tests/contact)
inline constexpr int updates_of_gap = 50;   ///< by recurrence, before g is computed anew
inline constexpr double far_from_datum = 100;  ///< displacements: round-off of g is then 1e-14 of them

// Projected gradients.
inline constexpr double sufficient_decrease = 1e-4;  ///< Armijo's fraction
inline constexpr double first_step = 0.5;            ///< α K₀₀; 0.25 and 1: 405
inline constexpr int steps_at_start = 3;             ///< 1: 407, 6: 406
inline constexpr int steps_after_failure = 5, steps_after_cut = 6;
inline constexpr int rounds_to_halve = 4;  ///< ε, before projected gradients are tried

// The end at round-off: tests/contact/windows.cpp.
inline constexpr double round_off_floor = 1e-11;  ///< of ε: below it gains may end
inline constexpr int rounds_without_gain = 10, grid_rounds_without_gain = 3;

// Windows. A margin is some cells and a part of the contact's length; 1/128 or no cells: 394, 1/8: 496,
// 16 cells: 482. A start from another load has farther to go.
inline constexpr Index least_margin = 4, margin_part = 32, warm_margin_part = 12;
inline constexpr double spare_cells = 1.25;     ///< over those that carry the load at the limit pressure
inline constexpr double largest_window = 0.75;  ///< of the grid's torus; 0.5: 496, 0.9: 403
inline constexpr double shared_window = 1.5;    ///< of the cells asked for: a larger one is not used again

// The start on coarser grids.
inline constexpr Index least_side = 32;           ///< cells of the coarsest grid; 64: 419
inline constexpr double coarse_tolerance = 1e-3;  ///< 1e-2: 397, 1e-4: 414
inline constexpr double coarse_convolutions = 400;

}  // namespace asperity::calibration::contact

namespace asperity::calibration::stress {

// Cells of constant pressure near the surface: tests/stress/surface.cpp, a Hertz contact.
inline constexpr double accurate_cells = 2;           ///< depth, from where they are trusted
inline constexpr double edge_error = 0.09;            ///< of the largest pressure, nearer
inline constexpr double edge_error_compliant = 0.11;  ///< times 1 - 2ν, where that is more
inline constexpr double edge_error_friction = 0.26;   ///< times μ, in addition

// Wider cells for deep layers: tests/stress/layers.cpp and `error` of validation/stress_request_time.
inline constexpr double depth_of_wide_cells = 5;  ///< in sides of the wide cell
inline constexpr Index least_wide_cells = 16;     ///< along each side of the grid
inline constexpr Index least_taper = 8;           ///< lags over which a kernel falls to 0

// From where a corner sum cancels, in half sides: tests/stress/influence.cpp, twelve digits at any distance.
inline constexpr double integrate_by_8 = 5, integrate_by_4 = 50;

// The bound of a unit force: tests/stress/section.cpp, against finer and wider lattices.
inline constexpr int bound_steps = 100;
inline constexpr double bound_width = 4, bound_margin = 1.01;

// The maximum: `maximum` and `depth` of validation/stress_error_time, tests/stress/maximum.cpp.
inline constexpr double scan_ratio = 1.5;        ///< between depths of the scan
inline constexpr double scan_shallowest = 0.25;  ///< of a cell
inline constexpr double close = 0.01;            ///< in ln z: a vertex so near is not worth a layer
inline constexpr double beside = 0.04;           ///< in ln z: a point that narrows the bracket instead
inline constexpr double narrow = 0.012;  ///< product of a bracket's sides, in ln z: a parabola is read off
inline constexpr int most_steps = 6;
inline constexpr Index usual_steps = 4;  ///< to refine the largest

}  // namespace asperity::calibration::stress
