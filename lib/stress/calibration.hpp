/// What of the stress was measured, not derived, and the run that measured it.
#pragma once

#include "core/field.hpp"

namespace asperity::calibration {

// How near to the surface cells of constant pressure may be trusted: tests/stress/surface.cpp, a Hertz contact.
inline constexpr double accurate_cells = 2;
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

// The search for the maximum: `maximum` and `depth` of validation/stress_error_time, tests/stress/maximum.cpp.
inline constexpr double scan_ratio = 1.5;        ///< between depths of the scan
inline constexpr double scan_shallowest = 0.25;  ///< of a cell
inline constexpr double close = 0.01;            ///< in ln z: a vertex so near is not worth a layer
inline constexpr double beside = 0.04;           ///< in ln z: a point that narrows the bracket instead
inline constexpr double narrow =
    0.012;  ///< product of the sides of a bracket, in ln z, that a parabola is read off
inline constexpr int most_steps = 6;
inline constexpr Index usual_steps = 4;  ///< to refine the largest

}  // namespace asperity::calibration
