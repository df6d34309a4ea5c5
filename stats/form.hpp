/// The form of a surface, and what is left of the heights without it.
///
/// Heights are measured from a reference: the mean plane of order 0, z̄, or the plane a + b i + c j that fits
/// them best in least squares. On a full rectangular grid 1, i - ī and j - j̄ are orthogonal, so
///     b = Σ (i - ī) z / Σ (i - ī)²,   c = Σ (j - j̄) z / Σ (j - j̄)²                               (1)
/// are exact projections, with no system to solve.
///
/// Accuracy  The height z(0,0) is subtracted first, an exact operation where heights vary by less than a
///           factor of two: roughness of 1 nm on an offset of 1 m keeps all the digits that the heights hold.
/// Cost      two passes over the data.
#pragma once

#include "grid/field.hpp"

namespace asperity {

enum class Form { mean, plane };

/// The mean of the field.
double mean(const Field& z);

/// The heights above the reference.
Field without_form(const Field& z, Form form = Form::mean);

}  // namespace asperity
