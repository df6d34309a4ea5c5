/// Autocorrelations given as tables: measured, computed elsewhere, or those of another kernel.
///
/// A table holds R(p,q) over the half plane p = 0…P (rows), q = -Q…Q (an odd number of columns), where
/// R(-p,-q) = R(p,q). As a target it is known at |p| ≤ P, |q| ≤ Q only and is divided by R(0,0). It equals
/// the table to the last bit, except in row 0, whose halves must agree. A table that cannot be an
/// autocorrelation is refused: R(0,0) not positive, |R| above it, or a number that is not finite. The solver
/// finds out whether it is positive definite.
#pragma once

#include <vector>

#include "acf/target.hpp"
#include "core/field.hpp"

namespace asperity {

/// The table as a target; `oriented` where R(p,-q) differs from R(p,q) by more than 1e-12 R(0,0). Throws
/// DataError("acf", …).
Target target_of_table(Field half_plane);

/// The table without the rows and columns at its ends that hold no number.
Field known_lags(const Field& half_plane);

/// The half plane of a quadrant R(p,q), p = 0…P, q = 0…Q, whose R is even in p and in q.
Field half_plane_of_quadrant(const Field& quadrant);

/// A value at a lag in units of any length.
struct LagValue {
  double lag_x, lag_y, value;
};

/// A table with the steps of its lags, NaN where there is one lag only.
struct LagTable {
  Field half_plane;
  double step_x, step_y;
};

/// The half plane of values at evenly spaced lags, in any order, each lag or its mirror image (-p,-q) once at
/// least: the whole plane, half of it, or a quadrant, which is taken to be even. Lags may be rounded to 1e-3
/// of a step. Throws DataError("acf", …).
LagTable table_of_lags(const std::vector<LagValue>& values);

}  // namespace asperity
