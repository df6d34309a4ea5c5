/// Heights below which given shares of a surface lie, with their errors.
///
/// Errors of Gaussian heights follow from the correlation (stats/height/material_ratio.hpp), where it gives
/// them; others from the field's own long waves (stats/height/height_error.hpp). Intervals of Gaussian
/// heights q are about q/√(1 - w), w what the form took (stats/uncertainty/form_modes.hpp), and hold q.
#pragma once

#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"

namespace asperity {

/// What values are measured from: the mean of the field, as heights are, or 0, as a pressure and a gap.
enum class Origin { own_mean, zero };

/// Of the heights below which these shares of the surface lie; no errors where many heights are equal. With
/// the origin 0 they come from long waves always.
std::vector<Estimate> quantile_estimates(const Sample& sample, const std::vector<double>& shares,
                                         const std::vector<double>& heights,
                                         Origin origin = Origin::own_mean);

}  // namespace asperity
