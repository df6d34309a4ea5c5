/// Empirical constants, and the run that determined each. They control cost and when a method gives up;
/// results are verified independently of them.
#pragma once

#include <algorithm>

#include "core/field.hpp"

/// `validation/contact_error_time 16 128`, second table: six scenes at ε = 1e-4, 1e-6, 1e-8, 1e-10 need 403
/// convolutions and 247 preconditionings in total. Comments give the convolutions with other values; a value
/// without them is a safeguard.
namespace asperity::calibration::contact {

// Conjugate gradients on a free set.
inline constexpr double reduction =
    0.25;                            ///< of |r|, before violations are counted; 0.1: 413, 0.5: 407, 0.9: 470
inline constexpr double goal = 0.9;  ///< of the tolerance, for max|r|; 0.5: 407
inline constexpr int subspace_steps = 200;      ///< at most
inline constexpr double divergence = 1e3;       ///< of |r| over its smallest: round-off grows (tests/contact)
inline constexpr Index own_cells = 1 << 18;     ///< up to which each of several ranks does all
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

}  // namespace asperity::calibration::contact

/// What the grid leaves of a contact: `validation/contact_grid_error`. m is max(|v(n) - v(n/2)|, ¼ |v(n/2) -
/// v(n/4)|): the first difference alone is near zero by accident in a few per cent of scenes.
namespace asperity::calibration::grid_error {

inline constexpr double tolerance = 1e-6;  ///< ε of the coarser contacts; 1e-3 is too loose
inline constexpr Index least_side = 12;    ///< cells of the coarsest grid
inline constexpr double lattice = 0.5, lattice_bias = 0.03;
inline constexpr double pressure = 1.0 / 3;      ///< of m
inline constexpr double peak = 1.5;              ///< of the rise of a parabola above the largest pressure
inline constexpr double approach = 0.4;          ///< of the larger m, of approach and mean gap
inline constexpr double load = 0.8;              ///< of m, under a prescribed approach
inline constexpr double stiffness = 1.0 / 3;     ///< of m
inline constexpr double ragged = 1.0 / 3;        ///< of the stiffness, times Outline::scatter over its cells
inline constexpr double plastic_area = 1.0 / 3;  ///< of m
inline constexpr double missed_cells = 0.10;     ///< of a cell a side of the area at the limit pressure
inline constexpr double maximum_stress = 0.28;   ///< of m
inline constexpr double shallow_stress = 0.03;   ///< of the value, times min(1, (h/z)²)
inline constexpr double search = 2e-5;           ///< of the value: that of the search on fine grids
inline constexpr double depth = 0.275;           ///< of m, times the root of the depth in cells
inline constexpr double depth_at_limit = 0.41;   ///< likewise, at a limit pressure
inline constexpr double floor_of_depth = 0.1;    ///< of the second difference, in m of the depth
inline constexpr double depth_of_search = 5e-4;  ///< of the depth
inline constexpr double near_plastic = 0.1;      ///< of the value above 2h below a limit pressure

}  // namespace asperity::calibration::grid_error

namespace asperity::calibration::stress {

// Cells of constant pressure near the surface: tests/stress/surface.cpp, a Hertz contact.
inline constexpr double accurate_cells = 2;           ///< depth from which stresses are accurate
inline constexpr double edge_error = 0.09;            ///< of the largest pressure, above that depth
inline constexpr double edge_error_compliant = 0.11;  ///< times 1 - 2ν, if that is more
inline constexpr double edge_error_friction = 0.26;   ///< times μ, in addition
inline constexpr double edge_stairs = 0.015;          ///< of the largest pressure: tests/stress/edge.cpp

// Wider cells for deep layers: tests/stress/layers.cpp and `error` of validation/stress_request_time.
inline constexpr double depth_of_wide_cells = 5;  ///< in sides of the wide cell
inline constexpr Index least_wide_cells = 16;     ///< along each side of the grid
inline constexpr Index least_taper = 8;           ///< lags over which a kernel decays to 0

// Cells of a layer from which on threads share it, and components come one by one: at 512² that takes a fifth
// longer, at 1024² as long (`volume` of validation/scaling).
inline constexpr Index shared_layer = 768 * 768;

// Distance in half sides from which corner sums cancel: tests/stress/influence.cpp, twelve digits everywhere.
inline constexpr double integrate_by_8 = 5, integrate_by_4 = 50;

// The bound of a unit force: tests/stress/section.cpp, against finer and wider lattices.
inline constexpr int bound_steps = 100;
inline constexpr double bound_width = 4, bound_margin = 1.01;

// The maximum: `maximum` and `depth` of validation/stress_error_time, tests/stress/maximum.cpp.
inline constexpr double scan_ratio = 1.4142135623730951;  ///< between depths of the scan
inline constexpr double scan_shallowest = 0.25;           ///< of a cell
inline constexpr double scan_margin = 0.03,
                        principal_margin = 0.15;  ///< of the largest: starts below are left
inline constexpr double wide_margin = 0.1;        ///< added times (spacing / depth)² at most 1
inline constexpr double recurrence = 1e-9;        ///< of the value: round-off of a layer is 1e-13
inline constexpr double same_place = 0.25;        ///< of the depth: maxima of two layers that are one
inline constexpr double wide_cell_depth = 3;      ///< in sides of a cell of the scan

}  // namespace asperity::calibration::stress
