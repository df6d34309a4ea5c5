/// Columns transformed by FFTW in single precision; no other code calls that library. For transform/plan.cpp.
///
/// Only contacts of many cells need it: the first of them loads it (core/module.hpp).
#pragma once

namespace asperity {

/// Columns of `points` values, `apart` complex numbers from one value to the next.
struct ColumnPlan {
  int points, columns, apart;
  int sign;  ///< of the exponent: FFTW_FORWARD or FFTW_BACKWARD
};

}  // namespace asperity

extern "C" {
/// A plan from `in` to `out`, both of complex numbers; null where FFTW makes none.
void* asperity_plan_columns(const asperity::ColumnPlan& of, float* in, float* out);
void asperity_execute_columns(const void* plan, float* in, float* out);
void asperity_destroy_columns(void* plan);
}
