/// Height parameters of a surface: ISO 25178-2's areal names beside the profile names of ISO 21920-2.
///
/// With heights d measured from the mean of all N points, the mean plane of order 0,
///     Ra (Sa)   = 1/N Σ |d|                 arithmetic mean height
///     Rq (Sq)   = √(1/N Σ d²)               root mean square height
///     Rsk (Ssk) = 1/N Σ d³ / Rq³            skewness
///     Rku (Sku) = 1/N Σ d⁴ / Rq⁴            kurtosis, 3 for a Gaussian surface
///     Rp (Sp), Rv (Sv), Rz (Sz) = Rp + Rv   highest peak, deepest valley, both ≥ 0, maximum height
/// All are population moments, of divisor N, over the whole field. A profile standard's Rp, Rv and Rz are
/// means over sampling lengths and therefore smaller; Ra, Rq, Rsk and Rku are those of all profiles taken
/// together.
///
/// Accuracy  Two passes about a shifted origin (stats/form.hpp), row sums added to row sums: a relative error
///           below ε (nx + ny) in Ra and Rq, whatever the offset.
/// Cost      two passes over the data, a small part of one transform. GSL's gsl_stats_* compute the same
///           numbers by recurrences in long double, a division per point and moment; a test compares the two.
#pragma once

#include <string_view>

#include "grid/field.hpp"

namespace asperity {

/// All in the unit of the field, rsk and rku pure numbers.
struct Moments {
  double mean = 0;
  double ra = 0, rq = 0;
  double rsk = 0, rku = 0;
  double rp = 0, rv = 0;

  double rz() const { return rp + rv; }
};

/// Throws DataError(variable, …) when every height is the same: skewness and kurtosis then have no value.
Moments moments(const Field& z, std::string_view variable = "heights");

}  // namespace asperity
