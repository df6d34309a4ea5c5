/// Heights and slopes without the noise of the instrument.
///
/// Noise of rms n that is independent from point to point, and of the surface, adds to mean squares, in the
/// mean over its realisations, on spacings Δx and Δy
///     to Sq² and m0      n²                                                                           (1)
///     to m2_x, m2_y      2n²/Δx², 2n²/Δy²,     to Sdq²  their sum,                                     (2)
///     to m4_x, m4_y      6n²/Δx⁴, 6n²/Δy⁴,                                                             (3)
/// because the differences of stats/hybrid have the weights (-1, 1) and (1, -2, 1). At an angle, c and s its
/// cosine and sine, the mixed products of m2 share no point or cancel, and so do m31 and m13; m22 has 4n²:
///     m2    2n² (c²/Δx² + s²/Δy²),     m4    n² (6c⁴/Δx⁴ + 24c²s²/(Δx²Δy²) + 6s⁴/Δy⁴).                (4)
/// A figure v without noise is v - a, with a its share of (1) to (4), and √(v² - a) of a root. The error is
/// that of v, which holds the chance of the noise too, times the derivative; so are the ends of intervals.
///
/// Two maps of one place differ by the noise of both: from N points of which both have,
///     n² = 1/2(N-1) Σ (d - d̄)²,                                                                       (5)
/// d their difference, with a relative standard error of n of 1/√(2N).
///
/// Scope     white noise: not that of a filtered, interpolated or resampled map, and no drift. (5) has
///           whatever changes between the maps, an offset aside; noise that they share is missing. n is taken
///           for exact. What a form takes of the noise, the share M/N of its M modes, is neglected, and what
///           an L-filter takes, a thousandth of n² where λc is 100 spacings, 7 % where it is 10.
#pragma once

#include <optional>

#include "stats/measure.hpp"

namespace asperity {

/// (5); none unless the maps are of one place: with a correlation above 1/2, and not the same.
std::optional<double> noise_of_repeated(const Field& a, const Field& b);

/// Throws ParameterError("noise", …) unless 0 < noise < Sq.
void check_noise(double noise, const Sample& sample);

/// Rows NAME_without_noise of Sq, m0, Sdq, and m2 and m4 in all directions, as far as they are there; without
/// a value, and with the reason, where noise alone is as large.
Parameters without_noise(const Parameters& rows, double noise, const Grid& grid,
                         const std::optional<Direction>& direction = {});

}  // namespace asperity
