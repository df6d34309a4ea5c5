/// Height parameters of a surface, by ISO 25178-2.
///
/// With heights d measured from the mean of all N points that are not missing,
///     Sa  = 1/N Σ |d|                    arithmetic mean height
///     Sq  = √(1/N Σ d²)                  root mean square height
///     Ssk = 1/N Σ d³ / Sq³               skewness
///     Sku = 1/N Σ d⁴ / Sq⁴               kurtosis, 3 for a Gaussian surface
///     Sp, Sv, Sz = Sp + Sv               highest peak, deepest valley, both ≥ 0, maximum height
/// population moments (divisor N) over the whole field. Ra and Rq of ISO 21920-2 are the same means over a
/// profile; Rp, Rv and Rz are means over sampling lengths.
///
/// Accuracy  Two passes about a shifted origin (stats/filter/form.hpp), by sums of row sums: a relative error
///           below ε (nx + ny) in Sa and Sq, independent of the offset.
/// Cost      two passes over the data. GSL's recurrences need a division per point and moment; a test
///           compares the results.
#pragma once

#include <string_view>

#include "core/field.hpp"

namespace asperity {

/// In the unit of the field; ssk and sku are pure numbers.
struct Moments {
  double mean = 0;
  double sa = 0, sq = 0;
  double ssk = 0, sku = 0;
  double sp = 0, sv = 0;

  double sz() const { return sp + sv; }
};

/// Throws DataError(variable, …) if all heights are the same, or if Sq is below 1e-77 or heights are above
/// 1e77, whose fourth powers a double cannot hold.
Moments moments(const Field& z, std::string_view variable = "heights");

}  // namespace asperity
