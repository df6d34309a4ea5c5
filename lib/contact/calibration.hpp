/// The numbers that trial has set in the contact solver.
///
/// They change the cost of a solution, not the solution: whatever they are, ε is confirmed. The run that measured them is
/// `validation/contact_error_time 16 128`, its second table: six scenes at ε = 1e-4, 1e-6, 1e-8 and 1e-10 take 403
/// convolutions and 247 preconditionings in all. Beside a number, the convolutions of others in its place; a number that
/// changes none there is a safeguard.
#pragma once

#include "core/field.hpp"

namespace asperity::calibration {

// Conjugate gradients on a free set.
inline constexpr double reduction =
    0.25;  ///< of |r| before violations are looked for; 0.1: 413, 0.5: 407, 0.9: 470
inline constexpr double goal = 0.9;         ///< of the tolerance, for max|r|; 0.5: 407
inline constexpr int subspace_steps = 200;  ///< at most
inline constexpr double divergence =
    1e3;  ///< of |r| over its least: round-off's directions add up (tests/contact)
inline constexpr int updates_of_gap = 50;      ///< by recurrence, before g is computed anew
inline constexpr double far_from_datum = 100;  ///< displacements: round-off of g is then 1e-14 of them

// Projected gradients.
inline constexpr double sufficient_decrease = 1e-4;  ///< Armijo's fraction
inline constexpr double first_step = 0.5;            ///< α K₀₀; 0.25 and 1: 405
inline constexpr int steps_at_start = 3;             ///< 1: 407, 6: 406
inline constexpr int steps_after_failure = 5, steps_after_cut = 6;
inline constexpr int rounds_to_halve = 4;  ///< ε, before projected gradients are tried

// The end at round-off, by tests/contact/windows.cpp.
inline constexpr double round_off_floor = 1e-11;  ///< of ε: below it gains may end
inline constexpr int rounds_without_gain = 10, grid_rounds_without_gain = 3;

// Windows. A margin is a part of the contact's length, and some cells. Narrow ones take less in these scenes, 394 with
// a part of 1/128 or without the cells; 1/8 takes 496, 16 cells 482. A start from another load has farther to go.
inline constexpr Index least_margin = 4, margin_part = 32, warm_margin_part = 12;
inline constexpr double spare_cells = 1.25;     ///< of those that the limit pressure needs for the load
inline constexpr double largest_window = 0.75;  ///< of the grid's torus; 0.5: 496, 0.9: 403
inline constexpr double shared_window =
    1.5;  ///< of the cells that are asked for: a larger one is not used again

// The start on coarser grids.
inline constexpr Index least_side = 32;           ///< cells of the coarsest grid; 64: 419
inline constexpr double coarse_tolerance = 1e-3;  ///< 1e-2: 397, 1e-4: 414
inline constexpr double coarse_convolutions = 400;

}  // namespace asperity::calibration
