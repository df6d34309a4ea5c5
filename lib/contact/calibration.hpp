/// The numbers that trial has set in the contact solver.
///
/// They change the cost of a solution, not the solution: whatever they are, ε is confirmed. Those of the iteration, of
/// the start and of windows were chosen by `validation/contact_error_time`, second table: the fewest convolutions and
/// seconds over the scenes A to D at ε = 1e-4…1e-10. Those at round-off are from the tests tests/contact/windows.cpp,
/// where a tolerance below round-off is asked for.
#pragma once

#include "core/field.hpp"

namespace asperity::calibration {

// Conjugate gradients on a free set.
inline constexpr double reduction = 0.25;   ///< of |r| before violations are looked for
inline constexpr double goal = 0.9;         ///< of the tolerance, for max|r|
inline constexpr int subspace_steps = 200;  ///< at most
inline constexpr double divergence =
    1e3;  ///< of |r| over its least: round-off's directions are noise that adds up
inline constexpr int updates_of_gap = 50;      ///< by recurrence, before g is computed anew
inline constexpr double far_from_datum = 100;  ///< displacements: round-off of g is then 1e-14 of them

// Projected gradients.
inline constexpr double sufficient_decrease = 1e-4;  ///< Armijo's fraction
inline constexpr double first_step = 0.5;            ///< α K₀₀
inline constexpr int steps_at_start = 3, steps_after_failure = 5, steps_after_cut = 6;
inline constexpr int rounds_to_halve = 4;  ///< ε, before projected gradients are tried

// The end at round-off.
inline constexpr double round_off_floor = 1e-11;  ///< of ε: below it gains may end
inline constexpr int rounds_without_gain = 10, grid_rounds_without_gain = 3;

// Windows. A margin is this part of the contact's length, and four cells.
inline constexpr Index least_margin = 4, margin_part = 32, warm_margin_part = 12;
inline constexpr double spare_cells = 1.25;     ///< of those that the limit pressure needs for the load
inline constexpr double largest_window = 0.75;  ///< of the grid's torus: a larger one saves too little
inline constexpr double shared_window =
    1.5;  ///< of the cells that are asked for: a larger one is not used again

// The start on coarser grids.
inline constexpr Index least_side = 32;  ///< cells of the coarsest grid
inline constexpr double coarse_tolerance = 1e-3;
inline constexpr double coarse_convolutions = 400;

}  // namespace asperity::calibration
