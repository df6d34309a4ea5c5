/// Heights below which given shares of a surface lie, and shares above given heights, with their errors.
///
/// Errors of Gaussian heights follow from the correlation (stats/height/material_ratio.hpp), where it gives
/// them; their intervals are about q/√(1 - w), w the share of the variance that the form took
/// (stats/uncertainty/form_modes.hpp). Others come from the field's own long waves
/// (stats/height/height_error.hpp). What the form took of a height z is about w z, and the rest, of the
/// heights elsewhere, is nearly independent of z and Gaussian of the variance w (1 - w) σ²: it leaves heights
///     (1 - w) z + √(w (1 - w)) σ ξ,                                                                   (1)
/// whose quantiles differ from those of z by what skewed heights make of ξ too: a median moves towards the
/// mean. (1) is done once more to the field's quantiles at 400 shares; the interval is shifted back by as
/// much, and wider by the error of w. Intervals hold q. Shares have those of stats/height/distribution.hpp.
#pragma once

#include <string>
#include <vector>

#include "stats/measure/parameter.hpp"
#include "stats/measure/sample.hpp"

namespace asperity {

/// What values are measured from: the mean of the field, as heights are, or 0, as a pressure and a gap.
enum class Origin { own_mean, zero };

/// Why a height has no error with this share beyond it, on either side; "" where it may have one.
std::string few_beyond(const Sample& sample, double share);

/// Of the heights below which these shares of the surface lie; no errors where many heights are equal. With
/// the origin 0 they come from long waves always.
std::vector<Estimate> quantile_estimates(const Sample& sample, const std::vector<double>& shares,
                                         const std::vector<double>& heights,
                                         Origin origin = Origin::own_mean);

/// Smr(c) of stats/height/material_ratio.hpp, c above the mean.
Estimate share_above(const Sample& sample, const MaterialRatioCurve& curve, double c);

}  // namespace asperity
