/// The corner functions (2), (3) of stress/influence.hpp, given r, T, A and L; and eight at a time.
///
/// Two sources compute them: stress/influence.cpp, exact for every argument, and stress/corner.cpp, compiled
/// for vector units under looser rules of arithmetic. Internal linkage keeps their copies apart.
///
/// Only the quarter X, Y > 0 is needed, for each function is even or odd in X and in Y. GCC replaces atan and
/// log by the vector versions of glibc's libmvec.
///
/// Accuracy  of eight at a time 4 units in the last place of atan and log: 2e-15 absolute.
/// Cost      about 11 ns a corner for all six functions of a pressure, two thirds of that for a traction.
#pragma once

#include <cmath>
#include <cstddef>

namespace asperity::corner {

/// 0/0 stands for the limit 0 at the surface.
static inline double quotient(double a, double b) { return b == 0 ? 0 : a / b; }

static inline double F(double X, double Y, double z, double r) {
  return quotient(z * X * Y, r * (X * X + z * z));
}
static inline double G(double X, double Y, double z, double r) {
  return quotient(z * z * Y, r * (X * X + z * z));
}

namespace normal {

static inline double xx(double X, double Y, double z, double r, double T, double A, double nu) {
  return -2 * nu * T + F(X, Y, z, r) - (1 - 2 * nu) * A;
}
static inline double yy(double X, double Y, double z, double r, double T, double A, double nu) {
  return -2 * nu * T + F(Y, X, z, r) - (1 - 2 * nu) * (T - A);
}
static inline double zz(double X, double Y, double z, double r, double T) {
  return -T - F(X, Y, z, r) - F(Y, X, z, r);
}
static inline double xy(double z, double r, double nu) {
  return -quotient(z, r) - (1 - 2 * nu) * std::log(r + z);
}

}  // namespace normal

/// Under a traction along x; that along y follows by exchange of X and Y.
namespace shear {

/// What xx, yy and xy have in common: W with Y in the first two, with X in the third.
static inline double W(double Y, double z, double r, double nu) {
  return quotient(Y * (2 * nu * r + z), r * (r + z));
}

static inline double xx(double X, double Y, double z, double r, double L, double nu) {
  return 2 * L + W(Y, z, r, nu) - G(X, Y, z, r);
}
static inline double yy(double Y, double z, double r, double L, double nu) {
  return 2 * nu * L - W(Y, z, r, nu);
}
static inline double xy(double X, double z, double r, double L, double nu) { return L - W(X, z, r, nu); }
static inline double xz(double X, double Y, double z, double r, double T) { return F(X, Y, z, r) - T; }
static inline double yz(double z, double r) { return -quotient(z, r); }

}  // namespace shear
}  // namespace asperity::corner

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
