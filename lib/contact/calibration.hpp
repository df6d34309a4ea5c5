/// Empirical constants of the solver. They control its cost and when it gives up; what it returns is verified
/// independently of them.
///
/// `validation/contact_error_time 16 128`, second table: six scenes at ε = 1e-4, 1e-6, 1e-8, 1e-10 need 403
/// convolutions and 247 preconditionings in total. Comments give the convolutions with other values; a value
/// without them is a safeguard.
#pragma once

#include "core/field.hpp"

namespace asperity::contact {

// Conjugate gradients on a free set.
inline constexpr double reduction =
    0.25;                            ///< of |r|, before violations are counted; 0.1: 413, 0.5: 407, 0.9: 470
inline constexpr double goal = 0.9;  ///< of the tolerance, for max|r|; 0.5: 407
inline constexpr int subspace_steps = 200;      ///< at most
inline constexpr double divergence = 1e3;       ///< of |r| over its smallest: round-off grows (tests/contact)
inline constexpr Index single_cells = 1 << 16;  ///< from which single precision pays
inline constexpr int updates_of_gap = 50;       ///< by recurrence, before g is recomputed
inline constexpr double far_from_datum = 100;   ///< displacements: round-off of g is then 1e-14 of these

// Ragged free sets on fine grids. Convolutions of eight contacts to ε = 1e-8, 178 in total: of
// validation/contact_scenes.hpp rough spheres with and without a limit pressure at 512² and 1024² and a tenth
// of a periodic surface at 512², and three periodic self-affine surfaces of H = 0.8 at 512².
inline constexpr Index fine_cells = 128 * 128;
// TwoLevel::raggedness(); smooth spheres have 0.9, rough ones 4…16. For blocks 3: 178, but longer times
// where no wave is shorter than 30 cells.
inline constexpr double ragged_to_relax = 3;     ///< 2: 177, 5: 188
inline constexpr double ragged_for_blocks = 5;   ///< 8: 188
inline constexpr double ragged_reduction = 0.1;  ///< in place of `reduction`; 0.03: 192, 0.25: 187
inline constexpr double least_drive = 0.3;       ///< of FreeSet::proportion; 0: 184, 0.1: 180, 0.6: 181
inline constexpr double calm_bounds = 0.01;      ///< likewise; 0: 181
inline constexpr double block_tolerance = 1e-2;  ///< 1e-3: 181, 0.1: 179
inline constexpr int block_steps = 10;
inline constexpr double held_load = 4;  ///< β of contact/relaxation.hpp over K_R; 2: 191, 8: 189
inline constexpr int sweeps_of_guarded_step = 4, sweeps_of_step = 6;  ///< of the former 2: 186, 6: 180

// Projected gradients.
inline constexpr double sufficient_decrease = 1e-4;  ///< Armijo's fraction
inline constexpr double first_step = 0.5;            ///< α K₀₀; 0.25 and 1: 405
inline constexpr int steps_at_start = 3;             ///< 1: 407, 6: 406
inline constexpr int steps_after_failure = 5, steps_after_cut = 6;
inline constexpr int rounds_to_halve = 4;  ///< of ε, before projected gradients are tried

// The end at round-off: tests/contact/windows.cpp.
inline constexpr double round_off_floor = 1e-11;  ///< of ε: below it progress may end
inline constexpr int rounds_without_gain = 10, grid_rounds_without_gain = 3;

// Windows. A margin is some cells plus a fraction of the contact's length; 1/128 or no cells: 394, 1/8: 496,
// 16 cells: 482. A start from another load needs a wider one.
inline constexpr Index least_margin = 4, margin_part = 32, warm_margin_part = 12;
inline constexpr double spare_cells = 1.25;     ///< times the cells that carry the load at the limit pressure
inline constexpr double largest_window = 0.75;  ///< of the grid's torus; 0.5: 496, 0.9: 403
inline constexpr double shared_window = 1.5;    ///< times the needed cells: a larger one is not reused

// The start on coarser grids.
inline constexpr Index least_side = 32;           ///< cells of the coarsest grid; 64: 419
inline constexpr double coarse_tolerance = 1e-3;  ///< 1e-2: 397, 1e-4: 414
inline constexpr double coarse_convolutions = 400;

}  // namespace asperity::contact
