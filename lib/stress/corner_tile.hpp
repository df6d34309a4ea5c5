/// Corner functions by the thousand: the vector form of stress/influence.hpp (2), (3).
///
/// Only the quarter X, Y > 0 is needed, for each function is even or odd in X and in Y. Eight neighbours in x
/// are evaluated at once; GCC replaces atan and log by the vector versions of glibc's libmvec (about 11 ns a
/// corner for all six of a pressure, two thirds of that for a traction).
///
/// Accuracy  4 units in the last place of atan and log: 2e-15 absolute.
#pragma once

#include <cstddef>

namespace asperity {

inline constexpr std::ptrdiff_t corner_lanes = 8;

/// Writes out[t][c][8j + l] = f(X, Y) at X = first + l, Y = (j + ½) height, depth z, for l < 8, j < rows, and
/// every traction t and component c (stress/component.hpp) whose out[t][c] is not null. Lengths in units of
/// the spacing in x; first > 0, z ≥ 0, where zero is replaced by a depth too small to matter.
void corner_tile(double first, double height, std::ptrdiff_t rows, double z, double poisson,
                 double* const out[3][6]);

/// Likewise at X = x[l], Y = y[j] of any spacing, X > 0, Y ≥ 0.
void corner_tile(const double* x, const double* y, std::ptrdiff_t rows, double z, double poisson,
                 double* const out[3][6]);

}  // namespace asperity
